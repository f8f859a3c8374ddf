#include "core/visibility/occlusion/cluster_occlusion.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope::occlusion {
namespace {

Decision testOf(const char* sentence, std::initializer_list<double> operands, bool hidden = false) {
    Decision test;
    test.containment = hidden ? Containment::Outside : Containment::Straddles;
    test.cause = Cause::Hidden;
    test.sentence = sentence;
    std::ranges::copy(operands, test.operands.begin());
    test.operandCount = uint8_t(operands.size());
    return test;
}

/// A question with its answer.
Decision asked(const OcclusionBuffer& buffer, const AskedBox& box, bool hidden, const View& view) {
    if (!box.place)
        return testOf(CULLSCOPE_TR("Its box, grown by %1, reaches before the near plane or lies beside the picture: it counts as "
                                   "visible."),
                      {box.growth});
    const BoxInPicture& place = *box.place;
    const double pixels = double(place.endColumn - place.firstColumn) * double(place.endRow - place.firstRow);
    const float farthest = buffer.farthestIn(place);
    if (!(farthest > 0.0f))
        return testOf(CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: one of them shows no "
                                   "occluder, so it counts as visible."),
                      {box.growth, box.nearest, pixels}, hidden);
    return testOf(hidden ? CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show occluders, "
                                        "the farthest %4 ahead, which hide it.")
                         : CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show occluders, "
                                        "but the farthest is %4 ahead, so it counts as visible."),
                  {box.growth, box.nearest, pixels, view.distanceFromDepth(farthest)}, hidden);
}

/// Draws the largest triangles of an object into the buffer, as far as the options go; returns how many.
size_t occlude(uint32_t instance, const Occluders& occluders, const FrameContext& frame, const OccluderOptions& options,
               OcclusionBuffer& buffer) {
    const Scene& scene = frame.scene();
    const uint64_t left = options.triangles - std::min(options.triangles, buffer.counts().given);
    const auto count = std::min<size_t>(occluders.countFrom(scene, instance, frame.view(), options.pixels), left);
    if (count == 0) return 0;
    const OccluderMesh& mesh = occluders.meshes[scene.instances()[instance].mesh];
    buffer.draw(scene, instance, frame.facing(), std::span(mesh.positions).first(mesh.vertices[count - 1]),
                std::span(mesh.indices).first(3 * count));
    return count;
}

}  // namespace

OccluderResult keepUnhidden(std::vector<KeptObject>& nearestFirst, const Occluders& occluders, FrameContext& frame,
                            const OccluderOptions& options, OcclusionBuffer& buffer) {
    OccluderResult result;
    buffer.begin(frame.view());
    const auto say = [&](uint32_t instance, uint8_t line, Decision decision) {
        decision.subject = Subject::ofObject(instance);
        frame.say(atLine(line, decision));
    };
    std::erase_if(nearestFirst, [&](const KeptObject& object) {
        if (!buffer.empty()) {
            const AskedBox box = askedBox(buffer, frame.scene().instanceBox(object.instance), frame.view());
            const bool hidden = box.place && buffer.hides(*box.place);
            ++result.questions;
            if (frame.recording()) say(object.instance, options.lines.hidden, asked(buffer, box, hidden, frame.view()));
            if (hidden) {
                result.hiddenTriangles += frame.scene().meshOf(object.instance).triangleCount();
                if (frame.recording())
                    say(object.instance, options.lines.hidden, ending({}, Decision::Outcome::Culled, Cause::Hidden));
                return true;
            }
        }
        const size_t count = occlude(object.instance, occluders, frame, options, buffer);
        result.occluders += count > 0 ? 1 : 0;
        if (count > 0 && frame.recording())
            say(object.instance, options.lines.occlude,
                testOf(CULLSCOPE_TR("Its %1 largest triangles go into the buffer: facing the eye at its nearest point each has "
                                    "at least %2 pixels."),
                       {double(count), options.pixels}));
        return false;
    });
    return result;
}

HidingTest::Reach BufferHiding::test(const Vec3& middle, const Vec3& half, Decision* said) const {
    const EyeBox box{m_object.linear * middle + m_object.centre, m_spread * half};
    const AskedBox question = askedBox(m_buffer, box, m_object.margin, m_view);
    const bool hidden = question.place && m_buffer.hides(*question.place);
    if (said != nullptr) *said = asked(m_buffer, question, hidden, m_view);
    return hidden ? Reach::Hidden : Reach::Open;
}

}  // namespace cullscope::occlusion
