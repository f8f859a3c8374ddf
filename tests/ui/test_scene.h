#pragma once

#include <QColorSpace>
#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <functional>
#include <thread>

#include "core/scene/scene_source.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// How long a test waits for something that takes a moment; generous, because a busy machine is no error.
inline constexpr int kPatience = 60'000;  // ms

/// A session on the generators alone.
/// Views are measured in one round after a short rest: no test of these sessions asks how fast a strategy is.
inline Session::Options sessionOptions(bool graphics) {
    Session::Options options;
    options.restBeforeMeasuring = 20;
    options.rounds = {1, 1, 0.0};
    options.graphics = graphics;
    return options;
}

inline bool waitUntil(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); }

/// An image that equals another wherever their pixels do: without the colour space that files state.
inline QImage pixelsAlone(const QImage& image, QImage::Format format = QImage::Format_RGBA8888) {
    QImage pixels = image.convertToFormat(format);
    pixels.setColorSpace(QColorSpace());
    return pixels;
}

/// Opens a scene and waits for it.
inline void openAndWait(Session& session, const QString& specification) {
    session.open(specification);
    ASSERT_TRUE(waitUntil([&] { return !session.loader().loading(); }));
}

}  // namespace cullscope::ui
