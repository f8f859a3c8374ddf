#pragma once

#include <memory>

#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/visibility/built_strategy.h"

namespace cullscope {

/// Single frames of a scene, for what decides from frame to frame what it draws next, as an advice or a search does; a table is
/// measured by the Meter. Needs the same current context in every call.
class SingleFrames {
public:
    SingleFrames(const ScenePointer& scene, Upload upload, const Viewport& size);
    ~SingleFrames();

    struct Frame {
        FrameLog log;
        double milliseconds = 0.0;  ///< cull + draw, as everywhere
    };
    /// A frame of a view without a past; `before`: the view that a strategy that remembers draws first, uncounted. Throws what
    /// the strategy throws, and Error(Interrupted) on a stop request.
    [[nodiscard]] Frame draw(const BuiltStrategy& strategy, const View& view, const View* before, const std::stop_token& stop);
    /// Compares a frame of a strategy with the truth of its view. The truths of the newest view are kept.
    [[nodiscard]] JudgedFrame judge(const BuiltStrategy& strategy, const FrameLog& log);

    /// How many frames were drawn.
    [[nodiscard]] size_t drawn() const { return m_drawn; }

private:
    std::shared_ptr<const SceneBuffers> m_buffers;
    Renderer m_renderer;
    Framebuffer m_target;
    References m_references;
    size_t m_drawn = 0;
};

}  // namespace cullscope
