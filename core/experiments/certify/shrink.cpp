#include "core/experiments/certify/shrink.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/gpu/gpu_frame.h"
#include "core/measure/accuracy.h"
#include "core/mesh/save.h"
#include "core/scene/drawn_sets.h"
#include "core/scene/scene_source.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::certify {
namespace {

constexpr size_t kMostTries = 3'000;

/// A scene of some of another one's objects.
ScenePointer withObjects(const Scene& scene, const std::vector<uint32_t>& kept) {
    std::vector<Instance> instances;
    for (const uint32_t i : kept) instances.push_back(scene.instances()[i]);
    return std::make_shared<Scene>(scene.name(), scene.meshes(), std::move(instances));
}

/// A scene of some of another one's triangles, by scene triangle number. Every object has a mesh of its own.
ScenePointer withTriangles(const Scene& scene, const std::vector<uint32_t>& kept) {
    std::vector<MeshPointer> meshes;
    std::vector<Instance> instances;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const TriangleMesh& mesh = scene.meshOf(i);
        TriangleMesh::Data data;
        data.name = mesh.name();
        data.origin = mesh.origin();
        std::vector<uint32_t> numbers(mesh.vertexCount(), ~0U);
        for (const uint32_t triangle : kept) {
            if (scene.instanceOf(triangle) != i) continue;
            for (uint32_t corner = 0; corner < 3; ++corner) {
                const uint32_t vertex = mesh.indices()[3 * (triangle - scene.firstTriangle(i)) + corner];
                if (numbers[vertex] == ~0U) {
                    numbers[vertex] = uint32_t(data.positions.size());
                    data.positions.push_back(mesh.positions()[vertex]);
                    data.normals.push_back(mesh.normals()[vertex]);
                }
                data.indices.push_back(numbers[vertex]);
            }
        }
        if (data.indices.empty()) continue;
        instances.push_back({uint32_t(meshes.size()), scene.instances()[i].worldFromMesh, scene.instances()[i].name});
        meshes.push_back(std::make_shared<TriangleMesh>(std::move(data)));
    }
    return std::make_shared<Scene>(scene.name(), std::move(meshes), std::move(instances));
}

/// A part of a parallel view's picture with the same pixels: `left` and `below` pixels lie beside it.
RandomView partOf(const RandomView& whole, int left, int below, const Viewport& size) {
    RandomView part = whole;
    part.viewport = size;
    Camera& camera = part.camera;
    const Frustum frustum = View(whole.camera, whole.viewport).frustum();
    const double pixel = camera.height / whole.viewport.height;
    camera.height = pixel * size.height;
    const Vec3 moved = pixel * ((left + (size.width - whole.viewport.width) / 2.0) * frustum.right +
                                (below + (size.height - whole.viewport.height) / 2.0) * frustum.up);
    camera.eye += moved;
    camera.target += moved;
    return part;
}

/// The same view in half the pixels across, upwards or both; and of a parallel one the halves of its picture.
std::vector<RandomView> smallerViews(const RandomView& view) {
    std::vector<RandomView> views;
    const auto [width, height] = view.viewport;
    for (const Viewport& size : {Viewport{width / 2, height / 2}, Viewport{width / 2, height}, Viewport{width, height / 2}}) {
        if (size.width < 1 || size.height < 1 || size == view.viewport) continue;
        views.push_back(view);
        views.back().viewport = size;
    }
    if (view.camera.projection == ProjectionKind::Perspective) return views;
    const int across = (width + 1) / 2, upwards = (height + 1) / 2;
    if (across < width)
        for (const int left : {0, width - across}) views.push_back(partOf(view, left, 0, {across, height}));
    if (upwards < height)
        for (const int below : {0, height - upwards}) views.push_back(partOf(view, 0, below, {width, upwards}));
    return views;
}

class Shrinking {
public:
    Shrinking(const StrategyRequest& strategy, Renderer& renderer, const Progress& progress)
        : m_strategy(strategy), m_renderer(renderer), m_progress(progress) {}

