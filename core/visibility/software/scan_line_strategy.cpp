#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/base/message.h"
#include "core/raster/scan_line.h"
#include "core/visibility/facing.h"
#include "core/visibility/software/raster_strategy.h"
#include "core/visibility/software/software_raster.h"

namespace cullscope::software {
namespace {

/// A recorded scan line says every span and comparison up to this number of spans and to kMostRowSteps, and beyond it only its
/// rows.
constexpr size_t kMostSpansSaid = 25'000;
constexpr uint8_t kRowLine = 2;  ///< of the listing: a row and its active edges

/// The active edges that a recorded frame says one by one, so that steps can show them: attached to its first row.
struct ActiveEdges final : DecisionDetail {
    struct Edge {
        size_t decision = 0;       ///< its number in the frame; those of a row follow the row's
        std::vector<Vec3> line{};  ///< in world coordinates; empty: an end is too far away
        uint64_t triangle = 0;     ///< of the scene
        double x = 0.0;
    };
    std::vector<Edge> edges;

    /// One that is said next.
    void add(const FrameContext& frame, const RowEdge& of) {
        Edge edge{frame.said(), {}, of.triangle, of.x};
        const View& view = frame.view();
        for (const RowEdge::End& end : of.ends) {
            const double distance = view.distanceFromDepth(std::clamp(double(end.depth), 0.0, 1.0));
            if (std::isfinite(distance)) edge.line.push_back(view.pointAt(double(end.x) + 0.5, double(end.y) + 0.5, distance));
        }
        if (edge.line.size() < 2) edge.line.clear();
        edges.push_back(std::move(edge));
    }

    /// Those of the row whose decision has a number, or the one that has it itself.
    [[nodiscard]] std::span<const Edge> of(const Decision& decision, size_t number) const {
        const auto begin = std::ranges::lower_bound(edges, number, {}, &Edge::decision);
        if (decision.subject.kind == Subject::Kind::Triangles)
            return {begin, begin != edges.end() && begin->decision == number ? begin + 1 : begin};
        auto end = begin;
        while (end != edges.end() && end->decision == number + 1 + size_t(end - begin)) ++end;
        return {begin, end};
    }
};

/// Lights the active edges and names them.
class ScanLineSubjects final : public RasterSubjects {
public:
    /// A sentence names so many edges.
    static constexpr size_t kMostNamed = 12;

    ScanLineSubjects(ScenePointer scene, const FrameLog& log) : RasterSubjects(std::move(scene), log) {
        for (const LoggedDetail& logged : log.details)
            if (auto edges = std::dynamic_pointer_cast<const ActiveEdges>(logged.detail)) m_active = std::move(edges);
    }

    [[nodiscard]] std::optional<SubjectPlace> at(const Scene& /*scene*/, const Decision& decision, size_t number) const override {
        SubjectPlace place;
        for (const ActiveEdges::Edge& edge : edgesOf(decision, number))
            if (!edge.line.empty()) place.lines.push_back(edge.line);
        return place.lines.empty() ? std::nullopt : std::optional(std::move(place));
    }

    /// The edges of a row: "7: 10.5, 88; 9: 40.25, 93", each triangle's by its number in the scene.
    [[nodiscard]] EntryNames names(const StructureSnapshot& snapshot, const Decision& decision, size_t number) const override {
        EntryNames names = RasterSubjects::names(snapshot, decision, number);
        const std::span<const ActiveEdges::Edge> edges = edgesOf(decision, number);
        if (decision.subject.kind != Subject::Kind::Rows || edges.empty()) return names;
        std::string& list = names.operands[3];
        for (size_t i = 0; i < std::min(edges.size(), kMostNamed); ++i) {
            char x[32];
            std::snprintf(x, sizeof x, "%.6g", edges[i].x);
            if (i > 0 && edges[i].triangle == edges[i - 1].triangle)
                list += std::string(", ") + x;
            else
                list += (i > 0 ? "; " : "") + std::to_string(edges[i].triangle) + ": " + x;
        }
        if (edges.size() > kMostNamed) list += "; …";
        return names;
    }

private:
    [[nodiscard]] std::span<const ActiveEdges::Edge> edgesOf(const Decision& decision, size_t number) const {
        const bool tells = m_active && decision.line == kRowLine;
        return tells ? m_active->of(decision, number) : std::span<const ActiveEdges::Edge>();
    }

