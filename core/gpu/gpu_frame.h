#pragma once

#include <utility>

#include "core/gpu/renderer.h"

namespace cullscope {

/// A frame on the current context: answers what a strategy asks OpenGL, and draws.
class GpuFrame final : public FrameContext {
public:
    /// Draws into `target`, which has the culling view's size, as the commands come.
    GpuFrame(Renderer& renderer, const SceneBuffers& buffers, const View& culling, Framebuffer& target, const DrawStyle& style,
             bool recording = false);
    /// Decides only: draws into a framebuffer of its own, and only if an answer depends on what was drawn.
    GpuFrame(Renderer& renderer, const SceneBuffers& buffers, const View& culling, bool recording = false);

protected:
    void execute(const Command& command) override;
    void executeChoice(const GpuChoice& choice, size_t command) override;
    void executeVisible(BoxTicket& ticket, const DrawList& candidates, size_t command) override;
    void readBack(FrameLog& log) override;
    [[nodiscard]] SelectedBoxes answerSelection(std::span<const EyeBox> boxes, size_t bufferWords) override;
    [[nodiscard]] std::vector<uint32_t> answerQuestion(std::span<const EyeBox> boxes, std::span<const uint32_t> ends,
                                                       BoxQuestion question) override;
    [[nodiscard]] BoxTicketPointer putQuestion(std::span<const EyeBox> boxes, std::span<const uint32_t> ends,
                                               BoxQuestion question) override;
    [[nodiscard]] std::optional<std::vector<uint32_t>> fetchAnswer(BoxTicket& ticket) override;
    [[nodiscard]] std::vector<PyramidReading> fetchReadings(BoxTicket& ticket) override;
    [[nodiscard]] std::vector<uint32_t> findVisible() override;

private:
    /// What the log gets as the draw list of a command when the frame ends.
    struct PendingChoice {
        size_t command = 0;
        std::optional<Renderer::Choice> choice;  ///< none: it is known
        DrawList known;

        [[nodiscard]] DrawList chosen() const { return choice ? choice->chosen() : known; }
    };

    /// Whether choices are drawn without waiting for them. From client memory OpenGL cannot draw indirectly.
    [[nodiscard]] bool drawsIndirectly() const {
        return m_target != nullptr && m_buffers.upload() == Upload::Vbo && m_renderer.drawsIndirectly();
    }
    void executeIndirectly(Renderer::Choice choice, size_t command);
    void executeKnown(DrawList list, size_t command);

    /// Whether the next command is the first that is drawn into the target, and clears it.
    [[nodiscard]] bool clearsNow() { return !std::exchange(m_cleared, true); }
    /// The target, with everything drawn that was logged.
    Framebuffer& drawn();

    Renderer& m_renderer;
    const SceneBuffers& m_buffers;
    DrawStyle m_style;
    Framebuffer* m_target = nullptr;  ///< null: nothing had to be drawn yet
    std::unique_ptr<Framebuffer> m_own;
    bool m_cleared = false;    ///< the target
    uint64_t m_reduction = 0;  ///< whose pyramid the target still looks like; 0: something was drawn since
    std::vector<PendingChoice> m_choices;
};

}  // namespace cullscope
