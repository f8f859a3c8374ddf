// Every strategy that is registered can be stepped with a listing, and no line of a listing is dead.

#include <set>

#include "core/mesh/parametric.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "tests/support/culler.h"
#include "tests/support/every_second_object.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_polygons.h"
#include "tests/support/spherical_scenes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::listing_lines_test {
namespace {

View lookingAt(const Vec3& eye, const Vec3& target, double degrees, double far = 60) {
    return {{eye, target, {0, 1, 0}, Angle::fromDegrees(degrees), 0.05, far}, {96, 72}};
}

/// Lines at which nothing is decided, with the reason. Each other line is reached.
struct WithoutDecision {
    const char* strategy;
    int line;
};
constexpr WithoutDecision kWithoutDecision[] = {
    // They go on with parts, about which the next decisions are.
    {"frustum-octree", 6},
    // They prepare what later lines compare with, or ask for all objects at once, which is a command.
    {"draw-distance", 1},
    {"depth-buffer", 1},
    {"frustum-select", 1},
    {"frustum-query", 1},
};

struct Shot {
    ScenePointer scene;
    std::vector<View> views;
};

/// Bodies before, beside and behind the eye, of few and of many triangles; bodies that hide each other; polygons that overlap in
/// depth in all ways. Those with few triangles come first: most lines are reached there.
std::vector<Shot> fixedShots() {
    std::vector<Shot> shots;
    const ScenePointer quiz = openScene("quiz").scene;
    shots.push_back({quiz, {View(overviewCamera(*quiz, 4.0 / 3.0), {96, 72})}});
    for (uint64_t seed = 0; seed < 2 * kMeetings; ++seed) {
        const ScenePointer polygons = randomPolygons(seed);
        shots.push_back({polygons, {View(overviewCamera(*polygons, 4.0 / 3.0), {96, 72})}});
    }
    // Specks: from far away groups of them, or each of them, cover few pixels or none.
    std::vector<Mat4> specks;
    for (int i = 0; i < 64; ++i)
        specks.push_back(translation({3.0 * (i % 4 - 1.5), 3.0 * (i / 4 % 4 - 1.5), 3.0 * (i / 16 - 1.5)}) *
                         scaling(Vec3(std::pow(10.0, -3.0 + i / 21.0))));
    shots.push_back({copiesOf(boxMesh(Vec3f(-0.5f), Vec3f(0.5f)), specks),
                     {lookingAt({1, 2, 15}, Vec3(0.0), 40), lookingAt({1, 2, 60}, Vec3(0.0), 40, 200),
                      lookingAt({1, 2, 400}, Vec3(0.0), 40, 1000), lookingAt({1, 2, 4000}, Vec3(0.0), 40, 9000)}});
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int z = 0; z < 6; ++z)
        for (int x = -4; x <= 4; ++x) {
            meshes.push_back(starMesh(uint64_t(x + 5), z % 3 == 0 ? 2500 : 100));
            places.push_back(translation({4.0 * x, 0.3 * x, 12.0 - 6.0 * z}));
        }
    meshes.push_back(squareMesh(2.0f, 0.0f));
    places.push_back(translation({0, 0, -4}));
    const ScenePointer rows = sceneOf(std::move(meshes), places);
    shots.push_back({rows,
                     {lookingAt(Vec3(0.0), {0.2, 0.1, -1}, 40), lookingAt({0, 0, 30}, Vec3(0.0), 60),
                      lookingAt(Vec3(0.0), {0.2, 0.1, -1}, 40, 10), lookingAt({0.2, -1.0, 13.0}, {0, 0, -1}, 50),
                      lookingAt({0, 0, 130}, Vec3(0.0), 30, 300)}});
    const ScenePointer bumps = sceneOf({bumpyMesh(3, 40'000, 0.4)});
    shots.push_back({bumps, {lookingAt({0, 0.3, 6.0}, Vec3(0.0), 60), lookingAt({0, 0.3, 2.0}, Vec3(0.0), 20)}});
    // A closed plate in the middle hides one of two bodies from places in the scene's own box.
    const ScenePointer plate = sceneOf(
        {boxMesh({-4, -4, -0.5f}, {4, 4, 0.5f}), boxMesh({-1, -1, -4}, {1, 1, -3.5f}), boxMesh({-1, -1, 3.5f}, {1, 1, 4})});
    shots.push_back({plate, {lookingAt({0, 0, 2.6}, {0, 0.1, -1}, 60)}});
    return shots;
}

/// Whether decisions fall at a line, or, where it opens a block, within the block.
bool isReached(const std::vector<ListingLine>& lines, size_t line, const std::set<int>& reached) {
    if (reached.contains(int(line) + 1)) return true;
    for (size_t inner = line + 1; inner < lines.size() && lines[inner].indentation > lines[line].indentation; ++inner)
        if (reached.contains(int(inner) + 1)) return true;
    return false;
}

/// Whether a line, from 0, is one of kWithoutDecision.
bool isExempt(const StrategyInfo& info, size_t line) {
    return std::ranges::any_of(kWithoutDecision,
                               [&](const WithoutDecision& one) { return one.strategy == info.id && one.line == int(line) + 1; });
}

/// The lines at which decisions of recorded frames fell, from 1: of two frames of each view, with the sides of triangles that
/// the strategy draws by itself and with front sides alone. Ends with the view by which all lines are reached; where some are
/// exempt, never, or, with small samples, with the view by which all others are.
std::set<int> linesReached(const RegisteredStrategy& strategy, const std::vector<ListingLine>& lines,
                           const std::vector<Shot>& shots) {
    std::set<int> reached;
    for (const Shot& shot : shots) {
        const EverySecondObject sets(*shot.scene);
        ParameterSet front = sets.parametersOf(strategy.info);
        const bool sided = std::ranges::any_of(strategy.info.parameters, [](const auto& one) { return one.key == "facing"; });
        if (sided) front.setFromText("facing", "front");
        Culler culler(strategy, front);
        culler.build(*shot.scene);
        for (const View& view : shot.views) {
            for (int frame = 0; frame < 2; ++frame)
                for (const Decision& decision : culler.cull(view, Recording::On, &GlEnvironment::renderer()).log.decisions)
                    reached.insert(decision.line);
            size_t line = 0;
            while (line < lines.size() && (isReached(lines, line, reached) || (fewSamples() && isExempt(strategy.info, line))))
                ++line;
            if (line == lines.size()) return reached;
        }
    }
    return reached;
}

TEST(ListingLines, everyRegisteredStrategyHasAListing) {
    for (const RegisteredStrategy& strategy : strategies())
        EXPECT_NE(strategy.info.first(Show::Kind::Listing), nullptr) << strategy.info.id;
}

TEST(ListingLines, everyLineIsReachedByADecision) {
    const std::vector<Shot> shots = fixedShots();
    for (const RegisteredStrategy& strategy : strategies()) {
        const Show* listing = strategy.info.first(Show::Kind::Listing);
        if (listing == nullptr || unavailable(strategy.info, GlEnvironment::info())) continue;
        const std::set<int> reached = linesReached(strategy, listing->lines, shots);
        for (size_t line = 0; line < listing->lines.size(); ++line)
            EXPECT_NE(isReached(listing->lines, line, reached), isExempt(strategy.info, line))
                << strategy.info.id << " line " << line + 1 << ", \"" << listing->lines[line].text
                << "\": no decision falls there, or one does at a line that is listed as without";
    }
}

}  // namespace
}  // namespace cullscope::test::listing_lines_test