    std::shared_ptr<const ActiveEdges> m_active;  ///< null: none are told one by one
};

class ScanLine final : public RasterStrategy {
public:
    enum class Line : uint8_t { Table = 1, Row = kRowLine, Alone, Begins, Ends, Crosses, Fill, Done, Shown };

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto sum = [&](size_t operand) { return sumAtLine(log, Subject::Kind::Rows, uint8_t(Line::Done), operand); };
        return {{},
                {{CULLSCOPE_TR("depth comparisons"), sum(0)},
                 {CULLSCOPE_TR("comparisons of a depth buffer"), sum(1)},
                 {CULLSCOPE_TR("spans"), sum(2)}}};
    }

protected:
    [[nodiscard]] RasterPicture rasterise(FrameContext& frame, const SceneOnRaster& raster, bool parallel,
                                          const Progress& progress) const override {
        ScanLinePicture drawn = drawScanLine(raster, frame.recording(), parallel, progress);
        if (frame.recording()) say(frame, drawn);
        return drawn;
    }
    [[nodiscard]] ObjectLines objectLines() const override { return {uint8_t(Line::Table), uint8_t(Line::Shown)}; }
    [[nodiscard]] StructureSnapshot snapshotOf(const NoStructure& structure, const FrameLog& log) const override {
        StructureSnapshot snapshot;
        snapshot.places = std::make_shared<ScanLineSubjects>(structure.scenePointer(), log);
        return snapshot;
    }

private:
    static void say(FrameContext& frame, const ScanLinePicture& drawn) {
        const bool fewSpans = drawn.spans.size() <= kMostSpansSaid, fewSteps = !drawn.steps.empty() || drawn.spans.empty();
        const bool spansToo = fewSpans && fewSteps;
        if (!fewSpans) frame.sayCoarser({CULLSCOPE_TR("by row, above %1 spans"), {std::to_string(kMostSpansSaid)}});
        if (fewSpans && !fewSteps) frame.sayCoarser({CULLSCOPE_TR("by row, above %1 steps"), {std::to_string(kMostRowSteps)}});
        if (spansToo && drawn.edges.empty() && !drawn.spans.empty())
            frame.sayCoarser({CULLSCOPE_TR("without single edges, above %1 of them"), {std::to_string(kMostRowEdges)}});
        auto active = std::make_shared<ActiveEdges>();
        size_t nextSpan = 0, nextStep = 0, nextEdge = 0;
        bool attached = false;
        for (uint32_t row = 0; row < drawn.rows.size(); ++row) {
            const RowCounts& counts = drawn.rows[row];
            if (counts.triangles == 0) {
                row = sayEmptyRows(frame, drawn, row);
                continue;
            }
            if (spansToo) {
                sayRow(frame, row, counts, nextEdge < drawn.edges.size() ? &drawn.edges[nextEdge] : nullptr);
                if (!std::exchange(attached, true)) frame.attach(active);
            }
            for (; spansToo && nextEdge < drawn.edges.size() && drawn.edges[nextEdge].row == int(row); ++nextEdge)
                sayEdge(frame, drawn.edges[nextEdge], *active);
            // A span is filled when the column is reached at which another one comes.
            const auto fillTo = [&](int column) {
                for (; nextSpan < drawn.spans.size() && drawn.spans[nextSpan].row == int(row); ++nextSpan) {
                    if (drawn.spans[nextSpan].end > column) break;
                    sayFilled(frame, drawn.spans[nextSpan], uint32_t(nextSpan));
                }
            };
            for (; spansToo && nextStep < drawn.steps.size() && drawn.steps[nextStep].row == int(row); ++nextStep) {
                fillTo(drawn.steps[nextStep].column);
                sayStep(frame, drawn.steps[nextStep]);
            }
            if (spansToo) fillTo(frame.view().viewport().width);
            Decision done = said(ofRows(row), Decision::Outcome::Open,
                                 CULLSCOPE_TR("Depths compared in this row: %1, by a depth buffer: %2; spans filled: %3."),
                                 {double(counts.comparisons), double(counts.samples), double(counts.spans)});
            done.places = pixelsOf(frame, int(row), int(row) + 1, 0, frame.view().viewport().width);
            frame.say(atLine(Line::Done, done));
        }
    }

