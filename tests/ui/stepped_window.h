#pragma once

#include "core/frame/decided_ahead.h"
#include "core/image/view_picture.h"
#include "tests/ui/shown_window.h"

namespace cullscope::ui {

/// A window whose active view is stepped.
struct SteppedWindow : Window {
    void settleAll() {
        ASSERT_TRUE(waitUntil([&] {
            return session.buffers() && !session.slot(0).building() && !session.slot(1).building() && session.metricsSettled() &&
                   !session.pictures()->busy();
        }));
        QApplication::processEvents();
    }

    /// Starts stepping and waits until the view shows the first step of the frame that it has beside the bar.
    void begin() {
        window.actions().stepThrough->trigger();
        ASSERT_TRUE(waitUntil([&] {
            return stepper().place() && session.step() && session.pictures()->isCurrent(0) &&
                   session.picture(0)->request.frame().sameFrame(session.step()->frame->request);
        }));
        settleAll();
    }

    void showStep(size_t step) {
        stepper().jump(step);
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
    }
    [[nodiscard]] QImage shown() { return pixelsAlone(session.picture(0)->colour); }

    /// What `cullbench render --step` draws of the first entries of a log.
    [[nodiscard]] QImage replay(size_t entries) { return pictureOf(replayUpTo(session.step()->frame->log, entries)); }

    [[nodiscard]] QImage pictureOf(const FrameLog& log) {
        const ViewRequest request = *session.viewRequest(0);
        std::vector<uint8_t> pixels;
        session.gpu()->run([&] {
            Renderer renderer;
            Framebuffer target(request.size);
            drawViewPicture(renderer, *request.buffers, *request.strategy, log, View(request.viewing, request.size), nullptr,
                            request.look, request.style, target);
            pixels = target.readColour();
        });
        const QImage image(pixels.data(), request.size.width, request.size.height, QImage::Format_RGBA8888);
        return pixelsAlone(image.mirrored().copy());
    }

    Stepper& stepper() { return window.stepper(); }
};

}  // namespace cullscope::ui
