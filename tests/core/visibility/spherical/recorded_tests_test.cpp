// What a recorded frame of the spherical strategies says of the tests of rays, bands and cells, and replays of a part of it.

#include "core/visibility/spherical/recorded_tests.h"

#include <map>
#include <numeric>
#include <set>

#include "core/frame/cell_map.h"
#include "core/frame/decided_ahead.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/visible_region.h"
#include "core/visibility/triangle_states.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::recorded_tests_test {
namespace {

ScenePointer star() { return sceneOf({starMesh(7, 8'000)}, {Mat4(1.0)}); }

View from(double distance, double degrees) {
    return {{Vec3(0.0, 0.3, distance), Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(degrees), 0.05, 60}, {160, 120}};
}

Culled recorded(const char* id, const Scene& scene, const View& view) {
    const CullerPointer culler = makeCuller(id);
    culler->build(scene);
    return culler->cull(view, Recording::On);
}

size_t count(const FrameLog& log, Subject::Kind kind, Decision::Outcome outcome) {
    return size_t(std::ranges::count_if(
        log.decisions, [&](const Decision& decision) { return decision.subject.kind == kind && decision.outcome == outcome; }));
}

/// Views around a body with bumps high enough that they hide each other.
std::vector<Culled> aroundBumps() {
    const ScenePointer scene = sceneOf({bumpyMesh(3, 40'000, 0.4)}, {Mat4(1.0)});
    const CullerPointer culler = strategyWith("spherical-lossless", {{"level", "8"}});
    culler->build(*scene);
    std::vector<Culled> frames;
    Random random(5);
    for (int i = 0; i < 6; ++i) {
        const Vec3 eye = (2.0 + i) * random.direction();
        frames.push_back(culler->cull(
            View({eye, 0.3 * random.direction(), {0, 0, 1}, Angle::fromDegrees(25), 0.05, 60}, {320, 240}), Recording::On));
    }
    return frames;
}

TEST(RecordedTests, cellThatIsLeftOutHasTheTestThatLeftItOutBeforeIt) {
    std::map<Cause, size_t> causes;
    for (const Culled& frame : aroundBumps()) {
        for (size_t i = 1; i < frame.log.decisions.size(); ++i) {
            const Decision& decision = frame.log.decisions[i];
            if (decision.subject.kind != Subject::Kind::Cell || decision.outcome != Decision::Outcome::Culled) continue;
            ++causes[decision.cause];
            const Decision& test = frame.log.decisions[i - 1];
            ASSERT_EQ(test.subject, decision.subject);
            EXPECT_EQ(test.containment, Containment::Outside);
            EXPECT_GE(test.operandCount, 2);
            if (decision.cause == Cause::OutsideFrustum) {
                ASSERT_TRUE(test.plane.has_value());
                EXPECT_LT(test.distance(), -test.margin());
            } else if (decision.cause == Cause::BackFacing) {
                EXPECT_GT(test.operands[0], test.operands[1]);
            } else {
                EXPECT_LT(test.operands[0], test.operands[1]) << "the horizon is higher";
            }
        }
    }
    EXPECT_GT(causes[Cause::OutsideFrustum], 20u);
    EXPECT_GT(causes[Cause::BackFacing], 20u);
    EXPECT_GT(causes[Cause::Hidden], 0u);
}

TEST(RecordedTests, resultOfAWalkIsTheLastThatWasSaidOfItsCells) {
    size_t afterAll = 0;
    for (const Culled& frame : aroundBumps()) {
        afterAll += count(frame.log, Subject::Kind::Cell, Decision::Outcome::DrawnAfterAll);
        std::map<uint32_t, Decision> last;
        for (const Decision& decision : frame.log.decisions)
            if (decision.subject.kind == Subject::Kind::Cell && decision.outcome != Decision::Outcome::Open)
                last[decision.subject.number] = decision;
        uint64_t drawn = 0, culled = 0;
        for (const auto& [cell, decision] : last)
            (decision.outcome == Decision::Outcome::Culled ? culled : drawn) += decision.places.count;
        EXPECT_EQ(drawn, frame.consideredTriangles);
        EXPECT_EQ(culled, std::accumulate(frame.culledTriangles.begin(), frame.culledTriangles.end(), uint64_t{0}));
    }
    EXPECT_GT(afterAll, 0u) << "no gap was small enough to be drawn";
}

TEST(RecordedTests, cellsOfManyObjectsHaveResultsAlone) {
    std::vector<Mat4> places;
    for (size_t i = 0; i <= kMostWithTests; ++i) places.push_back(translation({3.0 * double(i % 9), 3.0 * double(i / 9), 0}));
    const std::vector<MeshPointer> meshes(places.size(), starMesh(7, 2'000));
    const ScenePointer scene = sceneOf(meshes, places);
    const View view({{12.0, 12.0, 40.0}, {12.0, 12.0, 0.0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {160, 120});
    const Culled frame = recorded("spherical-lossless", *scene, view);
    EXPECT_EQ(count(frame.log, Subject::Kind::Cell, Decision::Outcome::Open), 0u);
    EXPECT_GT(count(frame.log, Subject::Kind::Cell, Decision::Outcome::Culled), 0u);
    EXPECT_EQ(count(recorded("spherical", *scene, view).log, Subject::Kind::Band, Decision::Outcome::Open), 0u);
}

TEST(RecordedTests, areSaidWhileTheyAreMade) {
    const SphericalMaps maps(starMesh(7, 8'000), SphericalGrid());
    const Ray ray{{3.0, 0.2, 0.1}, {-1.0, 0.05, 0.0}};
    // A search that is left after its third cell has said three of them.
    size_t cells = 0;
    const auto leave = [&](const WalkedCell&) {
        if (++cells == 3) throw std::runtime_error("enough");
    };
    EXPECT_THROW((void)searchTriangle(maps, ray, leave), std::runtime_error);
    EXPECT_EQ(cells, 3u);
    // Each part of a decision says its own tests: nothing is left to say after it.
    const auto tests = [](const auto& make) {
        ObjectRecord record(0, true);
        Decision first;
        first.subject = record.subject();
        record.say(first);
        make(record);
        const ScenePointer scene = star();
        FrameContext frame(*scene, from(6.0, 60.0), true);
        record.sayTo(frame);
        return frame.said() - 1;
    };
    size_t walked = 0;
    const size_t ofRay = tests([&](ObjectRecord& record) {
        walked = followCorner(maps, ray, 1, spherical::RayStart::Sphere, &record).walkedCells.size();
    });
    EXPECT_GT(walked, 3u);
    EXPECT_EQ(ofRay, walked + 2) << "its entry, every cell, and what it found";
    const size_t ofBands = tests([&](ObjectRecord& record) {
        spherical::ContourBands bands = spherical::makeBands({3, 0, 0}, 0.1, 8);
        (void)drawnByS(spherical::BandCells(maps), bands, spherical::Cut::ForGood, &record);
    });
    EXPECT_GT(ofBands, 100u) << "sectors";
}

TEST(RecordedTests, bandsAreSaidSectorBySectorFromTheNearPointOn) {
    const ScenePointer scene = star();
    const Culled frame = recorded("spherical", *scene, from(6.0, 60.0));
    const auto sectors = uint32_t(ParameterSet(findStrategy("spherical").info.parameters).integer("sectors"));
    size_t hidden = 0, said = 0;
    uint32_t sector = 0, band = 0;
    double largest = 0.0;  // in this sector
    std::set<uint32_t> done;
    for (const Decision& decision : frame.log.decisions) {
        if (decision.subject.kind != Subject::Kind::Band) continue;
        if (decision.subject.number % sectors != sector || said == 0) {
            sector = decision.subject.number % sectors;
            EXPECT_TRUE(done.insert(sector).second) << "a sector is left once";
            largest = 0.0;
            band = 0;
        }
        EXPECT_GE(decision.subject.number / sectors, band) << "from near to far";
        band = decision.subject.number / sectors;
        EXPECT_EQ(decision.operands[1], largest) << "the largest before it in its sector";
        EXPECT_EQ(decision.operands[3], sector + 1.0);
        largest = std::max(largest, decision.operands[0]);
        hidden += decision.containment == Containment::Outside ? 1 : 0;
        ++said;
    }
    EXPECT_EQ(done.size(), sectors);
    EXPECT_GT(hidden, 0u);
}

TEST(RecordedTests, raysAreFollowedCellByCellThenComeRegionBoxesAndRanges) {
    const ScenePointer scene = star();
    const Culled frame = recorded("spherical", *scene, from(2.0, 20.0));
    const spherical::SphericalDecision decision = spherical::decisionsOf(frame.log).front();
    ASSERT_TRUE(decision.region);
    std::string order;  // what follows what
    size_t walked = 0, hits = 0;
    uint64_t drawn = 0;
    for (const Decision& said : frame.log.decisions) {
        const char kind = said.plane                                              ? 'p'
                          : said.subject.kind == Subject::Kind::Ray               ? 'r'
                          : said.subject.kind == Subject::Kind::Cell              ? 'c'
                          : said.subject.kind != Subject::Kind::Cells             ? 'o'
                          : said.outcome == Decision::Outcome::Drawn              ? 'd'
                          : said.subject.number == spherical::CellGroups::kRegion ? 'g'
                                                                                  : 'b';
        if (order.empty() || order.back() != kind) order += kind;
        if (kind == 'c') {
            const auto& ray = decision.rays.at(size_t(said.operands[0]) - 1);
            const auto same = [&](const WalkedCell& cell) { return cell.hit == (said.containment == Containment::Inside); };
            EXPECT_TRUE(std::ranges::any_of(ray.walkedCells, same));
            hits += said.containment == Containment::Inside ? 1 : 0;
            ++walked;
        }
        if (kind == 'd') drawn += said.places.count;
        if (kind == 'g') {
            EXPECT_EQ(said.operands[0], frame.caseNumber);
        }
        if (kind == 'g') {
            EXPECT_EQ(said.operands[2], double(frame.consideredTriangles));
        }
    }
    EXPECT_EQ(order, "prcrcrcrcrgbdo") << "planes, rays with their cells, region, boxes, ranges, the object";
    size_t expected = 0;
    for (const spherical::CornerRay& ray : decision.rays) expected += ray.walkedCells.size();
    EXPECT_EQ(walked, expected);
    EXPECT_GE(hits, size_t(std::ranges::count_if(decision.rays, [](const auto& ray) { return ray.hit.has_value(); })));
    EXPECT_GT(hits, 0u);
    EXPECT_EQ(drawn, frame.consideredTriangles);
}

TEST(RecordedTests, pictureGrowsRangeByRangeToThatOfTheFrame) {
    const ScenePointer scene = star();
    for (const double distance : {2.0, 6.0}) {
        // From beside the poles of the map: around a pole all rows are one range.
        const Vec3 eye(distance, 0.3, 0.1);
        const View view({eye, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(10.0 * distance), 0.05, 60}, {160, 120});
        const Culled frame = recorded("spherical", *scene, view);
        uint64_t before = 0;
        size_t growths = 0;
        for (size_t k = 0; k < frame.log.entries(); ++k) {
            const uint64_t ahead = decidedAhead(frame.log, k).triangleCount();
            EXPECT_GE(ahead, before);
            growths += ahead > before ? 1 : 0;
            before = ahead;
        }
        EXPECT_EQ(before, frame.consideredTriangles);
        EXPECT_GT(growths, 10u);
    }
}

TEST(RecordedTests, pictureAndMapGrowSectorBySectorWhereBandsDecide) {
    const ScenePointer scene = star();
    const View view({{6, 0.3, 0.1}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60.0), 0.05, 60}, {160, 120});
    const CullerPointer culler = makeCuller("spherical");
    culler->build(*scene);
    const Culled frame = culler->cull(view, Recording::On);
    const BuiltStrategy& strategy = *culler->built();
    uint64_t before = 0;
    size_t growths = 0, undecidedBefore = SIZE_MAX, sectors = 0;
    for (size_t k = 0; k < frame.log.entries(); ++k) {
        const uint64_t ahead = strategy.decidedAhead(frame.log, k).triangleCount();
        EXPECT_GE(ahead, before) << "step " << k;
        growths += ahead > before ? 1 : 0;
        before = ahead;
        if (k % 16 != 0) continue;
        const FrameLog part = frame.log.upTo(k);
        if (part.decisions.empty() || part.decisions.back().subject.kind != Subject::Kind::Band) continue;
        const CellMapPointer map = strategy.directionMap("index-map", part);
        ASSERT_TRUE(map);
        const auto& states = map->source->states();
        const auto undecided = size_t(std::ranges::count(states, std::optional(TriangleState::Undecided)));
        EXPECT_LE(undecided, undecidedBefore) << "step " << k;
        EXPECT_EQ(size_t(std::ranges::count(states, std::optional(TriangleState::Visible))) > 0, ahead > 0) << "step " << k;
        undecidedBefore = undecided;
        ++sectors;
    }
    EXPECT_EQ(before, frame.consideredTriangles);
    EXPECT_GT(growths, 100u);
    EXPECT_GT(sectors, 10u);
    const CellMapPointer whole = strategy.directionMap("index-map", frame.log);
    ASSERT_TRUE(whole);
    EXPECT_EQ(std::ranges::count(whole->source->states(), std::optional(TriangleState::Undecided)), 0);
}

TEST(RecordedTests, partOfALogKnowsNothingOfObjectsThatWereDecidedLater) {
    const ScenePointer scene = sceneOf({starMesh(7, 2'000), starMesh(8, 2'000), starMesh(9, 2'000)},
                                       {translation({-3, 0, 0}), translation({0, 0, 0}), translation({3, 0, 0})});
    const View view({{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {160, 120});
    for (const char* id : {"spherical", "spherical-horizon", "spherical-lossless"}) {
        SCOPED_TRACE(id);
        const CullerPointer culler = makeCuller(id);
        culler->build(*scene);
        const Culled frame = culler->cull(view, Recording::On);
        EXPECT_EQ(spherical::decisionsOf(frame.log.upTo(0)).size(), 0u);
        EXPECT_EQ(spherical::decisionsOf(frame.log).size(), 3u);
        size_t known = 0;
        const size_t entries = frame.log.entries(), stride = std::max<size_t>(entries / 200, 1);
        for (size_t k = 0; k < entries + stride; k += stride) {
            const size_t now = spherical::decisionsOf(frame.log.upTo(std::min(k, entries))).size();
            EXPECT_GE(now, known);
            known = now;
        }
        EXPECT_EQ(known, 3u);
    }
}

TEST(RecordedTests, statesOfTrianglesDoNotDependOnTheNumberOfDrawCommands) {
    const ScenePointer scene = star();
    const Culled frame = recorded("spherical-lossless", *scene, from(3.0, 30.0));
    const TriangleStates whole = triangleStates(*scene, frame.log, std::nullopt);
    FrameLog parted = frame.log;
    DrawList first = std::get<DrawList>(parted.commands.at(0)), second = first;
    const auto middle = std::ptrdiff_t(first.ranges.size() / 2);
    ASSERT_GT(middle, 0);
    first.ranges.erase(first.ranges.begin() + middle, first.ranges.end());
    second.ranges.erase(second.ranges.begin(), second.ranges.begin() + middle);
    parted.commands = {first, second};
    EXPECT_EQ(triangleStates(*scene, parted, std::nullopt).states, whole.states);
}

}  // namespace
}  // namespace cullscope::test::recorded_tests_test