    /// Consecutive rows that no surface reaches. Returns the last one.
    static uint32_t sayEmptyRows(FrameContext& frame, const ScanLinePicture& drawn, uint32_t first) {
        uint32_t end = first;
        while (end < drawn.rows.size() && drawn.rows[end].triangles == 0) ++end;
        Decision empty = said(ofRows(first), Decision::Outcome::Open,
                              CULLSCOPE_TR("No surface reaches here: nothing is compared, and nothing is filled."), {});
        empty.operandCount = 0;
        empty.places = pixelsOf(frame, int(first), int(end), 0, frame.view().viewport().width);
        frame.say(atLine(Line::Done, empty));
        return end - 1;
    }

    /// `edge`: its first one; null: its edges are not told one by one.
    static void sayRow(FrameContext& frame, uint32_t row, const RowCounts& counts, const RowEdge* edge) {
        Decision decision =
            said(ofRows(row), Decision::Outcome::Open,
                 edge == nullptr ? CULLSCOPE_TR("In row %1 there are active edges: %2; surfaces: %3.")
                                 : CULLSCOPE_TR("In row %1 there are active edges: %2; surfaces: %3. They lie at x = %4."),
                 {double(row), double(counts.edges), double(counts.triangles), edge == nullptr ? 0.0 : edge->x});
        decision.operandCount = edge == nullptr ? 3 : 4;
        frame.say(atLine(Line::Row, decision));
    }

    static void sayEdge(FrameContext& frame, const RowEdge& edge, ActiveEdges& active) {
        const auto object = uint32_t(frame.scene().instanceOf(edge.triangle));
        const auto number = uint32_t(edge.triangle - frame.scene().firstTriangle(object));
        active.add(frame, edge);
        Decision decision = said(
            Subject::ofTriangles(number, object), Decision::Outcome::Open,
            edge.begins
                ? CULLSCOPE_TR("An edge of it is active: in row %1 it lies at x = %2, and the triangle begins at column %3.")
                : CULLSCOPE_TR("An edge of it is active: in row %1 it lies at x = %2, and the triangle ends before column %3."),
            {double(edge.row), edge.x, double(edge.column)});
        decision.places = {number, 1};
        frame.say(atLine(Line::Row, decision));
    }

    static void sayFilled(FrameContext& frame, const RowSpan& span, uint32_t number) {
        const Subject subject{Subject::Kind::Span, number, uint32_t(frame.scene().instanceOf(span.triangle))};
        Decision filled = said(subject, Decision::Outcome::Open, CULLSCOPE_TR("Columns %1 to %2 are filled with it."),
                               {double(span.begin), double(span.end - 1)});
        filled.operandCount = 2;
        filled.places = pixelsOf(frame, span.row, span.row + 1, span.begin, span.end);
        frame.say(atLine(Line::Fill, filled));
    }

    static void sayStep(FrameContext& frame, const RowStep& step) {
        const auto object = uint32_t(frame.scene().instanceOf(step.triangle));
        const auto number = uint32_t(step.triangle - frame.scene().firstTriangle(object));
        const ToldStep told = toldStep(step);
        Decision decision = said(Subject::ofTriangles(number, object), Decision::Outcome::Open, told.sentence,
                                 {double(step.column), step.depth, step.otherDepth});
        decision.operandCount = step.other == 0 ? 2 : 3;
        decision.places = {number, 1};
        frame.say(atLine(told.line, decision));
    }

