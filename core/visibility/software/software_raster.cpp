#include "core/visibility/software/software_raster.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/raster/scan_line.h"
#include "core/visibility/facing.h"
#include "core/visibility/software/triangle_fates.h"
#include "core/visibility/why.h"

namespace cullscope::software {
namespace {

constexpr const char* kParallel = "parallel";
/// A recorded scan line says every span up to this number of them, and beyond it only its rows.
constexpr size_t kMostSpansSaid = 25'000;
/// A recorded depth buffer says every triangle up to this number of them, and beyond it only its bands of rows.
constexpr size_t kMostTrianglesSaid = 2000;

struct NoStructure : Structure {
    using Structure::Structure;
};

Decision said(const Subject& subject, Decision::Outcome outcome, const char* sentence,
              const std::array<double, Decision::kOperands>& operands) {
    Decision decision;
    decision.subject = subject;
    decision.outcome = outcome;
    decision.sentence = sentence;
    decision.operands = operands;
    decision.operandCount = 3;
    return decision;
}

/// A strategy that makes its picture on the processor from all triangles of the scene.
class SoftwareRaster : public StrategyWith<NoStructure> {
public:
    void addWhySteps(const Structure& /*structure*/, const FrameLog& log, uint32_t instance, uint32_t triangle,
                     std::vector<WhyStep>& steps) const override {
        for (const Decision& decision : log.decisions) {
            if (decision.subject.kind != Subject::Kind::Cell || decision.subject.object != instance) continue;
            if (decision.outcome != Decision::Outcome::Culled) continue;
            if (triangle - decision.places.first < decision.places.count)
                steps.push_back({{decision.sentence, {}}, {}, {}, {}, Containment::Outside});
        }
    }

protected:
    void fill(NoStructure& structure, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        structure.report.figures = {{"objects", double(structure.scene().instances().size())}};
    }

    void decide(FrameContext& frame, const NoStructure& /*structure*/, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        const bool parallel = parameters.boolean(kParallel);
        const Progress progress{nullptr, frame.stop()};
        SceneOnRaster raster;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("triangles to the raster"));
            raster =
                trianglesOnRaster(frame.scene(), frame.view(), frame.facing(), parallel, availableRasterSimd().back(), progress);
        }
        if (frame.recording()) sayTriangles(frame, countFates(frame.scene(), raster.fates));
        RasterPicture drawn;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("rasterising"));
            drawn = rasterise(frame, raster, parallel, progress);
        }
        const RowCounts total = drawn.total();
        FrameCounters& counters = frame.counters();
        counters.nodesVisited = raster.triangleCount();
        counters.bytesTouched = drawn.picture->depth.size() * (sizeof(float) + sizeof(uint32_t));
        counters.workBytes = raster.bytes() + drawn.fates.capacity() + drawn.bytes;
        counters.figures = {{"samples", double(total.samples)},
                            {"comparisons", double(total.comparisons)},
                            {"written", double(total.written)},
                            {"overlap", total.covered > 0 ? double(total.samples) / double(total.covered) : 0.0}};
        markShown(*drawn.picture, drawn.fates, parallel);
        end(frame, drawn.fates);
        frame.show(std::move(drawn.picture));
    }

    [[nodiscard]] Promise promiseOf(const NoStructure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Exact;
    }

    /// Makes the picture, and says how where the frame is recorded.
    [[nodiscard]] virtual RasterPicture rasterise(FrameContext& frame, const SceneOnRaster& raster, bool parallel,
                                                  const Progress& progress) const = 0;
    /// The lines of the listing at which an object's triangles come to the raster, and at which they are shown.
    struct ObjectLines {
        uint8_t triangles, shown;
    };
    [[nodiscard]] virtual ObjectLines objectLines() const = 0;

