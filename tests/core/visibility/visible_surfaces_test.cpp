// The lecture's six methods on the same random scenes, each beside OpenGL's depth buffer.

#include <map>

#include "core/scene/split_scene.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/picture_differences.h"
#include "tests/support/random_polygons.h"

namespace cullscope::test::visible_surfaces_test {
namespace {

constexpr Viewport kSize{160, 120};
constexpr std::array kKinds{"intersecting", "cyclic", "coplanar", "sharing-edges", "touching"};

using Settings = std::vector<std::pair<const char*, const char*>>;

struct Method {
    const char* id;
    Settings settings;
};

/// Each method with the parameters that change how it decides.
std::vector<Method> methods() {
    return {{"depth-buffer", {}},
            {"scan-line", {}},
            {"painter", {}},
            {"bsp", {{"plane", "first"}}},
            {"bsp", {{"plane", "fewest"}}},
            {"bsp", {{"plane", "balance"}, {"order", "front-to-back"}}},
            {"octree-query", {{"latency", "0"}}},
            {"octree-query", {{"latency", "0"}, {"batch", "1"}}},
            {"octree-query", {{"latency", "0"}, {"ask", "leaves"}, {"leaf", "3"}}}};
}

std::string nameOf(const Method& method) {
    std::string name = method.id;
    for (const auto& [key, value] : method.settings) name += std::string(" ") + key + "=" + value;
    return name;
}

/// What a frame shows at every pixel, as triangle numbers.
ShownPixels shownBy(const SceneBuffers& buffers, const View& view, const FrameLog& log) {
    Renderer::ItemBuffer items = GlEnvironment::renderer().drawItemBuffer(buffers, view, log, {0, 0, view.viewport()});
    return {std::move(items.depth), std::move(items.triangle)};
}

TEST(VisibleSurfaces, sixMethodsShowTheDepthBuffersPictureOfRandomScenes) {
    std::vector<std::pair<Method, CullerPointer>> built;
    for (const Method& method : methods()) {
        ParameterSet parameters(findStrategy(method.id).info.parameters);
        for (const auto& [key, value] : method.settings) parameters.setFromText(key, value);
        built.emplace_back(method, makeCuller(method.id, parameters));
    }
    struct Differing {
        uint64_t pixels = 0, unresolved = 0;
    };
    std::map<std::string, std::array<Differing, kMeetings>> differing;
    std::array<uint64_t, kMeetings> pixels{};
    for (uint64_t seed = 0; seed < howMany(200, 25); ++seed) {
        // In several objects, so that there is something to ask an octree about.
        const ScenePointer scene = splitScene(*randomPolygons(seed), "random", {SplitRule::By::Clusters, 6});
        const SceneBuffers buffers(scene, Upload::Vbo);
        const View view(aroundPolygons(seed), kSize);
        const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, view, Facing::TwoSided);
        const auto kind = size_t(meetingOf(seed));
        pixels[kind] += truth.triangle.size();
        for (const auto& [method, culler] : built) {
            SCOPED_TRACE(nameOf(method) + ", seed " + std::to_string(seed));
            culler->build(*scene);
            const Culled frame = culler->cull(view, Recording::Off, &GlEnvironment::renderer());
            const ShownPixels shown = shownBy(buffers, view, frame.log);
            const PictureDifferences found = pictureDifferences(*scene, view, truth, shown, frame.log);
            EXPECT_EQ(found.unexplained, 0u) << found.first;
            differing[nameOf(method)][kind].pixels += found.pixels;
            differing[nameOf(method)][kind].unresolved += found.unresolved;
            // Those that give the scene's own triangles to OpenGL have the same depths; of equal ones the first drawn stays.
            if (frame.log.drawsScene()) {
                EXPECT_EQ(shown.depth, truth.depth);
            }
        }
    }
    for (const auto& [name, kinds] : differing)
        for (size_t kind = 0; kind < kinds.size(); ++kind) {
            const double share = double(kinds[kind].pixels) / double(pixels[kind]);
            std::printf("long: visible-surfaces %s %s pixels %llu differing %llu (%.4f %%), of these unresolved %llu\n",
                        kKinds[kind], name.c_str(), static_cast<unsigned long long>(pixels[kind]),
                        static_cast<unsigned long long>(kinds[kind].pixels), 100.0 * share,
                        static_cast<unsigned long long>(kinds[kind].unresolved));
            // Those in software are compared with nothing excused: depths of triangles in one plane are equal to the bit.
            if (name != "depth-buffer" && name != "scan-line") continue;
            EXPECT_LE(share, 0.001) << name << ", " << kKinds[kind];
            EXPECT_EQ(kinds[kind].unresolved, 0u) << name << ", " << kKinds[kind];
        }
}

}  // namespace
}  // namespace cullscope::test::visible_surfaces_test