    struct ToldStep {
        Line line;
        const char* sentence;
    };

    /// The line and the sentence of a step; %1 is the column, %2 and %3 are the depths.
    static ToldStep toldStep(const RowStep& step) {
        if (step.other == 0)
            return step.at == RowStep::At::Ends
                       ? ToldStep{Line::Ends, CULLSCOPE_TR("At column %1 the surface in front ends. The first one of those that "
                                                           "remain, at depth %2, comes to the front without a comparison.")}
                       : ToldStep{Line::Alone, CULLSCOPE_TR("At column %1 a surface begins where none is in front, at depth %2: "
                                                            "it comes to the front without a comparison.")};
        const bool equal = step.depth == step.otherDepth;
        const auto outcome = [&](const char* nearer, const char* farther, const char* same) {
            return equal ? same : step.toFront ? nearer : farther;
        };
        switch (step.at) {
            case RowStep::At::Begins:
                return {Line::Begins,
                        outcome(CULLSCOPE_TR("At column %1 a surface begins. Its depth %2 is compared with %3 of the one in "
                                             "front: it is nearer."),
                                CULLSCOPE_TR("At column %1 a surface begins. Its depth %2 is compared with %3 of the one in "
                                             "front: it is farther."),
                                CULLSCOPE_TR("At column %1 a surface begins. Its depth %2 is compared with %3 of the one in "
                                             "front: they are equal, and the one that comes first in the scene is in front."))};
            case RowStep::At::Ends:
                return {Line::Ends,
                        outcome(CULLSCOPE_TR("At column %1 a surface remains where the one in front ended. Its depth %2 is "
                                             "compared with %3 of the one taken so far: it is nearer."),
                                CULLSCOPE_TR("At column %1 a surface remains where the one in front ended. Its depth %2 is "
                                             "compared with %3 of the one taken so far: it is farther."),
                                CULLSCOPE_TR("At column %1 a surface remains where the one in front ended. Its depth %2 is "
                                             "compared with %3 of the one taken so far: they are equal, and the one that comes "
                                             "first in the scene is in front."))};
            case RowStep::At::Crosses:
                break;
        }
        return {
            Line::Crosses,
            outcome(CULLSCOPE_TR("At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that "
                                 "one: it is nearer, and the span is split there."),
                    CULLSCOPE_TR("At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that "
                                 "one: it is farther."),
                    CULLSCOPE_TR("At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that "
                                 "one: they are equal, and the one that comes first in the scene is in front."))};
    }
};

}  // namespace

RegisteredStrategy scanLine() {
    StrategyInfo info{
        "scan-line",
        CULLSCOPE_TR("Scan line, in software"),
        CULLSCOPE_TR("Draws row by row on the processor and compares depths only where surfaces begin, end or cross."),
        "Visible-surface determination, lecture: 2. scan line method; Watkins 1970",
        {facingParameter(), parallelParameter()}};
    info.shows = {listingShow({{CULLSCOPE_TR("edge table: edges by their first row"), 0},
                               {CULLSCOPE_TR("for each row: its active edges"), 0},
                               {CULLSCOPE_TR("begins, none in front: in front"), 1},
                               {CULLSCOPE_TR("begins: compare with the front"), 1},
                               {CULLSCOPE_TR("front ends: compare the others"), 1},
                               {CULLSCOPE_TR("two cross: compare, split the span"), 1},
                               {CULLSCOPE_TR("fill the span, comparing nothing"), 1},
                               {CULLSCOPE_TR("the row is done"), 1},
                               {CULLSCOPE_TR("show the rows"), 0}}),
                  barsShow("scan-line-comparisons", CULLSCOPE_TR("Comparisons of depths"))};
    return {std::move(info), std::make_shared<ScanLine>()};
}

}  // namespace cullscope::software
