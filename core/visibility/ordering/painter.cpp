#include "core/base/work_check.h"
#include "core/spatial/painters_order.h"
#include "core/visibility/displaced_surfaces.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/ordering/named_subjects.h"
#include "core/visibility/ordering/ordering.h"
#include "core/visibility/ordering/painter_words.h"

namespace cullscope::ordering {
namespace {

constexpr const char* kTests = "newell-tests";
/// A recorded frame says every test of two polygons as it falls, and lights them, in scenes of at most so many triangles; of
/// larger ones only what is drawn.
constexpr uint64_t kComparedTriangles = 5'000;
constexpr size_t kMostTests = 100'000;
/// Comparisons of depths, and tests 1 and 2, are many: they are said in scenes of at most so many triangles.
constexpr uint64_t kExtentTriangles = 1'000;
/// So many polygons of a frame are said to be taken, and as many to be drawn, one by one.
constexpr size_t kRecordedPolygons = 100'000;

struct TrianglesOfScene : Structure {
    using Structure::Structure;
    std::optional<CutTriangles> triangles;
};

/// Of all lines but the last the first operands are triangles; that one begins with the share that is drawn.
OperandRole roleInComparison(const Decision& decision, size_t operand) {
    if (decision.subject.kind != Subject::Kind::Fragment) return OperandRole::Number;
    const size_t first = decision.line == uint8_t(PainterLine::Draw) ? 1 : 0;
    const bool alone = decision.line == uint8_t(PainterLine::Draw) || decision.line == uint8_t(PainterLine::Farthest);
    return operand == first || (operand == 1 && !alone) ? OperandRole::Triangle : OperandRole::Number;
}

class PaintersFrame {
public:
    PaintersFrame(FrameContext& frame, const CutTriangles& triangles, const ParameterSet& parameters)
        : m_frame(frame), m_progress{nullptr, frame.stop()}, m_triangles(triangles) {
        m_options.facing = frame.facing();
        m_options.byCentroid = parameters.choice("sort") == "centroid";
        m_options.limit = uint64_t(parameters.integer("limit"));
        if (!frame.recording()) return;
        m_options.watch = [this](const NewellStep& step) { keep(step); };
        m_options.watchDrawnOnly = frame.scene().triangleCount() > kComparedTriangles;
    }

    OwnTrianglesPointer order() {
        const PaintersOrder order = paintersOrder(m_triangles, m_frame.scene(), m_frame.view(), m_options, m_progress);
        m_triangles.finish(m_progress);
        m_own->facing = m_frame.facing();
        m_own->positions.reserve(3 * order.polygons.size());
        m_own->normals.reserve(3 * order.polygons.size());
        m_own->triangles.reserve(order.polygons.size());
        WorkCheck work(m_progress);
        for (const uint32_t triangle : m_triangles.flat()) add(triangle, [&] { m_triangles.drawWhole(triangle, *m_own); });
        m_inHand->drawn.resize(m_frame.recording() ? m_triangles.polygons().size() : 0);
        for (const uint32_t polygon : order.polygons) {
            work.step();
            const auto first = uint32_t(m_own->triangles.size());
            add(triangleOf(polygon), [&] { m_triangles.draw(polygon, *m_own); });
            if (m_frame.recording()) m_inHand->drawn[polygon] = {first, uint32_t(m_own->triangles.size()) - first};
        }
        if (m_frame.recording()) tell(work);
        count(order);
        return m_own;
    }

private:
    [[nodiscard]] uint32_t triangleOf(uint32_t polygon) const { return m_triangles.polygons()[polygon].triangle; }
    [[nodiscard]] Subject subjectOf(uint32_t polygon) const {
        const uint32_t triangle = triangleOf(polygon);
        return {Subject::Kind::Fragment, triangle, uint32_t(m_frame.scene().instanceOf(triangle))};
    }

    /// Keeps a step: where the triangles of a polygon lie among the own ones is known when the last cut is made.
    void keep(const NewellStep& step) {
        const NewellTest test = step.test;
        const bool compares = step.kind == NewellStep::Kind::Compared || step.kind == NewellStep::Kind::Failed;
        const bool byExtent = test == NewellTest::Depth || test == NewellTest::ExtentX || test == NewellTest::ExtentY;
        if (compares && byExtent && m_frame.scene().triangleCount() > kExtentTriangles) return;
        const bool draws = step.kind == NewellStep::Kind::Drawn;
        size_t& kept = compares ? m_compared : draws ? m_drawn : m_taken;
        if (++kept <= (compares ? kMostTests : kRecordedPolygons)) m_steps.push_back(step);
    }

