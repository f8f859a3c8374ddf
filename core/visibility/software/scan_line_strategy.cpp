#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/base/message.h"
#include "core/raster/scan_line.h"
#include "core/visibility/software/raster_strategy.h"
#include "core/visibility/software/software_raster.h"

namespace cullscope::software {
namespace {

/// A recorded scan line says every span up to this number of them, and beyond it only its rows.
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
            if (std::isfinite(distance))
                edge.line.push_back(view.eye() + distance * view.direction(double(end.x) + 0.5, double(end.y) + 0.5));
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
        const bool spansToo = drawn.spans.size() <= kMostSpansSaid;
        if (!spansToo) frame.sayCoarser({CULLSCOPE_TR("by row, above %1 spans"), {std::to_string(kMostSpansSaid)}});
        if (spansToo && drawn.edges.empty() && !drawn.spans.empty())
            frame.sayCoarser({CULLSCOPE_TR("without single edges, above %1 of them"), {std::to_string(kMostRowEdges)}});
        auto active = std::make_shared<ActiveEdges>();
        size_t nextSpan = 0, nextEdge = 0;
        bool attached = false;
        for (uint32_t row = 0; row < drawn.rows.size(); ++row) {
            const RowCounts& counts = drawn.rows[row];
            if (spansToo && counts.triangles > 0) {
                sayRow(frame, row, counts, nextEdge < drawn.edges.size() ? &drawn.edges[nextEdge] : nullptr);
                if (!std::exchange(attached, true)) frame.attach(active);
            }
            for (; spansToo && nextEdge < drawn.edges.size() && drawn.edges[nextEdge].row == int(row); ++nextEdge)
                sayEdge(frame, drawn.edges[nextEdge], *active);
            for (; spansToo && nextSpan < drawn.spans.size() && drawn.spans[nextSpan].row == int(row); ++nextSpan)
                sayPart(frame, drawn.spans[nextSpan], uint32_t(nextSpan));
            Decision done = said(ofRows(row), Decision::Outcome::Open,
                                 CULLSCOPE_TR("In this row %1 depths were compared, where a depth buffer compares "
                                              "%2; %3 spans were filled."),
                                 {double(counts.comparisons), double(counts.samples), double(counts.spans)});
            done.places = pixelsOf(frame, int(row), int(row) + 1, 0, frame.view().viewport().width);
            frame.say(atLine(Line::Done, done));
        }
    }

    /// `edge`: its first one; null: its edges are not told one by one.
    static void sayRow(FrameContext& frame, uint32_t row, const RowCounts& counts, const RowEdge* edge) {
        Decision decision =
            said(ofRows(row), Decision::Outcome::Open,
                 edge == nullptr ? CULLSCOPE_TR("In row %1 there are %2 active edges, of %3 surfaces.")
                                 : CULLSCOPE_TR("In row %1 there are %2 active edges, of %3 surfaces, at x = %4."),
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

    static void sayPart(FrameContext& frame, const RowSpan& span, uint32_t number) {
        const Subject subject{Subject::Kind::Span, number, uint32_t(frame.scene().instanceOf(span.triangle))};
        frame.say(decisionOf(span, subject));
        Decision filled = said(subject, Decision::Outcome::Open, CULLSCOPE_TR("Columns %1 to %2 are filled with it."),
                               {double(span.begin), double(span.end - 1)});
        filled.operandCount = 2;
        filled.places = pixelsOf(frame, span.row, span.row + 1, span.begin, span.end);
        frame.say(atLine(Line::Fill, filled));
    }

    static Decision decisionOf(const RowSpan& span, const Subject& subject) {
        const auto open = Decision::Outcome::Open;
        const std::array<double, Decision::kOperands> operands{double(span.begin), span.depth, span.otherDepth};
        switch (span.start) {
            case RowSpan::Start::Alone:
                return atLine(Line::Alone,
                              said(subject, open,
                                   CULLSCOPE_TR("At column %1 a surface begins where there is no other one, at depth "
                                                "%2: it is in front without a comparison."),
                                   operands));
            case RowSpan::Start::Begins:
                return atLine(Line::Begins,
                              said(subject, open,
                                   CULLSCOPE_TR("At column %1 a surface begins. Its depth %2 is compared with %3 of "
                                                "the one in front: it is nearer."),
                                   operands));
            case RowSpan::Start::Remains:
                return atLine(Line::Ends,
                              said(subject, open,
                                   CULLSCOPE_TR("At column %1 the surface in front ends. Of those that remain the one "
                                                "at depth %2 is the nearest; it was compared with %3."),
                                   operands));
            case RowSpan::Start::Crosses:
                break;
        }
        return atLine(Line::Crosses, said(subject, open,
                                          CULLSCOPE_TR("At column %1 a surface comes through the one in front: its depth is %2, "
                                                       "that of the other one %3. The span is split there."),
                                          operands));
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
                               {CULLSCOPE_TR("begins alone: in front"), 1},
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