    [[nodiscard]] bool loses(const ScenePointer& scene, const RandomView& view) {
        m_progress.check();
        if (++m_tries > kMostTries || scene->triangleCount() == 0) return false;
        try {
            const Tried tried = tryView(m_strategy, scene, view, m_renderer);
            return tried.promised && tried.lost > 0;
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::Interrupted) throw;
            return false;
        }
    }

    /// Leaves out parts of a list, large ones first, as long as the rest still loses (delta debugging, Zeller & Hildebrandt
    /// 2002).
    template <typename Make>
    void leaveOut(Example& example, size_t count, const Make& make) {
        std::vector<uint32_t> kept(count);
        std::iota(kept.begin(), kept.end(), 0U);
        const ScenePointer whole = example.scene;
        for (size_t chunk = std::max<size_t>(1, count / 2);; chunk = std::max<size_t>(1, chunk / 2)) {
            bool less = false;
            for (size_t from = 0; from < kept.size() && kept.size() > 1;) {
                std::vector<uint32_t> rest(kept.begin(), kept.begin() + ptrdiff_t(from));
                rest.insert(rest.end(), kept.begin() + ptrdiff_t(std::min(from + chunk, kept.size())), kept.end());
                const ScenePointer scene = rest.empty() ? nullptr : make(*whole, rest);
                if (scene && loses(scene, example.view)) {
                    kept = std::move(rest);
                    example.scene = scene;
                    less = true;
                } else {
                    from += chunk;
                }
            }
            if (chunk == 1 && !less) return;
        }
    }

    void smallerPicture(Example& example) {
        for (bool less = true; less;) {
            less = false;
            for (const RandomView& smaller : smallerViews(example.view)) {
                if (!loses(example.scene, smaller)) continue;
                example.view = smaller;
                less = true;
                break;
            }
        }
    }

private:
    const StrategyRequest& m_strategy;
    Renderer& m_renderer;
    const Progress& m_progress;
    size_t m_tries = 0;
};

}  // namespace

Tried tryView(const StrategyRequest& request, const ScenePointer& scene, const RandomView& random, Renderer& renderer) {
    StructureStore structures;
    const BuiltStrategyPointer strategy = buildStrategy(strategyOf(request), request.parameters, scene, structures);
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(random.camera, random.viewport);
    Tried tried;
    tried.promised = strategy->promiseAt(view) != Promise::Approximate;
    GpuFrame frame(renderer, buffers, view);
    const ViewStatePointer state = strategy->begin();
    strategy->draw(frame, *state);
    const FrameLog log = frame.take();
    const Reference truth = itemBufferReference(renderer, buffers, view, strategy->referenceFacing());
    Framebuffer target(view.viewport());
    tried.lost = judge(renderer, buffers, log, truth, target).lostPixels();
    tried.covered = truth.coveredPixels;
    for (const auto& [first, end] : submittedIntervals(*scene, drawnTriangles(*scene, log)))
        for (uint64_t triangle = first; triangle < end; ++triangle) tried.drawn.push_back(uint32_t(triangle));
    return tried;
}

Example shrunk(const StrategyRequest& strategy, Example example, Renderer& renderer, const Progress& progress) {
    Shrinking shrinking(strategy, renderer, progress);
    shrinking.leaveOut(example, example.scene->instances().size(), withObjects);
    // As long as whole objects are lost: a single triangle may cover a pixel's centre in a picture of this size alone.
    shrinking.smallerPicture(example);
    shrinking.leaveOut(example, example.scene->triangleCount(), withTriangles);
    shrinking.smallerPicture(example);
    shrinking.leaveOut(example, example.scene->triangleCount(), withTriangles);
    return example;
}

bool writeExample(const std::filesystem::path& file, const StrategyRequest& strategy, const Example& example,
                  Renderer& renderer) {
    const auto named = [&](const char* ending) { return std::filesystem::path(file.string() + ending); };
    std::vector<PlacedMesh> placed;
    for (size_t i = 0; i < example.scene->instances().size(); ++i)
        placed.push_back({"object-" + std::to_string(i), &example.scene->meshOf(i), example.scene->instances()[i].worldFromMesh});
    saveMeshFile(named(".obj"), placed);
    ScenePointer read;
    Tried tried;
    try {
        read = openScene(named(".obj").string()).scene;
        tried = tryView(strategy, read, example.view, renderer);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Interrupted) throw;
        // A file may hold less than memory: triangles whose area its reader finds to be 0 are left out.
        tried = tryView(strategy, example.scene, example.view, renderer);
        tried.promised = false;
    }
    const Camera& camera = example.view.camera;
    const CameraPath path{"",
                          camera.fovy,
                          camera.nearDistance,
                          camera.farDistance,
                          camera.projection,
                          camera.height,
                          {{camera.eye, camera.target, camera.up}}};
    std::set<uint32_t> objects;
    const Scene& shown = read ? *read : *example.scene;
    for (const uint32_t triangle : tried.drawn) objects.insert(uint32_t(shown.instanceOf(triangle)));
    writeDrawnSets(named(".json"), {named(".obj").filename().string(),
                                    path,
                                    example.view.viewport,
                                    "auto",
                                    {{path.poses.front(), {objects.begin(), objects.end()}, rangesOf(tried.drawn)}}});
    return tried.promised && tried.lost > 0;
}

}  // namespace cullscope::certify
