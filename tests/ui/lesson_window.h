#pragma once

#include <gtest/gtest.h>

#include "tests/ui/lesson_on_screen.h"
#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// Nothing is measured within a test's patience.
inline Session::Options withoutMeasuring() {
    Session::Options options = sessionOptions(true);
    options.restBeforeMeasuring = 100 * kPatience;
    return options;
}

/// A window in which lessons are shown, and what it says.
struct Lessons : ::testing::Test {
    explicit Lessons(const Session::Options& options = withoutMeasuring()) : session(options) {
        QObject::connect(&session, &Session::messageRaised, [this](Severity severity, const Message& message) {
            if (severity != Severity::Information) said.push_back(message.english());
        });
    }
    void SetUp() override {
        window.resize(1280, 720);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    }

    LessonPlayer& player() { return window.lessons().player(); }
    SceneView& picture(int view) { return window.views().pane(view).picture(); }

    [[nodiscard]] bool onScreen() { return lessonStepIsOnScreen(window, session); }
    void go(int step) {
        player().go(step);
        awaitStep();
    }
    /// Until the step in hand is on screen.
    void awaitStep() {
        ASSERT_TRUE(waitUntil([this] { return onScreen(); }))
            << player().lesson().title.at("en") << ", step " << player().step() + 1 << (said.empty() ? "" : ": " + said.back());
        QApplication::processEvents();
    }
    void begin(const QString& name) {
        player().begin(name);
        ASSERT_TRUE(player().active()) << (said.empty() ? "" : said.back());
        awaitStep();
    }

    Session session;
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
    std::vector<std::string> said;
};

}  // namespace cullscope::ui