    /// Says the steps in the order of the algorithm.
    void tell(WorkCheck& work) {
        if (!m_options.watchDrawnOnly) {
            for (uint32_t polygon = 0; polygon < m_triangles.polygons().size(); ++polygon) {
                work.step();
                m_inHand->whole.push_back(m_triangles.share(polygon) >= 1.0);
                std::vector<Vec3>& corners = m_inHand->corners.emplace_back();
                for (const CutTriangles::Corner& corner : m_triangles.cornersOf(polygon))
                    corners.push_back(m_triangles.position(corner.vertex));
            }
            m_inHand->first = m_frame.said();
            m_frame.attach(m_inHand);
        }
        for (const NewellStep& step : m_steps) {
            work.step();
            if (!m_options.watchDrawnOnly) m_inHand->pairs.push_back({step.p, step.q});
            if (step.kind == NewellStep::Kind::Drawn)
                drawn(step);
            else if (step.kind == NewellStep::Kind::Taken || step.kind == NewellStep::Kind::Again)
                taken(step);
            else
                tested(step);
        }
        const auto coarser = [&](bool is, const char* sentence, size_t number) {
            if (is) m_frame.sayCoarser({sentence, {std::to_string(number)}});
        };
        coarser(m_options.watchDrawnOnly, CULLSCOPE_TR("drawn polygons alone, above %1 triangles"), kComparedTriangles);
        const bool someTests = !m_options.watchDrawnOnly && m_frame.scene().triangleCount() > kExtentTriangles;
        coarser(someTests, CULLSCOPE_TR("without depths and tests 1 and 2, above %1 triangles"), kExtentTriangles);
        coarser(m_compared > kMostTests, CULLSCOPE_TR("the first %1 tests alone"), kMostTests);
        coarser(std::max(m_taken, m_drawn) > kRecordedPolygons, CULLSCOPE_TR("the first %1 polygons alone"), kRecordedPolygons);
    }

    void tested(const NewellStep& step) {
        const ToldTest told = toldTest(step);
        Decision test;
        test.subject = subjectOf(step.p);
        const bool first = step.kind == NewellStep::Kind::Compared && step.test <= NewellTest::Projections;
        test.containment = first ? Containment::Inside : Containment::Straddles;
        test.sentence = told.sentence;
        test.operands = {double(triangleOf(step.p)), double(triangleOf(step.q)), step.first, step.second};
        test.operandCount = 4;
        m_frame.say(atLine(told.line, test));
    }

    void taken(const NewellStep& step) {
        Decision farthest;
        farthest.subject = subjectOf(step.p);
        farthest.sentence = step.kind == NewellStep::Kind::Taken
                                ? CULLSCOPE_TR("Triangle %1 is the farthest one left, with the farthest depth %2.")
                                : CULLSCOPE_TR("Triangle %1, which waited, is taken again; its farthest depth is %2.");
        farthest.operands = {double(triangleOf(step.p)), step.first};
        farthest.operandCount = 2;
        m_frame.say(atLine(PainterLine::Farthest, farthest));
    }

    void drawn(const NewellStep& step) {
        const double share = m_triangles.share(step.p);
        Decision end = ending(subjectOf(step.p), Decision::Outcome::Drawn);
        end.sentence = toldDrawn(step.cause, share >= 1.0);
        end.places = m_inHand->drawn[step.p];
        end.operands = {share, double(triangleOf(step.p)), step.first};
        end.operandCount = step.cause == NewellStep::Cause::ByCentroid ? 3 : 2;
        m_frame.say(atLine(PainterLine::Draw, end));
    }

    template <typename Draw>
    void add(uint32_t triangle, const Draw& draw) {
        const Scene& scene = m_frame.scene();
        if (triangle < m_begin || triangle >= m_end) {
            m_instance = scene.instanceOf(triangle);
            m_begin = scene.firstTriangle(m_instance);
            m_end = m_begin + scene.meshOf(m_instance).triangleCount();
            m_own->runs.push_back({uint32_t(m_instance), uint32_t(m_own->triangles.size()), 0});
        }
        draw();
        m_own->runs.back().count = uint32_t(m_own->triangles.size()) - m_own->runs.back().first;
    }

    void count(const PaintersOrder& order) {
        constexpr std::array kNames{"test_depth",        "test_1_x", "test_2_y", "test_3_behind", "test_4_before",
                                    "test_5_projection", "swaps",    "cycles",   "pierced"};
        static_assert(kNames.size() == kNewellTests);
        for (size_t i = 0; i < kNewellTests; ++i) m_frame.counters().figures.push_back({kNames[i], double(order.tests[i])});
        m_frame.counters().figures.push_back({"cuts", double(m_triangles.cuts())});
        m_frame.counters().figures.push_back({"unresolved", double(order.unresolved)});
        m_frame.counters().bytesTouched = m_triangles.bytes();
        m_frame.counters().workBytes = m_triangles.bytes();
    }

