#include "core/visibility/software/triangle_fates.h"

#include <algorithm>
#include <span>

#include "core/base/message.h"

namespace cullscope::software {
namespace {

/// What is said of triangles with this fate.
const char* sentenceOf(uint8_t fate) {
    switch (fate) {
        case kOutside:
            return CULLSCOPE_TR("The triangle lies beyond a plane of the frustum.");
        case kFacingAway:
            return CULLSCOPE_TR("The triangle is turned away.");
        case kNoSample:
            return CULLSCOPE_TR("The triangle covers no sample: no centre of a pixel lies in it.");
        default:
            return CULLSCOPE_TR("At every sample that the triangle covers another surface is in front.");
    }
}

}  // namespace

std::vector<FateCounts> countFates(const Scene& scene, const std::vector<uint8_t>& fates) {
    std::vector<FateCounts> counts(scene.instances().size());
    for (size_t object = 0; object < counts.size(); ++object) {
        uint64_t next = scene.firstTriangle(object);
        const uint64_t end = next + scene.meshOf(object).triangleCount();
        while (next < end) {
            // Each fate has twelve bits of a number, so that up to 4,095 triangles are counted without a table.
            static_assert(12 * kTriangleFates <= 64);
            uint64_t packed = 0;
            for (const uint64_t stop = std::min<uint64_t>(end, next + 4095); next < stop; ++next)
                packed += 1ull << (12 * fates[next]);
            for (size_t fate = 0; fate < kTriangleFates; ++fate) counts[object][fate] += packed >> (12 * fate) & 4095;
        }
    }
    return counts;
}

Cause causeOf(uint8_t fate) {
    switch (fate) {
        case kOutside:
            return Cause::OutsideFrustum;
        case kFacingAway:
            return Cause::BackFacing;
        case kNoSample:
            return Cause::NoSample;
        default:
            return Cause::Hidden;
    }
}

bool sayFates(FrameContext& frame, uint32_t object, const std::vector<uint8_t>& fates, uint8_t line, size_t& left) {
    const std::span of =
        std::span(fates).subspan(frame.scene().firstTriangle(object), frame.scene().meshOf(object).triangleCount());
    std::vector<PlaceRun> runs;
    for (uint32_t first = 0, end = 0; first < of.size(); first = end) {
        for (end = first + 1; end < of.size() && of[end] == of[first];) ++end;
        if (of[first] != kShown) runs.push_back({first, end - first});
        if (runs.size() > left) return false;
    }
    left -= runs.size();
    for (const PlaceRun& run : runs) {
        const uint8_t fate = of[run.first];
        Decision decision = ending(Subject::ofTriangles(run.first, object), Decision::Outcome::Culled, causeOf(fate));
        decision.sentence = sentenceOf(fate);
        decision.places = run;
        decision.nesting = 1;
        frame.say(atLine(line, decision));
    }
    return true;
}

}  // namespace cullscope::software