private:
    void sayTriangles(FrameContext& frame, const std::vector<FateCounts>& counts) const {
        const char* sentence =
            CULLSCOPE_TR("Of its %1 triangles %2 lie beyond a plane of the frustum and %3 are turned away: they are not drawn.");
        for (uint32_t i = 0; i < counts.size(); ++i) {
            const uint64_t given = frame.scene().meshOf(i).triangleCount();
            Decision test = said(Subject::ofObject(i), Decision::Outcome::Open, sentence,
                                 {double(given), double(counts[i][kOutside]), double(counts[i][kFacingAway])});
            if (counts[i][kOutside] == given) test.containment = Containment::Outside;
            frame.say(atLine(objectLines().triangles, test));
        }
    }

    /// Says and counts what became of each object and its triangles.
    void end(FrameContext& frame, const std::vector<uint8_t>& fates) const {
        const std::vector<FateCounts> counts = countFates(frame.scene(), fates);
        size_t runsLeft = kMostRunsSaid;
        for (uint32_t i = 0; i < counts.size(); ++i) {
            const uint64_t triangles = frame.scene().meshOf(i).triangleCount(), shown = counts[i][kShown];
            FateCounts others = counts[i];
            others[kShown] = 0;
            for (uint8_t fate = 0; fate < kTriangleFates; ++fate)
                frame.counters().culledTriangles[size_t(causeOf(fate))] += others[fate];
            if (!frame.recording()) continue;
            // Of an object that is left out for several causes the one that its own decision names.
            const auto most = others[kCovers] > 0 ? uint8_t{kCovers} : uint8_t(std::ranges::max_element(others) - others.begin());
            if (shown < triangles && shown + others[most] < triangles)
                sayFates(frame, i, fates, uint8_t(objectLines().shown), runsLeft);
            const auto outcome = shown == triangles ? Decision::Outcome::Drawn
                                 : shown > 0        ? Decision::Outcome::PartlyDrawn
                                                    : Decision::Outcome::Culled;
            Decision decision = ending(Subject::ofObject(i), triangles == 0 ? Decision::Outcome::Culled : outcome, causeOf(most));
            decision.containment = shown == 0 ? Containment::Outside : Containment::Straddles;
            frame.say(atLine(objectLines().shown, decision));
        }
    }
};

/// A rectangle of the picture, as decisions name it (Decision::places): rows [firstRow, endRow), columns [begin, end).
PlaceRun pixelsOf(const FrameContext& frame, int firstRow, int endRow, int begin, int end) {
    if (firstRow >= endRow || begin >= end) return {};
    const int width = frame.view().viewport().width;
    const auto first = uint32_t(firstRow * width + begin), last = uint32_t((endRow - 1) * width + end - 1);
    return {first, last - first + 1};
}

/// Sums of an operand over the decisions about such subjects that fell at a line.
uint64_t sumAtLine(const FrameLog& log, Subject::Kind kind, uint8_t line, size_t operand) {
    double sum = 0.0;
    for (const Decision& decision : log.decisions)
        if (decision.line == line && decision.subject.kind == kind) sum += decision.operands[operand];
    return uint64_t(sum);
}

class DepthBuffer final : public SoftwareRaster {
public:
    enum class Line : uint8_t { Clear = 1, Triangles, Transform, Samples, Depth, Compare, Store, Shown };

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto sum = [&](size_t ofBand, Line line, size_t ofTriangle) {
            return sumAtLine(log, Subject::Kind::Tile, uint8_t(Line::Compare), ofBand) +
                   sumAtLine(log, Subject::Kind::Cell, uint8_t(line), ofTriangle);
        };
        return {{},
                {{CULLSCOPE_TR("depth comparisons"), sum(0, Line::Depth, 0)},
                 {CULLSCOPE_TR("samples written"), sum(1, Line::Store, 0)},
                 {CULLSCOPE_TR("pixels that show a surface"), sum(2, Line::Store, 1)}}};
    }

protected:
    [[nodiscard]] RasterPicture rasterise(FrameContext& frame, const SceneOnRaster& raster, bool parallel,
                                          const Progress& progress) const override {
        RasterPicture drawn = drawDepthBuffer(raster, parallel, availableRasterSimd().back(), progress);
        if (!frame.recording()) return drawn;
        std::vector<FollowedTriangle> followed;
        if (raster.triangleCount() <= kMostTrianglesSaid) followed = followDepthBuffer(raster);
        for (const FollowedTriangle& triangle : followed) say(frame, triangle);
        if (followed.empty()) sayBands(frame, drawn);
        return drawn;
    }
    [[nodiscard]] ObjectLines objectLines() const override { return {uint8_t(Line::Transform), uint8_t(Line::Shown)}; }

