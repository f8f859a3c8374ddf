#include "core/visibility/single_triangles.h"

#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

// Where the picture has more pixels than these for each triangle, few triangles hold no pixel centre.
constexpr uint64_t kMostPixelsOfTriangle = 4;
// Triangles are left out one by one where at least this share of them is, those that face away counted half, for OpenGL drops
// them early: the others are drawn in the order of the parts, have fewer vertices in common, and so cost more each.
constexpr double kLeastShareLeftOut = 0.25, kWeightOfAway = 0.5;

}  // namespace

std::optional<SampledTriangles::Found> leaveOutTriangles(const FrameContext& frame, const PixelCover& cover, uint32_t instance,
                                                         const CornerBlocks& corners, std::span<const PlaceRun> drawn) {
    const EyeBox box = relativeToEye(frame.scene().instanceBox(instance), frame.view().eye());
    if (drawn.empty() || cover.of(box) > kMostPixelsOfTriangle * triangleCount(drawn)) return std::nullopt;
    const SampledTriangles test(frame.scene(), instance, corners, frame.view(), frame.facing());
    if (test.estimatedShare(drawn, kWeightOfAway) < kLeastShareLeftOut) return std::nullopt;
    return test.among(drawn, frame.recording());
}

void addLeftOut(const SampledTriangles::Found& found, CulledByCause& culled) {
    culled[size_t(Cause::BackFacing)] += found.facingAway;
    culled[size_t(Cause::NoSample)] += found.withoutSample;
}

void sayLeftOut(const SampledTriangles::Found& found, std::span<const PlaceRun> drawn, uint8_t line, ObjectRecord& record) {
    auto next = found.leftOut.begin();
    for (const PlaceRun& run : drawn) {
        auto triangles = std::make_shared<LeftOutTriangles>();
        while (next != found.leftOut.end() && next->places.first < run.first + run.count) triangles->runs.push_back(*next++);
        Decision test;
        test.subject = Subject::ofTriangles(run.first, record.subject().number);
        test.places = run;
        test.nesting = 1;
        test.sentence =
            CULLSCOPE_TR("Of these %1 triangles %2 face away and %3 hold no pixel centre: they are left out one by one.");
        test.operands = {double(run.count), double(triangles->count(Cause::BackFacing)),
                         double(triangles->count(Cause::NoSample))};
        test.operandCount = 3;
        record.say(atLine(line, test));
        record.attach(std::move(triangles));
    }
}

uint64_t triangleCount(std::span<const PlaceRun> runs) {
    uint64_t sum = 0;
    for (const PlaceRun& run : runs) sum += run.count;
    return sum;
}

}  // namespace cullscope
