#pragma once

#include <gtest/gtest.h>

#include <QColorSpace>
#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <functional>
#include <thread>

#include "core/scene/scene_source.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Timeout of a test for asynchronous work; generous, because a busy machine is no error.
inline constexpr int kPatience = 60'000;  // ms

/// Options of a session that opens generators only. Views are measured in one round after a short rest: no test of these
/// sessions measures the speed of a strategy.
inline Session::Options sessionOptions(bool graphics) {
    Session::Options options;
    options.restBeforeMeasuring = 20;
    options.rounds.fixedRepetitions = 1;
    // Small pictures, whose sizes the tests' windows give: what a view's own size does has tests of its own.
    options.pictureSize.reset();
    options.waitForStep = kPatience;  // a busy machine may take longer for a picture than a person would wait
    options.graphics = graphics;
    return options;
}

inline bool waitUntil(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); }

/// The pixels of an image without the colour space that files state, so that images with equal pixels compare equal.
inline QImage pixelsAlone(const QImage& image, QImage::Format format = QImage::Format_RGBA8888) {
    QImage pixels = image.convertToFormat(format);
    pixels.setColorSpace(QColorSpace());
    return pixels;
}

/// Opens a scene and waits until it is loaded.
inline void openAndWait(Session& session, const QString& specification) {
    session.open(specification);
    ASSERT_TRUE(waitUntil([&] { return !session.loader().loading(); }));
}

}  // namespace cullscope::ui