    FrameContext& m_frame;
    Progress m_progress;
    CutTriangles m_triangles;  ///< a copy, which the frame cuts
    PaintersOptions m_options;
    std::shared_ptr<OwnTriangles> m_own = std::make_shared<OwnTriangles>();
    size_t m_instance = 0;
    uint64_t m_begin = 0, m_end = 0;  ///< the scene triangle numbers of that instance
    // While recording.
    std::vector<NewellStep> m_steps;
    size_t m_taken = 0, m_compared = 0, m_drawn = 0;
    std::shared_ptr<PolygonsInHand> m_inHand = std::make_shared<PolygonsInHand>();
};

class PaintersAlgorithm final : public StrategyWith<TrianglesOfScene> {
public:
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        Bars result;
        std::array<uint64_t, kMostListingLines + 1> counts{};
        for (const Decision& decision : log.decisions) {
            const bool isTest =
                decision.line >= uint8_t(PainterLine::Candidates) && decision.line <= uint8_t(PainterLine::Projections);
            const bool failed = isTest && decision.containment != Containment::Inside;
            if (decision.line < counts.size() && !failed) ++counts[decision.line];
        }
        const auto at = [&](PainterLine line) { return counts[size_t(line)]; };
        result.bars = {{CULLSCOPE_TR("3: P is behind Q's plane"), at(PainterLine::Behind)},
                       {CULLSCOPE_TR("4: Q is before P's plane"), at(PainterLine::Before)},
                       {CULLSCOPE_TR("5: projections apart"), at(PainterLine::Projections)},
                       {CULLSCOPE_TR("Q is taken first"), at(PainterLine::Swap)},
                       {CULLSCOPE_TR("one is cut"), at(PainterLine::Cut)}};
        return result;
    }

    [[nodiscard]] Promise promiseAt(const Structure& structure, const ParameterSet& parameters, Facing facing,
                                    const View& view) const override {
        return promiseWhereSurfacesStandStill(promise(structure, parameters, facing), structure.scene(), view);
    }

protected:
    void fill(TrianglesOfScene& structure, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        structure.triangles.emplace(structure.scene(), progress);
        structure.report.bytes = structure.triangles->bytes();
        structure.report.figures = {{"polygons", double(structure.triangles->polygons().size())}};
    }

    void decide(FrameContext& frame, const TrianglesOfScene& structure, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        OwnTrianglesPointer own;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("sorting"));
            const bool naive = parameters.choice("sort") == "centroid";
            sayBegin(frame, uint8_t(PainterLine::Sort),
                     naive ? CULLSCOPE_TR("%1 polygons are sorted by the distance of their centroids alone. None are compared.")
                           : CULLSCOPE_TR("%1 polygons are sorted by their farthest depth."),
                     {double(structure.triangles->polygons().size())});
            own = PaintersFrame(frame, *structure.triangles, parameters).order();
            if (frame.recording()) sayObjectsAreDrawn(frame);
        }
        if (!own->triangles.empty()) frame.draw(std::move(own));
    }

    [[nodiscard]] Promise promiseOf(const TrianglesOfScene& /*structure*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.choice("sort") == "newell" ? Promise::Conservative : Promise::Approximate;
    }

    [[nodiscard]] StructureSnapshot snapshotOf(const TrianglesOfScene& structure, const FrameLog& log) const override {
        const Scene& scene = structure.scene();
        const NamedParts parts = NamedSubjects::namesPartsOf(log) ? namedParts(scene, log) : NamedParts();
        StructureSnapshot snapshot;
        snapshot.places = std::make_shared<NamedSubjects>(scene, log, parts, roleInComparison);
        return snapshot;
    }
};

Show painterListing() {
    return listingShow({{CULLSCOPE_TR("sort far first, by depth or centroid"), 0},
                        {CULLSCOPE_TR("P = the farthest one left"), 0},
                        {CULLSCOPE_TR("for each Q that P overlaps in depth"), 1},
                        {CULLSCOPE_TR("1, 2: apart in x or y? next Q"), 2},
                        {CULLSCOPE_TR("3: P behind Q's plane? next Q"), 2},
                        {CULLSCOPE_TR("4: Q before P's plane? next Q"), 2},
                        {CULLSCOPE_TR("5: projections apart? next Q"), 2},
                        {CULLSCOPE_TR("Q marked, or they pierce: cut"), 2},
                        {CULLSCOPE_TR("else mark P; P = Q, from line 3"), 2},
                        {CULLSCOPE_TR("no Q left, or none compared: draw P"), 1}});
}

}  // namespace

RegisteredStrategy painter() {
    StrategyInfo info{
        "painter",
        CULLSCOPE_TR("Painter's algorithm"),
        CULLSCOPE_TR("Draws all triangles from far to near without depth test, and cuts those that wait for each other."),
        "Newell, Newell & Sancha 1972",
        {facingParameter(),
         choiceParameter("sort", "newell", CULLSCOPE_TR("How the triangles are sorted."),
                         {{"newell", CULLSCOPE_TR("by the tests of Newell, Newell and Sancha")},
                          {"centroid", CULLSCOPE_TR("by the distance of their centroids alone; shows wrong pixels")}}),
         {"limit",
          ParameterType::Integer,
          int64_t{1'000'000},
          1.0,
          1e8,
          "",
          CULLSCOPE_TR("How many polygons a frame may have, the cut ones among them."),
          {}}}};
    info.needsEyePoint = true;
    info.shows = {painterListing(), barsShow(kTests, CULLSCOPE_TR("Comparisons by what decided"))};
    return {std::move(info), std::make_shared<PaintersAlgorithm>()};
}

}  // namespace cullscope::ordering
