#include "core/measure/single_frames.h"

#include "core/measure/render_frame.h"

namespace cullscope {

SingleFrames::SingleFrames(const ScenePointer& scene, Upload upload, const Viewport& size)
    : m_buffers(std::make_shared<const SceneBuffers>(scene, upload)), m_target(size) {}
SingleFrames::~SingleFrames() = default;

SingleFrames::Frame SingleFrames::draw(const BuiltStrategy& strategy, const View& view, const View* before,
                                       const std::stop_token& stop) {
    const ViewStatePointer memory = strategy.begin();
    const auto one = [&](const View& which) {
        ++m_drawn;
        return renderFrame(m_renderer, *m_buffers, strategy, *memory, which, m_target, {}, stop);
    };
    if (before != nullptr && strategy.info().remembers) (void)one(*before);
    FrameResult frame = one(view);
    return {std::move(frame.log), frame.frameMilliseconds};
}

JudgedFrame SingleFrames::judge(const BuiltStrategy& strategy, const FrameLog& log) {
    const View view(log.camera, log.size);
    m_references.keep([&](const ScenePointer&, const Camera& camera, const Viewport&) { return camera == log.camera; });
    const auto truth = m_references.of(m_renderer, *m_buffers, view, strategy.referenceFacing());
    return cullscope::judge(m_renderer, *m_buffers, log, *truth, m_target);
}

}  // namespace cullscope
