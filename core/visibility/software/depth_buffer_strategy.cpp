#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/software/raster_strategy.h"
#include "core/visibility/software/software_raster.h"

namespace cullscope::software {
namespace {

/// A recorded depth buffer says every triangle up to this number of them, and beyond it only its bands of rows.
constexpr size_t kMostTrianglesSaid = 2000;

class DepthBuffer final : public RasterStrategy {
public:
    enum class Line : uint8_t { Clear = 1, Triangles, Transform, Samples, Depth, Compare, Store, Shown };

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto sum = [&](size_t ofBand, Line line, size_t ofTriangle) {
            return sumAtLine(log, Subject::Kind::Rows, uint8_t(Line::Compare), ofBand) +
                   sumAtLine(log, Subject::Kind::Triangles, uint8_t(line), ofTriangle);
        };
        return {{},
                {{CULLSCOPE_TR("depth comparisons"), sum(0, Line::Depth, 0)},
                 {CULLSCOPE_TR("samples written"), sum(1, Line::Store, 0)},
                 {CULLSCOPE_TR("pixels that show a surface"), sum(2, Line::Store, 1)}}};
    }

protected:
    [[nodiscard]] RasterPicture rasterise(FrameContext& frame, const SceneOnRaster& raster, bool parallel,
                                          const Progress& progress) const override {
        // A small picture that is recorded is drawn triangle by triangle, and each one's tests are said as they fall.
        const bool small = raster.triangleCount() <= kMostTrianglesSaid;
        if (frame.recording() && small) {
            if (std::optional<FollowedPicture> followed = followDepthBuffer(raster, progress)) {
                for (const FollowedTriangle& triangle : followed->triangles) say(frame, triangle);
                return std::move(followed->drawn);
            }
        }
        RasterPicture drawn = drawDepthBuffer(raster, parallel, availableRasterSimd().back(), progress);
        if (!frame.recording()) return drawn;
        sayBands(frame, drawn);
        if (!small)
            frame.sayCoarser({CULLSCOPE_TR("by bands of rows, above %1 triangles"), {std::to_string(kMostTrianglesSaid)}});
        else if (drawn.total().samples > 0)
            frame.sayCoarser({CULLSCOPE_TR("by bands of rows, above %1 pixels to look at"), {std::to_string(kMostFollowed)}});
        return drawn;
    }
    [[nodiscard]] ObjectLines objectLines() const override { return {uint8_t(Line::Transform), uint8_t(Line::Shown)}; }

private:
    static void say(FrameContext& frame, const FollowedTriangle& of) {
        const auto object = uint32_t(frame.scene().instanceOf(of.triangle));
        const auto number = uint32_t(of.triangle - frame.scene().firstTriangle(object));
        const auto sayAt = [&](Line line, Decision::Outcome outcome, const char* sentence,
                               const std::array<double, Decision::kOperands>& operands, uint8_t count) {
            Decision decision = said(Subject::ofTriangles(number, object), outcome, sentence, operands);
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
        for (const RowCounts& counts : drawn.rows) {
            Decision stored = said(ofRows(uint32_t(counts.firstRow)), Decision::Outcome::Open,
                                   CULLSCOPE_TR("In these rows %1 depths were compared with the stored ones; %2 were nearer and "
                                                "stored. %3 pixels show a surface."),
                                   {double(counts.comparisons), double(counts.written), double(counts.covered)});
            stored.places = pixelsOf(frame, counts.firstRow, counts.endRow, 0, frame.view().viewport().width);
            frame.say(atLine(Line::Compare, stored));
        }
    }
};

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

}  // namespace cullscope::software
