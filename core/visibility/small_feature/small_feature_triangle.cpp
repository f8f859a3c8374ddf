#include "core/visibility/small_feature/small_feature_triangle.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::small_feature {
namespace {

constexpr const char* kTriangleThreshold = "threshold";

/// The lines of the listing (triangleListing).
enum class TriangleLine : uint8_t { Groups = 1, Outside, Inside, Objects, Triangles, Ratio, Draw };

constexpr OctreeWalkLines kTriangleLines{.groupPlanes = uint8_t(TriangleLine::Groups),
                                         .groupAxes = uint8_t(TriangleLine::Groups),
                                         .groupOutside = uint8_t(TriangleLine::Outside),
                                         .groupInside = uint8_t(TriangleLine::Inside),
                                         .objectTests = uint8_t(TriangleLine::Objects),
                                         .objectOutside = uint8_t(TriangleLine::Outside)};

constexpr size_t kBlock = 64;

/// Triangles of a mesh as a structure of arrays, so that a compiler tests several at a time: centroids relative to the mesh's
/// origin and the squares of half the longest edges. Those behind the mesh's last are large enough from everywhere.
struct alignas(64) TriangleBlock {
    std::array<float, kBlock> x{}, y{}, z{}, squaredValue{};
};

/// The triangles of a mesh and the bounds of what their tests can give.
struct MeshTriangles {
    std::vector<TriangleBlock> blocks;
    Sphere centroids;                      ///< a sphere around the centroids, relative to the mesh's origin
    double smallest = 0.0, largest = 0.0;  ///< half the longest edge of the smallest and the largest triangle
};

MeshTriangles trianglesOf(const TriangleMesh& mesh) {
    MeshTriangles result;
    const size_t count = mesh.triangleCount();
    result.blocks.resize((count + kBlock - 1) / kBlock);
    result.smallest = std::numeric_limits<double>::infinity();
    std::vector<Vec3f> centroids;
    centroids.reserve(count);
    for (size_t i = 0; i < result.blocks.size() * kBlock; ++i) {
        TriangleBlock& block = result.blocks[i / kBlock];
        if (i >= count) {
            block.squaredValue[i % kBlock] = std::numeric_limits<float>::infinity();
            continue;
        }
        std::array<Vec3, 3> corners;
        for (size_t c = 0; c < 3; ++c) corners[c] = Vec3(mesh.positions()[mesh.indices()[3 * i + c]]);
        double longest = 0.0;
        for (size_t c = 0; c < 3; ++c) longest = std::max(longest, glm::length(corners[(c + 1) % 3] - corners[c]));
        const Vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
        centroids.emplace_back(centroid);
        block.x[i % kBlock] = float(centroid.x);
        block.y[i % kBlock] = float(centroid.y);
        block.z[i % kBlock] = float(centroid.z);
        block.squaredValue[i % kBlock] = float(longest * longest / 4.0);
        result.smallest = std::min(result.smallest, longest / 2.0);
        result.largest = std::max(result.largest, longest / 2.0);
    }
    result.centroids = boundingSphere(centroids);
    return result;
}

/// By triangle of a block: 1 where it is large enough, value² ≥ (threshold · distance)². Returns how many are.
uint32_t largeEnough(const TriangleBlock& block, const std::array<float, 3>& eye, float squaredThreshold,
                     std::array<uint8_t, kBlock>& large) {
    std::array<uint32_t, kBlock> found;
    for (size_t i = 0; i < kBlock; ++i) {
        const float x = block.x[i] - eye[0], y = block.y[i] - eye[1], z = block.z[i] - eye[2];
        found[i] = uint32_t(block.squaredValue[i] >= squaredThreshold * (x * x + y * y + z * z));
    }
    uint32_t count = 0;
    for (size_t i = 0; i < kBlock; ++i) count += found[i];
    for (size_t i = 0; i < kBlock; ++i) large[i] = uint8_t(found[i]);
    return count;
}

struct TestedTriangles : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    std::vector<MeshTriangles> meshes;  ///< by Scene::meshes()
};

struct TriangleGroupMemory : ViewState {
    LastFailedPlanes planes;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<TriangleGroupMemory>(*this); }
};

/// What of an object is too small.
struct TooSmall {
    uint64_t triangles = 0;
    /// Where all its triangles were decided at once: a bound of their ratios, the least or the largest one.
    std::optional<double> together;
};

/// The tests of one object's triangles.
class ObjectTriangles {
public:
    ObjectTriangles(const FrameContext& frame, const TestedTriangles& tested, double threshold)
        : m_scene(frame.scene()), m_eye(frame.view().eye()), m_tested(tested), m_threshold(threshold) {}