private:
    static void say(FrameContext& frame, const FollowedTriangle& of) {
        const auto object = uint32_t(frame.scene().instanceOf(of.triangle));
        const auto number = uint32_t(of.triangle - frame.scene().firstTriangle(object));
        const auto sayAt = [&](Line line, Decision::Outcome outcome, const char* sentence,
                               const std::array<double, Decision::kOperands>& operands, uint8_t count) {
            Decision decision = said(Subject::ofCell(number, object), outcome, sentence, operands);
            decision.operandCount = count;
            decision.places = {number, 1};
            frame.say(atLine(line, decision));
        };
        const auto open = Decision::Outcome::Open;
        sayAt(Line::Depth, open, CULLSCOPE_TR("The triangle covers %1 samples. At column %2 of row %3 its depth is %4."),
              {double(of.samples), double(of.column), double(of.row), of.depth}, 4);
        if (of.written == 0)
            return sayAt(Line::Compare, open,
                         CULLSCOPE_TR("Its depth %1 there does not exceed the stored %2. It is nearer at none of its samples."),
                         {of.depth, of.stored}, 2);
        sayAt(Line::Store, Decision::Outcome::Drawn,
              CULLSCOPE_TR("At %1 samples it is nearer, at %2 of them the first surface. There its depth %3 exceeds the stored "
                           "%4: drawn."),
              {double(of.written), double(of.first), of.depth, of.stored}, 4);
    }

    static void sayBands(FrameContext& frame, const RasterPicture& drawn) {
        for (uint32_t tile = 0; tile < drawn.rows.size(); ++tile) {
            const RowCounts& counts = drawn.rows[tile];
            Decision stored = said({Subject::Kind::Tile, tile, Subject::kNoObject}, Decision::Outcome::Open,
                                   CULLSCOPE_TR("In this tile %1 depths were compared with the stored ones; %2 were nearer and "
                                                "stored. %3 pixels show a surface."),
                                   {double(counts.comparisons), double(counts.written), double(counts.covered)});
            stored.places = pixelsOf(frame, counts.firstRow, counts.endRow, 0, frame.view().viewport().width);
            frame.say(atLine(Line::Compare, stored));
        }
    }
};

class ScanLine final : public SoftwareRaster {
public:
    enum class Line : uint8_t { Table = 1, Row, Alone, Begins, Ends, Crosses, Fill, Done, Shown };

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto sum = [&](size_t operand) { return sumAtLine(log, Subject::Kind::Tile, uint8_t(Line::Done), operand); };
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

private:
    static void say(FrameContext& frame, const ScanLinePicture& drawn) {
        const bool spansToo = drawn.spans.size() <= kMostSpansSaid;
        size_t next = 0;
        for (uint32_t row = 0; row < drawn.rows.size(); ++row) {
            const RowCounts& counts = drawn.rows[row];
            if (spansToo && counts.triangles > 0)
                frame.say(atLine(Line::Row, said({Subject::Kind::Tile, row, Subject::kNoObject}, Decision::Outcome::Open,
                                                 CULLSCOPE_TR("In row %1 there are %2 active edges, of %3 surfaces."),
                                                 {double(row), double(counts.edges), double(counts.triangles)})));
            for (; spansToo && next < drawn.spans.size() && drawn.spans[next].row == int(row); ++next)
                sayPart(frame, drawn.spans[next], uint32_t(next));
            Decision done = said({Subject::Kind::Tile, row, Subject::kNoObject}, Decision::Outcome::Open,
                                 CULLSCOPE_TR("In this row %1 depths were compared, where a depth buffer compares "
                                              "%2; %3 spans were filled."),
                                 {double(counts.comparisons), double(counts.samples), double(counts.spans)});
            done.places = pixelsOf(frame, int(row), int(row) + 1, 0, frame.view().viewport().width);
            frame.say(atLine(Line::Done, done));
        }
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

ParameterDeclaration parallelParameter() {
    return booleanParameter(
        kParallel, true,
        CULLSCOPE_TR("Whether parts of the picture are drawn on all processors at once; the picture is the same."));
}

}  // namespace

RegisteredStrategy depthBuffer() {
    StrategyInfo info{"depth-buffer",
                      CULLSCOPE_TR("Depth buffer, in software"),
                      CULLSCOPE_TR("Draws every triangle on the processor and keeps the nearest surface at each sample."),
                      "Visible-surface determination, lecture: 1. depth (z) buffer method; Catmull 1974",
                      {facingParameter(), parallelParameter()}};
    info.shows = {listingShow({{CULLSCOPE_TR("clear all depths to the farthest"), 0},
                               {CULLSCOPE_TR("for each triangle, in any order"), 0},
                               {CULLSCOPE_TR("transform, clip at the near plane"), 1},
                               {CULLSCOPE_TR("for each sample it covers"), 1},
                               {CULLSCOPE_TR("z = its depth there"), 2},
                               {CULLSCOPE_TR("if z is nearer than the stored"), 2},
                               {CULLSCOPE_TR("store z and the triangle"), 3},
                               {CULLSCOPE_TR("show what is stored"), 0}}),
                  barsShow("depth-comparisons", CULLSCOPE_TR("Comparisons of depths"))};
    return {std::move(info), std::make_shared<DepthBuffer>()};
}

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
