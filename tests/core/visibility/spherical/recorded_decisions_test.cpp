// What the shows of the spherical strategies are made of: read from the stream of decisions, as far as it has been said.
#include "core/visibility/spherical/recorded_decisions.h"

#include <map>
#include <numeric>

#include "core/frame/curve.h"
#include "core/visibility/spherical/index_map_words.h"
#include "core/visibility/spherical/map_details.h"
#include "core/visibility/spherical/object_space_view.h"
#include "core/visibility/spherical/recorded_tests.h"
#include "core/visibility/spherical/slope_horizon.h"
#include "core/visibility/why.h"
#include "tests/support/lossless_map.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::recorded_decisions_test {
namespace {

ScenePointer star() { return sceneOf({starMesh(7, 8'000)}, {Mat4(1.0)}); }

View from(double distance, double degrees) {
    return {{Vec3(0.0, 0.3, distance), Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(degrees), 0.05, 60}, {160, 120}};
}
View seenWhole() { return from(6.0, 60.0); }
View cut() { return from(2.0, 20.0); }

struct Recorded {
    CullerPointer culler;
    Culled frame;

    Recorded(const char* id, const Scene& scene, const View& view) : culler(makeCuller(id)) {
        culler->build(scene);
        frame = culler->cull(view, Recording::On);
    }
    [[nodiscard]] spherical::SphericalDecision decision(uint32_t instance = 0) const {
        return spherical::decisionsOf(frame.log).at(instance);
    }
    /// With what the strategy adds for its shows.
    [[nodiscard]] spherical::SphericalDecision shown(uint32_t instance = 0) const {
        return spherical::mapOf(culler->snapshot(frame.log), instance)->decision;
    }
};

/// The log without decisions of a kind, and without what hangs at them.
FrameLog without(const FrameLog& log, Subject::Kind kind) {
    FrameLog rest = log;
    rest.decisions.clear();
    rest.details.clear();
    for (size_t i = 0; i < log.decisions.size(); ++i) {
        if (log.decisions[i].subject.kind == kind) continue;
        for (const LoggedDetail& logged : log.details)
            if (logged.decision == i) rest.details.push_back({rest.decisions.size(), logged.detail});
        rest.decisions.push_back(log.decisions[i]);
    }
    return rest;
}

std::vector<Decision> about(const FrameLog& log, Subject::Kind kind) {
    std::vector<Decision> found;
    std::ranges::copy_if(log.decisions, std::back_inserter(found), [&](const Decision& d) { return d.subject.kind == kind; });
    return found;
}

TEST(RecordedDecisions, bandsAreThoseOfTheStreamAndThoseThatDecided) {
    const ScenePointer scene = star();
    const Recorded recorded("spherical", *scene, seenWhole());
    const spherical::SphericalDecision decision = recorded.decision();
    ASSERT_TRUE(decision.bands);
    // The same decision, made here.
    const spherical::MapSnapshot map = *spherical::mapOf(recorded.culler->snapshot(recorded.frame.log), 0);
    spherical::ContourBands own = spherical::makeBands(decision.eye, decision.bands->width, decision.bands->sectors);
    const std::vector<spherical::CellRun> drawn = drawnByS(spherical::BandCells(*map.maps), own, spherical::Cut::ForGood);
    EXPECT_EQ(decision.drawn, drawn);
    ASSERT_EQ(decision.bands->table.size(), own.table.size());
    size_t hidden = 0, empty = 0;
    for (size_t i = 0; i < own.table.size(); ++i) {
        EXPECT_EQ(decision.bands->table[i].size, own.table[i].size) << i;
        EXPECT_EQ(decision.bands->table[i].horizon, own.table[i].horizon) << i;
        EXPECT_EQ(decision.bands->table[i].drawn, own.table[i].drawn) << i;
        hidden += own.table[i].drawn ? 0 : 1;
        empty += own.table[i].size > 0.0 ? 0 : 1;
    }
    EXPECT_GT(hidden, 10u);
    EXPECT_GT(empty, 0u);
    // What the stream does not say is not shown.
    const spherical::SphericalDecision mute = spherical::decisionsOf(without(recorded.frame.log, Subject::Kind::Band)).at(0);
    for (const spherical::BandSector& entry : mute.bands->table) EXPECT_EQ(entry.size, 0.0);
}

TEST(RecordedDecisions, cellsThatAreDrawnAreThoseThatWereSaid) {
    const ScenePointer scene = star();
    for (const char* id : {"spherical", "spherical-horizon"}) {
        const bool slopes = std::string(id) == "spherical-horizon";
        for (const View& view : {seenWhole(), cut()}) {
            const Recorded recorded(id, *scene, view);
            const FrameLog& log = recorded.frame.log;
            EXPECT_EQ(recorded.decision().drawnTriangles, recorded.frame.consideredTriangles);
            const Subject::Kind kind = slopes ? Subject::Kind::Cell : Subject::Kind::Cells;
            if (about(log, kind).empty()) continue;  // drawn whole
            const spherical::SphericalDecision mute = spherical::decisionsOf(without(log, kind)).at(0);
            EXPECT_TRUE(mute.drawn.empty()) << id;
            EXPECT_EQ(mute.drawnTriangles, 0u) << id;
            // Of a part of the entries what was said until then.
            uint64_t said = 0;
            const FrameLog part = log.upTo(log.entries() - log.entries() / 20);
            for (const Decision& decision : about(part, kind))
                if (decision.outcome == Decision::Outcome::Drawn) said += decision.places.count;
            EXPECT_EQ(spherical::decisionsOf(part).at(0).drawnTriangles, said);
        }
    }
}

TEST(RecordedDecisions, whatASectorOfABandSaysIsWhatIsDrawnOfItsCells) {
    // Also of bands across 90°, where cells within 90° are drawn whatever their band's S says.
    const ScenePointer scene = sceneOf({bumpyMesh(3, 4'000, 0.5)}, {Mat4(1.0)});
    size_t partly = 0, hidden = 0;
    for (const char* width : {"3", "5", "7", "11", "13", "20", "25", "40", "45"}) {
        SCOPED_TRACE(width);
        const CullerPointer culler = strategyWith("spherical", {{"band", width}, {"sectors", "8"}});
        culler->build(*scene);
        Random random(7);
        for (int i = 0; i < 5; ++i) {
            const View view({5.0 * random.direction(), Vec3(0.0), {0, 0, 1}, Angle::fromDegrees(60), 0.05, 60}, {160, 120});
            const FrameLog log = culler->cull(view, Recording::On).log;
            const spherical::MapSnapshot map = *spherical::mapOf(culler->snapshot(log), 0);
            const spherical::ContourBands& bands = *map.decision.bands;
            std::map<uint32_t, Decision> said;
            for (const Decision& band : about(log, Subject::Kind::Band)) said[band.subject.number] = band;
            const std::vector<spherical::CellState> states = cellStates(map);
            for (uint32_t cell = 0; cell < states.size(); ++cell) {
                if (states[cell] == spherical::CellState::Empty) continue;
                const SphericalGrid& grid = map.maps->grid();
                const Vec3 middle = spherical::CellDirections(grid).middle(grid.cell(cell));
                const Vec2 angles = bands.anglesOf(middle);
                // The angles that decide have an error: cells at an edge may lie on its other side.
                const auto nearEdge = [](double part) { return std::abs(part - std::round(part)) < 0.02; };
                if (nearEdge(angles.x / bands.width) || nearEdge(angles.y / (2.0 * std::numbers::pi) * bands.sectors)) continue;
                const uint32_t number = bands.bandOf(angles.x) * bands.sectors + bands.sectorOf(angles.y);
                const bool isDrawn = states[cell] == spherical::CellState::Drawn;
                const bool isWithin = glm::dot(middle, bands.axis) >= 0.0;
                ASSERT_TRUE(said.contains(number));
                const Containment told = said.at(number).containment;
                EXPECT_EQ(isDrawn, told == Containment::Inside || (told == Containment::Straddles && isWithin))
                    << "view " << i << " sector " << number;
            }
            for (const auto& [number, band] : said) {
                partly += band.containment == Containment::Straddles ? 1 : 0;
                hidden += band.containment == Containment::Outside ? 1 : 0;
            }
        }
    }
    EXPECT_GT(partly, 10u) << "sectors across 90 degrees whose rest is hidden";
    EXPECT_GT(hidden, 100u);
}

TEST(RecordedDecisions, curveGrowsBandByBand) {
    const ScenePointer scene = star();
    const Recorded recorded("spherical", *scene, seenWhole());
    const FrameLog& log = recorded.frame.log;
    size_t known = 0, steps = 0;
    for (size_t k = 0; k <= log.entries(); k += 4) {
        const std::optional<Curve> curve = recorded.culler->built()->curve("band-sizes", log.upTo(k), 0, 0);
        if (!curve || curve->intervals.empty()) continue;
        const size_t now =
            size_t(std::ranges::count_if(curve->intervals, [](const CurveInterval& interval) { return !interval.empty; }));
        EXPECT_GE(now, known);
        steps += now > known ? 1 : 0;
        known = now;
    }
    EXPECT_GT(steps, 5u);
}

TEST(RecordedDecisions, raysAndRegionAreKnownWhenTheyWereSaid) {
    const ScenePointer scene = star();
    const Recorded recorded("spherical", *scene, cut());
    const FrameLog& log = recorded.frame.log;
    size_t rays = 0;
    std::optional<size_t> lastRay, region;
    for (size_t k = 0; k <= log.entries(); ++k) {
        const std::vector<spherical::SphericalDecision> decisions = spherical::decisionsOf(log.upTo(k));
        if (decisions.empty()) continue;
        const auto now =
            size_t(std::ranges::count_if(decisions.front().rays, [](const spherical::CornerRay& ray) { return ray.followed; }));
        EXPECT_TRUE(now == rays || now == rays + 1) << "one after the other";
        if (now > rays) lastRay = k;
        rays = now;
        if (!region && decisions.front().region) region = k;
    }
    EXPECT_EQ(rays, 4u);
    ASSERT_TRUE(region && lastRay);
    EXPECT_GT(*region, *lastRay);
    EXPECT_EQ(recorded.decision().region->caseNumber, recorded.frame.caseNumber);
    const spherical::SphericalDecision mute = spherical::decisionsOf(without(log, Subject::Kind::Ray)).front();
    for (const spherical::CornerRay& ray : mute.rays) EXPECT_FALSE(ray.followed);
}

TEST(RecordedDecisions, slopesAreTestedCellByCellAndTheBandsAreNoTests) {
    const ScenePointer scene = star();
    const Recorded recorded("spherical-horizon", *scene, seenWhole());
    const FrameLog& log = recorded.frame.log;
    for (const Decision& band : about(log, Subject::Kind::Band)) EXPECT_EQ(band.containment, Containment::Straddles);
    uint64_t drawn = 0, culled = 0, tested = 0;
    for (const Decision& cell : about(log, Subject::Kind::Cell)) {
        const bool hidden = cell.outcome == Decision::Outcome::Culled;
        (hidden ? culled : drawn) += cell.places.count;
        EXPECT_TRUE(hidden || cell.outcome == Decision::Outcome::Drawn);
        if (cell.operandCount == 0) continue;
        EXPECT_EQ(hidden, cell.operands[1] > cell.operands[0]) << "the horizon is higher";
        ++tested;
    }
    EXPECT_EQ(drawn, recorded.frame.consideredTriangles);
    EXPECT_EQ(culled, recorded.frame.culledTriangles[size_t(Cause::Hidden)]);
    EXPECT_GT(culled, 100u);
    EXPECT_GT(tested, 100u);
    // Sectors that are drawn in part are those of the cells that the stream says are drawn.
    const spherical::SphericalDecision shown = recorded.shown();
    const auto sectors = std::ranges::count_if(shown.bands->table, [](const auto& sector) { return sector.drawn; });
    EXPECT_GT(sectors, 10);
    EXPECT_LT(size_t(sectors), shown.bands->table.size());
    const size_t entries = log.entries() - about(log, Subject::Kind::Cell).size() / 2;
    const spherical::MapSnapshot* part = nullptr;
    const StructureSnapshot snapshot = recorded.culler->snapshot(log.upTo(entries));
    part = spherical::mapOf(snapshot, 0);
    ASSERT_NE(part, nullptr);
    EXPECT_LT(std::ranges::count_if(part->decision.bands->table, [](const auto& sector) { return sector.drawn; }), sectors);
}

TEST(RecordedDecisions, judgedCellsAreTheEndsThatTheStreamSays) {
    const ScenePointer scene = star();
    const Recorded recorded("spherical-lossless", *scene, from(2.5, 25.0));
    const FrameLog& log = recorded.frame.log;
    for (const size_t k : {log.entries() / 3, log.entries() / 2, log.entries()}) {
        const FrameLog part = log.upTo(k);
        std::map<uint32_t, Decision> ends;
        for (const Decision& cell : about(part, Subject::Kind::Cell))
            if (cell.outcome != Decision::Outcome::Open) ends[cell.subject.number] = cell;
        const spherical::SphericalDecision decision = spherical::decisionsOf(part).at(0);
        ASSERT_EQ(decision.walk->judged.size(), ends.size());
        uint64_t drawn = 0;
        for (const spherical::JudgedCell& judged : decision.walk->judged) {
            const Decision& end = ends.at(judged.node);
            EXPECT_EQ(judged.cause.has_value(), end.outcome == Decision::Outcome::Culled);
            EXPECT_EQ(judged.bridged, end.outcome == Decision::Outcome::DrawnAfterAll);
            drawn += judged.cause ? 0 : end.places.count;
        }
        EXPECT_EQ(decision.drawnTriangles, drawn);
    }
    EXPECT_EQ(recorded.decision().walk->culled, recorded.frame.culledTriangles);
    EXPECT_EQ(recorded.decision().drawnTriangles, recorded.frame.consideredTriangles);
}

TEST(RecordedDecisions, theLineUnderTheMapCountsTrianglesLeftOutOneByOne) {
    for (const size_t triangles : {2'000, 60'000}) {
        const LosslessMap drawn(starMesh(7, triangles), MapLayout::Octahedral, {0.0, 0.3, 4.0});
        const spherical::SphericalDecision& decision = drawn.map().decision;
        const Culled frame = drawn.strategy->cull(drawn.view);
        EXPECT_EQ(decision.leftOutAlone, frame.parts[3].culledTriangles);
        const auto& culled = decision.walk->culled;
        EXPECT_EQ(decision.leftOutAlone + decision.drawnTriangles + std::accumulate(culled.begin(), culled.end(), uint64_t{0}),
                  drawn.scene->triangleCount());
        EXPECT_EQ(decision.leftOutAlone > 0, triangles > 10'000) << "few have many pixels each";
        const std::vector<Words> lines = spherical::walkWords(drawn.map());
        EXPECT_EQ(
            std::ranges::any_of(lines, [](const Words& line) { return line.english().find("one by one") != std::string::npos; }),
            decision.leftOutAlone > 0);
    }
}

TEST(RecordedDecisions, objectsOfASceneWithManyHaveTheSameBandsAsOneAlone) {
    std::vector<Mat4> places;
    for (size_t i = 0; i <= kMostWithTests; ++i) places.push_back(translation({3.0 * double(i % 9), 3.0 * double(i / 9), 0}));
    const ScenePointer many = copiesOf(starMesh(7, 2'000), places), alone = copiesOf(starMesh(7, 2'000), {places.front()});
    const View view({{12.0, 12.0, 40.0}, {12.0, 12.0, 0.0}, {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, {160, 120});
    for (const char* id : {"spherical", "spherical-horizon"}) {
        SCOPED_TRACE(id);
        const spherical::SphericalDecision one = Recorded(id, *alone, view).shown();
        const spherical::SphericalDecision same = Recorded(id, *many, view).shown();
        ASSERT_TRUE(one.bands && same.bands);
        EXPECT_EQ(one.drawn, same.drawn);
        EXPECT_EQ(one.drawnTriangles, same.drawnTriangles);
        for (size_t i = 0; i < one.bands->table.size(); ++i) {
            if (!(one.bands->table[i].size > 0.0)) continue;
            EXPECT_EQ(one.bands->table[i].size, same.bands->table[i].size) << i;
            EXPECT_EQ(one.bands->table[i].horizon, same.bands->table[i].horizon) << i;
            EXPECT_EQ(one.bands->table[i].drawn, same.bands->table[i].drawn) << i;
        }
    }
}

TEST(RecordedDecisions, whySaysTheTestOfTheTrianglesCellWithItsNumbers) {
    const ScenePointer scene = star();
    for (const char* id : {"spherical-horizon", "spherical-lossless"}) {
        SCOPED_TRACE(id);
        const Recorded recorded(id, *scene, from(3.5, 30.0));
        const FrameLog& log = recorded.frame.log;
        size_t told = 0;
        for (uint32_t place = 0; place < scene->triangleCount(); place += 157) {
            const uint64_t triangle = triangleAt(log.order.get(), 0, place);
            const auto holds = [&](const Decision& d) {
                return d.subject.kind == Subject::Kind::Cell && d.outcome != Decision::Outcome::Open && d.places.first <= place &&
                       place < d.places.first + d.places.count;
            };
            const auto last = std::find_if(log.decisions.rbegin(), log.decisions.rend(), holds);
            ASSERT_NE(last, log.decisions.rend());
            std::vector<std::string> steps;
            for (const WhyStep& step : why(*recorded.culler->built(), log, triangle)) steps.push_back(step.sentence.text);
            for (const Decision& decision : log.decisions)
                if (decision.subject == last->subject && decision.sentence != nullptr) {
                    EXPECT_THAT(steps, testing::Contains(decision.sentence)) << triangle;
                    ++told;
                }
        }
        EXPECT_GT(told, 20u);
    }
}

}  // namespace
}  // namespace cullscope::test::recorded_decisions_test