    /// Appends the ranges of the triangles that are large enough.
    TooSmall appendLarge(uint32_t instance, std::vector<DrawRange>& ranges) const {
        const Instance& object = m_scene.instances()[instance];
        const MeshTriangles& triangles = m_tested.meshes[object.mesh];
        const uint64_t count = m_scene.meshOf(instance).triangleCount();
        // In the mesh's coordinates: where the transform scales, values and distances are smaller by the same factor.
        const Vec3 eye = Vec3(glm::inverse(object.worldFromMesh) * Vec4(m_eye, 1.0)) - m_scene.meshOf(instance).origin();
        // What is decided for all triangles at once.
        const double distance = glm::length(triangles.centroids.centre - eye), reach = triangles.centroids.radius;
        if (triangles.smallest >= m_threshold * (distance + reach) * kSure) {
            ranges.push_back({instance, 0, uint32_t(3 * count)});
            return {0, triangles.smallest / (distance + reach)};
        }
        if (triangles.largest * kSure < m_threshold * (distance - reach)) return {count, triangles.largest / (distance - reach)};
        return {count - appendTested(instance, triangles, eye, ranges), {}};
    }

private:
    /// Above the rounding of the single tests: the shortcuts decide as these do.
    static constexpr double kSure = 1.0 + 0x1p-12;

    uint64_t appendTested(uint32_t instance, const MeshTriangles& triangles, const Vec3& eye,
                          std::vector<DrawRange>& ranges) const {
        const TriangleMesh& mesh = m_scene.meshOf(instance);
        const std::array<float, 3> place{float(eye.x), float(eye.y), float(eye.z)};
        const auto squared = float(m_threshold * m_threshold);
        std::array<uint8_t, kBlock> large;
        uint64_t drawn = 0;
        const auto count = uint32_t(mesh.triangleCount());
        const auto append = [&](uint32_t first, uint32_t number) {
            if (!ranges.empty() && ranges.back().instance == instance &&
                ranges.back().firstIndex + ranges.back().indexCount == 3 * first)
                ranges.back().indexCount += 3 * number;
            else
                ranges.push_back({instance, 3 * first, 3 * number});
            drawn += number;
        };
        for (uint32_t b = 0; b < triangles.blocks.size(); ++b) {
            const uint32_t first = b * uint32_t(kBlock), inBlock = std::min(uint32_t(kBlock), count - first);
            const uint32_t found = largeEnough(triangles.blocks[b], place, squared, large);
            if (found == 0) continue;
            if (found == kBlock) {
                append(first, inBlock);
                continue;
            }
            for (uint32_t i = 0; i < inBlock;) {
                uint32_t end = i;
                while (end < inBlock && large[end] != 0) ++end;
                if (end > i) append(first + i, end - i);
                i = end + 1;
            }
        }
        return drawn;
    }

    const Scene& m_scene;
    Vec3 m_eye;
    const TestedTriangles& m_tested;
    double m_threshold;
};

class SmallFeatureTriangle final : public StrategyWith<TestedTriangles, TriangleGroupMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        auto memory = std::make_unique<TriangleGroupMemory>();
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), structure.scene().instances().size());
        return memory;
    }

