#include "core/visibility/subject_shape.h"

#include <algorithm>
#include <cmath>

#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// Null: the snapshot has no group of this number.
const SnapshotNode* groupOf(const StructureSnapshot& snapshot, uint32_t number) {
    const auto is = [&](const SnapshotNode& node) { return node.isGroup() && node.number == number; };
    // Many strategies list their groups by number.
    if (number < snapshot.nodes.size() && is(snapshot.nodes[number])) return &snapshot.nodes[number];
    const auto found = std::ranges::find_if(snapshot.nodes, is);
    return found == snapshot.nodes.end() ? nullptr : &*found;
}

class ShapeMaker {
public:
    ShapeMaker(const Scene& scene, const FrameLog& log) : m_scene(scene), m_log(log) {}

    void addObject(uint32_t instance) {
        if (instance >= m_scene.instances().size()) return;
        m_shape.object = instance;
        m_shape.boxes.push_back(m_scene.instanceBox(instance));
    }

    void addNode(const StructureSnapshot& snapshot, const Decision& decision) {
        if (const SnapshotNode* found = groupOf(snapshot, decision.subject.number)) {
            m_shape.node = found->number;
            m_shape.boxes.push_back(found->box);
            return;
        }
        Box3 box;
        for (const uint32_t instance : m_log.objectsOf(decision)) box.add(m_scene.instanceBox(instance));
        if (decision.objectCount > 0) m_shape.boxes.push_back(box);
    }

    /// The triangles at its places.
    void addCell(const Decision& decision) {
        const uint32_t instance = decision.subject.object;
        if (instance >= m_scene.instances().size() || decision.places.count == 0) return addObject(instance);
        m_shape.object = instance;
        addPlaces(m_log.order.get(), instance, decision.places.first, decision.places.count);
        finish();
    }

    /// A part of a triangle: its own triangles, by their places among those that the frame draws next.
    void addFragment(const Decision& decision) {
        const OwnTrianglesPointer* own = next<OwnTrianglesPointer>(decision.commands);
        if (own == nullptr || decision.places.count == 0) return addObject(decision.subject.object);
        addOwn(**own, decision.places.first, decision.places.count);
        finish();
    }

    /// A rectangle of the picture: from its lower left to its upper right pixel, numbered row by row from the bottom.
    void addPixels(const Decision& decision) {
        if (decision.subject.object != Subject::kNoObject) addObject(decision.subject.object);
        const auto width = uint32_t(m_log.size.width);
        PlaceRun pixels = decision.places;
        // A row that is not shown yet.
        if (pixels.count == 0 && decision.subject.kind == Subject::Kind::Rows &&
            int64_t(decision.subject.number) < m_log.size.height)
            pixels = {decision.subject.number * width, width};
        if (pixels.count == 0 || width == 0) return;
        const uint32_t first = pixels.first, last = first + pixels.count - 1;
        m_shape.pixels = {{Vec2(first % width, first / width), Vec2(last % width + 1, last / width + 1)}};
        addSight((*m_shape.pixels)[0], (*m_shape.pixels)[1]);
    }

    /// What the strategy itself tells of the subject, in place of its object's box.
    void addPlace(const StructureSnapshot& snapshot, const Decision& decision, size_t number) {
        const uint32_t instance = decision.subject.object;
        const bool ofObject = instance < m_scene.instances().size();
        if (!snapshot.places || (!ofObject && decision.subject.kind != Subject::Kind::Rows)) return;
        std::optional<SubjectPlace> place = snapshot.places->at(m_scene, decision, number);
        if (!place) return;
        if (ofObject) m_shape.object = instance;
        if (m_shape.triangles.empty() && !place->lines.empty()) m_shape.boxes.clear();
        m_shape.lines = std::move(place->lines);
        m_shape.compared = std::move(place->compared);
        m_shape.mapLines = std::move(place->mapLines);
        m_shape.onCurve = place->onCurve;
        if (place->node) m_shape.node = place->node;
        if (!place->triangle || !ofObject) return;
        m_shape.triangle = m_scene.firstTriangle(instance) + *place->triangle;
        m_shape.triangles.push_back(InstanceFromEye(m_scene, instance, Vec3(0.0)).corners(*place->triangle));
    }

    void operator()(const DrawList& list) {
        for (const DrawRange& range : list.ranges) {
            if (list.standIn(m_scene.instances()[range.instance].mesh, range))
                addStandIns(list, range);
            else
                addPlaces(list.order.get(), range.instance, range.firstIndex / 3, range.indexCount / 3);
        }
        finish();
    }
    void operator()(const OwnTrianglesPointer& own) {
        addOwn(*own, 0, uint32_t(own->triangles.size()));
        finish();
    }
    void operator()(const FinishedPicturePointer&) {}
    void operator()(const AskedBoxes& asked) {
        for (const EyeBox& box : asked.boxes) {
            if (m_shape.boxes.size() == SubjectShape::kMostTriangles) return;
            const Vec3 centre = m_log.camera.eye + box.centre;
            m_shape.boxes.push_back({centre - box.halfExtent, centre + box.halfExtent});
        }
    }

    [[nodiscard]] SubjectShape take() { return std::move(m_shape); }

private:
    /// The next command of a type from a command on; null: there is none.
    template <typename Type>
    [[nodiscard]] const Type* next(size_t command) const {
        for (; command < m_log.commands.size(); ++command)
            if (const auto* found = std::get_if<Type>(&m_log.commands[command])) return found;
        return nullptr;
    }

