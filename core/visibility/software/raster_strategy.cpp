#include "core/visibility/software/raster_strategy.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/raster/shown_triangles.h"
#include "core/visibility/software/triangle_fates.h"
#include "core/visibility/why.h"

namespace cullscope::software {
namespace {

constexpr const char* kParallel = "parallel";

}  // namespace

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

PlaceRun pixelsOf(const FrameContext& frame, int firstRow, int endRow, int begin, int end) {
    if (firstRow >= endRow || begin >= end) return {};
    const int width = frame.view().viewport().width;
    const auto first = uint32_t(firstRow * width + begin), last = uint32_t((endRow - 1) * width + end - 1);
    return {first, last - first + 1};
}

uint64_t sumAtLine(const FrameLog& log, Subject::Kind kind, uint8_t line, size_t operand) {
    double sum = 0.0;
    for (const Decision& decision : log.decisions)
        if (decision.line == line && decision.subject.kind == kind) sum += decision.operands[operand];
    return uint64_t(sum);
}

ParameterDeclaration parallelParameter() {
    return booleanParameter(
        kParallel, true,
        CULLSCOPE_TR("Whether parts of the picture are drawn on all processors at once; the picture is the same."));
}

EntryNames RasterSubjects::names(const StructureSnapshot& /*snapshot*/, const Decision& decision, size_t /*number*/) const {
    EntryNames names;
    if (decision.places.count == 0) return names;
    uint64_t first = decision.places.first, last = first + decision.places.count - 1;
    if (decision.subject.kind == Subject::Kind::Rows && m_width > 0) {
        first /= m_width;
        last /= m_width;
    } else if (decision.subject.kind == Subject::Kind::Triangles) {
        first += m_scene->firstTriangle(decision.subject.object);
        last += m_scene->firstTriangle(decision.subject.object);
    } else {
        return names;
    }
    if (first < last) names.subject = std::to_string(first) + "–" + std::to_string(last);
    return names;
}

void RasterStrategy::addWhySteps(const Structure& /*structure*/, const FrameLog& log, uint32_t instance, uint32_t triangle,
                                 std::vector<WhyStep>& steps) const {
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Triangles || decision.subject.object != instance) continue;
        if (decision.outcome != Decision::Outcome::Culled) continue;
        if (triangle - decision.places.first < decision.places.count)
            steps.push_back({{decision.sentence, {}}, {}, {}, {}, Containment::Outside});
    }
}

void RasterStrategy::fill(NoStructure& structure, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const {
    structure.report.figures = {{"objects", double(structure.scene().instances().size())}};
}

void RasterStrategy::decide(FrameContext& frame, const NoStructure& /*structure*/, ViewState& /*state*/,
                            const ParameterSet& parameters) const {
    const bool parallel = parameters.boolean(kParallel);
    const Progress progress{nullptr, frame.stop()};
    SceneOnRaster raster;
    {
        const StageTimer stage(frame, CULLSCOPE_TR("triangles to the raster"));
        raster = trianglesOnRaster(frame.scene(), frame.view(), frame.facing(), parallel, availableRasterSimd().back(), progress);
    }
    if (frame.recording()) sayTriangles(frame, raster.fates);
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

StructureSnapshot RasterStrategy::snapshotOf(const NoStructure& structure, const FrameLog& log) const {
    StructureSnapshot snapshot;
    snapshot.places = std::make_shared<RasterSubjects>(structure.scenePointer(), log);
    return snapshot;
}

/// Says how many of each object's triangles come to the raster.
void RasterStrategy::sayTriangles(FrameContext& frame, const std::vector<uint8_t>& fates) const {
    const std::vector<FateCounts> counts = countFates(frame.scene(), fates);
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
void RasterStrategy::end(FrameContext& frame, const std::vector<uint8_t>& fates) const {
    const std::vector<FateCounts> counts = countFates(frame.scene(), fates);
    size_t runsLeft = kMostRunsSaid;
    bool allSaid = true;
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
            allSaid = sayFates(frame, i, fates, uint8_t(objectLines().shown), runsLeft) && allSaid;
        const auto outcome = shown == triangles ? Decision::Outcome::Drawn
                             : shown > 0        ? Decision::Outcome::PartlyDrawn
                                                : Decision::Outcome::Culled;
        Decision decision = ending(Subject::ofObject(i), triangles == 0 ? Decision::Outcome::Culled : outcome, causeOf(most));
        decision.containment = shown == 0 ? Containment::Outside : Containment::Straddles;
        frame.say(atLine(objectLines().shown, decision));
    }
    if (!allSaid)
        frame.sayCoarser({CULLSCOPE_TR("causes by object, above %1 groups of triangles"), {std::to_string(kMostRunsSaid)}});
}

}  // namespace cullscope::software
