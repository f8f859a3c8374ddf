// A view's figures are those of its own picture size: the same wherever, and however large, the window shows its picture.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QSettings>
#include <random>

#include "core/scene/camera_moves.h"
#include "tests/ui/cullbench_measure.h"
#include "tests/ui/eight_views.h"
#include "ui/models/metrics_words.h"
#include "ui/screenshots/screenshot_plan.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/text/wording.h"

namespace cullscope::ui::honest_figures_test {
namespace {

/// What is counted of a view, which no busy machine changes.
struct Counted {
    Viewport size;
    uint64_t submitted = 0, considered = 0, missed = 0, covered = 0, visible = 0;

    explicit Counted(const ViewMetrics& figures)
        : size(figures.size),
          submitted(figures.submitted.triangles),
          considered(figures.consideredTriangles),
          missed(figures.accuracy.missedPixels),
          covered(figures.accuracy.coveredPixels),
          visible(figures.accuracy.visibleTriangles) {}
    bool operator==(const Counted&) const = default;
};

struct HonestFigures : EightViews {
    void SetUp() override {
        EightViews::SetUp();
        setSizes(kUsualPictureSize);
    }
    void expectSame(const Counted& kept, const char* where) {
        settle();
        const ViewMetrics& figures = session.figures(0);
        ASSERT_EQ(figures.state, ViewMetrics::State::Ready) << where;
        EXPECT_EQ(Counted(figures), kept) << where << ": " << figures.size.width << " x " << figures.size.height;
        const QString header = window.views().pane(0).header().secondLine();
        EXPECT_EQ(header, metricsLine(figures)) << where;
    }
};

TEST(PictureSize, isStatedFromTheBeginning) {
    Session::Options options = sessionOptions(false);
    options.pictureSize = Session::Options().pictureSize;
    const Session session(options);
    for (int view = 0; view < Session::kMostViews; ++view) EXPECT_EQ(session.renderSize(view), (Viewport{640, 480})) << view;
}

TEST(PictureSize, isStatedInEveryStepOfEveryLesson) {
    for (const QString& name : LessonPlayer::known()) {
        const Lesson lesson = LessonPlayer::read(name);
        for (size_t step = 0; step < lesson.steps.size(); ++step)
            for (int view = 0; view < Session::kMostViews; ++view)
                EXPECT_TRUE(lesson.steps[step].state.views[size_t(view)].setup.size)
                    << name.toStdString() << ", step " << step + 1 << ", view " << view;
    }
}

TEST_F(HonestFigures, areTheSameInExploreCompareLectureWithStatisticsInAScreenshotAndInCullbench) {
    open(kObjects);
    session.setActiveView(0);
    session.slot(0).choose("spherical");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 1.0));
    settle();
    const Counted kept(session.figures(0));
    EXPECT_EQ(kept.size, (Viewport{640, 480}));
    EXPECT_GT(kept.submitted, 100u);
    EXPECT_GT(kept.missed, 0u) << "a loss tells more than none";
    expectSame(kept, "explore");
    window.resize(1000, 600);
    expectSame(kept, "a smaller window");
    for (const int count : {1, 4, 8, 2}) {
        session.setViewCount(count);
        expectSame(kept, "other numbers of views");
    }
    window.statistics().show();
    expectSame(kept, "statistics");
    window.statistics().hide();
    window.actions().lecture->trigger();
    ASSERT_TRUE(window.lecture());
    window.lecture()->showNormal();
    window.lecture()->resize(1280, 720);
    expectSame(kept, "lecture");
    QTest::keyClick(window.lecture(), Qt::Key_R);
    ASSERT_TRUE(window.lecture()->revealed());
    QStringList asked;
    for (const QLabel* label : window.lecture()->findChildren<QLabel*>()) asked << label->text();
    const QString share = percentText(session.figures(0).submittedShare()) + QStringLiteral(" %");
    EXPECT_TRUE(asked.contains(QStringLiteral("Submitted: ") + share)) << asked.join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(asked.contains(QStringLiteral("Missed: ") + countText(kept.missed)))
        << asked.join(QLatin1Char('\n')).toStdString();
    window.lecture()->close();
    ASSERT_TRUE(waitUntil([&] { return !window.lecture(); }));
    expectSame(kept, "back in the window");

    ScreenshotOptions options;
    options.size = Viewport{3840, 2160};
    const ScreenshotPlan plan = planScreenshot(
        session, options, [](int) { return PictureExtras(); }, false);
    EXPECT_TRUE(plan.caption.contains(metricsLine(session.figures(0)))) << plan.caption.toStdString();
    EXPECT_TRUE(plan.caption.contains(QStringLiteral("figures at 640 × 480 pixels"))) << plan.caption.toStdString();

    const QJsonObject result = measuredByCullbench(picture(0).subject(), QStringLiteral("spherical"));
    const QJsonObject frame = firstFrameOf(result, "spherical");
    EXPECT_EQ(frame[QStringLiteral("submitted_triangles")].toDouble(), double(kept.submitted));
    EXPECT_EQ(frame[QStringLiteral("considered_triangles")].toDouble(), double(kept.considered));
    EXPECT_EQ(frame[QStringLiteral("missed_pixels")].toDouble(), double(kept.missed));
    EXPECT_EQ(frame[QStringLiteral("covered_pixels")].toDouble(), double(kept.covered));
}