protected:
    void fill(TestedTriangles& tested, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        const Scene& scene = tested.scene();
        tested.octree = InstanceOctree(scene);
        tested.report.bytes = tested.octree.bytes();
        const std::vector<bool> shown = scene.shownMeshes();
        for (size_t i = 0; i < scene.meshes().size(); ++i) {
            progress.check();
            tested.meshes.push_back(shown[i] ? trianglesOf(*scene.meshes()[i]) : MeshTriangles());
            tested.report.bytes += tested.meshes.back().blocks.size() * sizeof(TriangleBlock);
        }
        tested.report.figures = {{"objects", double(scene.instances().size())}, {"nodes", double(tested.octree.nodes().size())}};
    }

    void decide(FrameContext& frame, const TestedTriangles& tested, TriangleGroupMemory& memory,
                const ParameterSet& parameters) const override {
        OctreeWalkCounters walked;
        std::vector<KeptObject> kept;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("groups of objects"));
            kept = keptObjects(tested.octree, frame, &walked,
                               {.refine = true, .memory = &memory.planes, .lines = kTriangleLines, .visited = {}});
        }
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("triangles"));
            sortNearestFirst(kept, frame.scene(), frame.view().eye());
            frame.counters().culledTriangles[size_t(Cause::TooSmall)] =
                appendLarge(frame, tested, kept, parameters.real(kTriangleThreshold), list.ranges);
        }
        FrameCounters& counted = frame.counters();
        counted.culledTriangles[size_t(Cause::OutsideFrustum)] = walked.trianglesCulled;
        counted.nodesVisited = walked.nodesVisited + walked.objectsTested;
        counted.figures.push_back({"plane_tests", double(walked.planesTested)});
        frame.draw(std::move(list));
    }

    [[nodiscard]] Promise promiseOf(const TestedTriangles& /*tested*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const TestedTriangles& tested, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, tested.scene());
        addGroups(result, tested.octree, tested.scene(), log);
        result.objectSentence =
            CULLSCOPE_TR("The object \"%1\" is tested as one box, then each of its %2 triangles by its size.");
        return result;
    }

private:
    /// Tests the objects' triangles on every core. Says what became of each object where the frame records. Returns the number of
    /// triangles that are too small.
    static uint64_t appendLarge(FrameContext& frame, const TestedTriangles& tested, std::span<const KeptObject> kept,
                                double threshold, std::vector<DrawRange>& ranges) {
        constexpr size_t kObjects = 64;
        struct Part {
            std::vector<DrawRange> ranges;
            std::vector<TooSmall> left;  ///< out, by object
        };
        std::vector<Part> parts((kept.size() + kObjects - 1) / kObjects);
        const ObjectTriangles objects(frame, tested, threshold);
        tbb::parallel_for(size_t{0}, parts.size(), [&](size_t i) {
            for (size_t k = i * kObjects; k < std::min(kept.size(), (i + 1) * kObjects); ++k)
                parts[i].left.push_back(objects.appendLarge(kept[k].instance, parts[i].ranges));
        });
        uint64_t left = 0;
        size_t drawn = 0;
        for (const Part& part : parts) drawn += part.ranges.size();
        ranges.reserve(drawn);
        for (size_t i = 0; i < parts.size(); ++i) {
            ranges.insert(ranges.end(), parts[i].ranges.begin(), parts[i].ranges.end());
            for (size_t k = 0; k < parts[i].left.size(); ++k) {
                left += parts[i].left[k].triangles;
                if (frame.recording()) say(frame, kept[i * kObjects + k].instance, parts[i].left[k], threshold);
            }
        }
        return left;
    }

    static void say(FrameContext& frame, uint32_t instance, const TooSmall& small, double threshold) {
        const uint64_t count = frame.scene().meshOf(instance).triangleCount(), left = small.triangles;
        Decision test;
        test.subject = Subject::ofObject(instance);
        test.cause = Cause::TooSmall;
        test.containment = left == 0 ? Containment::Inside : left == count ? Containment::Outside : Containment::Straddles;
        test.sentence =
            !small.together ? CULLSCOPE_TR("Of %1 triangles %2 have half a longest edge below %3 of their distance: too small.")
            : left == 0     ? CULLSCOPE_TR(
                                  "Its %1 triangles are decided together: the least ratio that any of them can have is %2, no less "
                                      "than %3.")
                        : CULLSCOPE_TR(
                              "Its %1 triangles are decided together: the largest ratio that any of them can have is %2, below "
                              "%3: too small.");
        test.operands = {double(count), small.together.value_or(double(left)), threshold};
        test.operandCount = 3;
        frame.say(atLine(TriangleLine::Ratio, test));
        const auto outcome = left == 0       ? Decision::Outcome::Drawn
                             : left == count ? Decision::Outcome::Culled
                                             : Decision::Outcome::PartlyDrawn;
        frame.say(atLine(TriangleLine::Draw, ending(test.subject, outcome, Cause::TooSmall)));
    }
};

Show triangleListing() {
    return listingShow({{CULLSCOPE_TR("for each group: planes and axes"), 0},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("inside: keep all its objects"), 1},
                        {CULLSCOPE_TR("else its parts, then each object"), 1},
                        {CULLSCOPE_TR("for each triangle of those kept"), 0},
                        {CULLSCOPE_TR("t = ½ longest edge ÷ distance"), 1},
                        {CULLSCOPE_TR("draw those with t ≥ threshold"), 0}});
}

}  // namespace

RegisteredStrategy smallFeatureTriangle() {
    const auto threshold = bySize({kTriangleThreshold,
                                   ParameterType::Real,
                                   0.002,
                                   0.0,
                                   1.0,
                                   "",
                                   CULLSCOPE_TR("A triangle is left out where half its longest edge, divided by its distance, "
                                                "is below this."),
                                   {}},
                                  1e-4);
    StrategyInfo info{"small-feature-triangle",
                      CULLSCOPE_TR("Small-feature culling by triangle"),
                      CULLSCOPE_TR("Leaves out every triangle that is too small for its distance: the traditional way."),
                      "Du et al. 2017, its comparison",
                      {facingParameter(), threshold}};
    info.needsEyePoint = true;
    info.sweeps = {{kTriangleThreshold, {"0", "0.0005", "0.001", "0.002", "0.004", "0.008"}}};
    info.shows = {triangleListing(), treeShow()};
    return {std::move(info), std::make_shared<SmallFeatureTriangle>()};
}

}  // namespace cullscope::small_feature
