#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <map>

#include "core/image/picture_file.h"
#include "tests/ui/test_scene.h"
#include "ui/dialogs/screenshot_taker.h"

namespace cullscope::ui {

using Behind = ScreenshotOptions::Background;

inline const Viewport kShown{480, 360};

/// Options for the pictures without overlays, legend and caption.
inline ScreenshotOptions bare() {
    ScreenshotOptions options;
    options.overlays = options.legend = options.caption = false;
    return options;
}

/// All pairs that a picture's file has, names with "cullscope:".
inline std::map<std::string, std::string> metadataOf(const QString& file) {
    const PictureMetadata pairs = readPicture(file.toStdString()).metadata;
    return {pairs.begin(), pairs.end()};
}

inline PictureExtras noExtras(int) { return {}; }

/// Two views on a field of spheres, with complete pictures and metrics, and a folder for screenshots.
struct ScreenshotTest : ::testing::Test {
    void SetUp() override {
        QSettings().remove(QStringLiteral("screenshot"));
        for (int view = 0; view < Session::kMostViews; ++view) session.setViewport(view, kShown);
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=320,n=5,spacing=3"));
        session.slot(0).choose("frustum");
        session.slot(1).choose("frustum");
        session.setActiveView(0);
        session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 1.0));
        settle();
    }

    /// Makes view 1 an observer of view 0, coloured by verdict.
    void observe() {
        session.observe(1, 0);
        ViewSetup setup = session.setup(1);
        setup.look = {"verdicts", "frustum"};
        session.setSetup(1, setup);
        session.setActiveView(1);
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            for (const int view : session.shownViews())
                if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
            return session.metricsSettled();
        }));
    }

    ScreenshotSettings settings(const ScreenshotOptions& options, const QString& pattern) {
        return {options, folder.path(), pattern};
    }

    /// Takes a screenshot and returns its file; empty: it failed, and `failure` holds the message.
    QString taken(const ScreenshotOptions& options, const QString& pattern = QStringLiteral("{n}.png")) {
        ScreenshotTaker taker(session);
        taker.setSessionText([this] { return sessionText; });
        QString file;
        failure = {};
        QObject::connect(&taker, &ScreenshotTaker::done, [&](const QString& path) { file = path; });
        QObject::connect(&taker, &ScreenshotTaker::failed, [&](const Message& message) { failure = message; });
        taker.take(settings(options, pattern));
        EXPECT_TRUE(waitUntil([&] { return !taker.busy(); }));
        return file;
    }

    [[nodiscard]] QStringList files() const { return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System); }

    QImage image(const QString& file) { return pixelsAlone(QImage(file)); }
    QImage shownImage(int view) { return session.picture(view)->colour.convertToFormat(QImage::Format_RGBA8888); }

    QTemporaryDir folder;
    std::string sessionText = "{}";
    Message failure;
    Session session{sessionOptions(true)};
};

}  // namespace cullscope::ui