    void addPlaces(const TriangleOrder* order, uint32_t instance, uint64_t first, uint64_t count) {
        const uint32_t mesh = m_scene.instances()[instance].mesh;
        const InstanceFromEye corners(m_scene, instance, Vec3(0.0));
        const uint64_t end = std::min<uint64_t>(first + count, m_scene.meshOf(instance).triangleCount());
        for (uint64_t place = first; place < end; ++place) {
            const uint64_t own = triangleAt(order, mesh, place);
            if (!m_shape.triangle) m_shape.triangle = m_scene.firstTriangle(instance) + own;
            add(corners.corners(own));
        }
    }

    void addStandIns(const DrawList& list, const DrawRange& range) {
        const TriangleMesh& mesh = m_scene.meshOf(range.instance);
        const Mat4& world = m_scene.instances()[range.instance].worldFromMesh;
        const std::span<const uint32_t> indices = list.orderOf(m_scene.instances()[range.instance].mesh).indices;
        if (!m_shape.triangle) m_shape.triangle = m_scene.firstTriangle(range.instance);
        for (size_t i = range.firstIndex; i < size_t(range.firstIndex) + range.indexCount; i += 3) {
            std::array<Vec3, 3> corners;
            for (size_t corner = 0; corner < 3; ++corner)
                corners[corner] = Vec3(world * Vec4(mesh.position(indices[i + corner]), 1.0));
            add(corners);
        }
    }

    /// The lines of sight through the corners of a rectangle of the picture, from the eye, to the end of the scene.
    void addSight(const Vec2& low, const Vec2& high) {
        const View view(m_log.camera, m_log.size);
        double far = m_log.camera.nearDistance;
        for (uint32_t instance = 0; instance < m_scene.instances().size(); ++instance) {
            const Sphere& sphere = m_scene.instanceSphere(instance);
            const double end = glm::dot(sphere.centre - view.eye(), view.frustum().forward) + sphere.radius;
            if (std::isfinite(end)) far = std::max(far, end);
        }
        far = std::min(far, m_log.camera.farDistance);
        std::vector<Vec3> end;
        for (const Vec2& corner : {low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}) {
            end.push_back(view.pointAt(corner.x, corner.y, far));
            m_shape.sight.push_back({view.pointAt(corner.x, corner.y, 0.0), end.back()});
        }
        end.push_back(end.front());
        m_shape.sight.push_back(std::move(end));
    }

    void addOwn(const OwnTriangles& own, uint64_t first, uint64_t count) {
        for (const OwnTriangles::Run& run : own.runs) {
            const Mat4& world = m_scene.instances()[run.instance].worldFromMesh;
            const Vec3 origin = m_scene.meshOf(run.instance).origin();
            for (uint64_t i = std::max<uint64_t>(first, run.first); i < std::min<uint64_t>(first + count, run.first + run.count);
                 ++i) {
                std::array<Vec3, 3> corners;
                for (size_t corner = 0; corner < 3; ++corner)
                    corners[corner] = Vec3(world * Vec4(origin + Vec3(own.positions[3 * i + corner]), 1.0));
                if (!m_shape.triangle) m_shape.triangle = own.triangles[i];
                m_shape.object = run.instance;
                add(corners);
            }
        }
    }

    void add(const std::array<Vec3, 3>& corners) {
        for (const Vec3& corner : corners) m_box.add(corner);
        ++m_count;
        if (m_shape.triangles.size() < SubjectShape::kMostTriangles) m_shape.triangles.push_back(corners);
    }

    void finish() {
        if (m_count <= SubjectShape::kMostTriangles) return;
        m_shape.triangles.clear();
        m_shape.boxes.push_back(m_box);
    }

    const Scene& m_scene;
    const FrameLog& m_log;
    SubjectShape m_shape;
    Box3 m_box;
    size_t m_count = 0;
};

}  // namespace

SubjectShape subjectShape(const Scene& scene, const FrameLog& log, const StructureSnapshot& snapshot, const FrameEntry& entry) {
    ShapeMaker maker(scene, log);
    if (entry.command != nullptr) {
        std::visit(maker, *entry.command);
        return maker.take();
    }
    const Decision& decision = *entry.decision;
    switch (decision.subject.kind) {
        case Subject::Kind::Object:
            maker.addObject(decision.subject.number);
            break;
        case Subject::Kind::Node:
            maker.addNode(snapshot, decision);
            break;
        case Subject::Kind::Ray:
        case Subject::Kind::Band:
            maker.addObject(decision.subject.object);
            break;
        case Subject::Kind::Cell:
        case Subject::Kind::Cells:
        case Subject::Kind::Triangles:
            maker.addCell(decision);
            break;
        case Subject::Kind::Fragment:
            maker.addFragment(decision);
            break;
        case Subject::Kind::Rows:
        case Subject::Kind::Span:
            maker.addPixels(decision);
            break;
    }
    maker.addPlace(snapshot, decision, entry.number);
    return maker.take();
}

EntryNames entryNames(const StructureSnapshot& snapshot, const FrameEntry& entry) {
    if (entry.decision == nullptr) return {};
    const Decision& decision = *entry.decision;
    EntryNames names = snapshot.places ? snapshot.places->names(snapshot, decision, entry.number) : EntryNames();
    if (names.subject.empty() && decision.subject.kind == Subject::Kind::Node)
        if (const SnapshotNode* node = groupOf(snapshot, decision.subject.number)) names.subject = node->name;
    return names;
}

}  // namespace cullscope