TEST_F(HonestFigures, aClickPicksThePixelThatIsPaintedThere) {
    open(kScene);
    session.setActiveView(0);
    for (const QSize& size : {QSize(1366, 768), QSize(1000, 600), QSize(2000, 1300)}) {
        window.resize(size);
        settle();
        const PictureLayout layout = picture(0).pictureLayout();
        std::mt19937 random(7);
        int hits = 0;
        for (int i = 0; i < 12; ++i) {
            const int x = int(random() % 640), y = int(random() % 480);
            const QPointF place = layout.positionOf(Vec2(x + 0.5, y + 0.5));
            const Vec2 back = layout.pixelAt(place);
            EXPECT_EQ(int(back.x), x);
            EXPECT_EQ(int(back.y), y);
            const float depth = session.picture(0)->depth[size_t(y) * 640 + size_t(x)];
            const std::optional<Vec3> surface = picture(0).shownSurfaceAt(place);
            ASSERT_EQ(surface.has_value(), depth > 0.0f) << x << ", " << y;
            if (!surface) continue;
            const Vec3 expected = pointUnder(picture(0).camera(), Vec2(x + 0.5, y + 0.5), double(depth));
            EXPECT_LT(glm::length(*surface - expected), 1e-6 * glm::length(expected - session.camera().eye)) << x << ", " << y;
            session.setPick(std::nullopt);
            const QPoint whole = place.toPoint();
            QTest::mouseClick(&picture(0), Qt::LeftButton, {}, whole);
            const Vec2 clicked = layout.pixelAt(whole);
            const float under = session.picture(0)->depth[size_t(clicked.y) * 640 + size_t(clicked.x)];
            if (!(under > 0.0f)) continue;
            ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
            const Vec2 middle(std::floor(clicked.x) + 0.5, std::floor(clicked.y) + 0.5);
            const Vec3 seen = pointUnder(picture(0).camera(), middle, double(under));
            EXPECT_LT(glm::length(session.pick()->point - seen), 1e-5 * glm::length(seen - session.camera().eye));
            ++hits;
        }
        EXPECT_GT(hits, 2) << size.width();
    }
}

TEST_F(HonestFigures, theHeaderStatesSizeAndScale) {
    open(kScene);
    ViewHeader& header = window.views().pane(0).header();
    EXPECT_TRUE(header.toolTip().contains(QStringLiteral("640 × 480 pixels, shown at"))) << header.toolTip().toStdString();
    setSizes(std::nullopt);
    settle();
    EXPECT_TRUE(header.toolTip().contains(QStringLiteral("which fit the window"))) << header.toolTip().toStdString();
}

TEST_F(HonestFigures, theSizeOfAllPicturesIsChosenInTheViewMenuAndKeptForTheNextStart) {
    QSettings().clear();
    QMenu& menu = *window.actions().pictureSize;
    emit menu.aboutToShow();
    const auto action = [&](const QString& text) -> QAction* {
        for (QAction* each : menu.actions())
            if (each->text() == text) return each;
        return nullptr;
    };
    ASSERT_TRUE(action(QStringLiteral("640 × 480")));
    EXPECT_TRUE(action(QStringLiteral("640 × 480"))->isChecked());
    action(QStringLiteral("1280 × 720"))->trigger();
    for (int view = 0; view < Session::kMostViews; ++view) EXPECT_EQ(session.setup(view).size, (Viewport{1280, 720})) << view;
    emit menu.aboutToShow();
    EXPECT_TRUE(action(QStringLiteral("1280 × 720"))->isChecked());
    EXPECT_FALSE(action(QStringLiteral("640 × 480"))->isChecked()) << "one of them alone";
    action(QStringLiteral("Fits the window"))->trigger();
    EXPECT_EQ(session.setup(3).size, std::nullopt);
    window.setKeepsLayout(true);
    window.close();
    Session next(sessionOptions(true));
    next.setPictureSize({0, 1, 2, 3, 4, 5, 6, 7}, kUsualPictureSize);
    MainWindow later(next, language, appearance);
    ASSERT_TRUE(later.restoreLayout(true));
    for (int view = 0; view < Session::kMostViews; ++view) EXPECT_EQ(next.setup(view).size, std::nullopt) << view;
    QSettings().clear();
}

TEST_F(HonestFigures, aClickedPoseTakesTheSizeThatItWasMeasuredAt) {
    open(kScene);
    auto* panel = window.findChild<StatisticsPanel*>();
    ASSERT_TRUE(panel);
    ExperimentSettings settings;
    settings.path = "orbit:3";
    settings.size = {200, 150};
    settings.repetitions = 1;
    emit panel->startRequested(settings);
    ASSERT_TRUE(waitUntil([&] { return panel->result() && panel->result()->runs.front().frames.size() == 3; }));
    settle();
    emit panel->poseChosen(1);
    settle();
    for (const int view : session.shownViews()) EXPECT_EQ(session.renderSize(view), (Viewport{200, 150})) << view;
    const FrameMeasurement& measured = panel->result()->runs.front().frames[1];
    for (const int view : session.measuredViews())
        if (session.slot(view).id() == panel->result()->runs.front().strategy.id) {
            EXPECT_EQ(session.figures(view).submitted.triangles, measured.submitted.triangles);
            EXPECT_EQ(session.figures(view).accuracy.coveredPixels, measured.accuracy->coveredPixels);
        }
}

}  // namespace
}  // namespace cullscope::ui::honest_figures_test
