// Contour bands and the model in spherical coordinates in a window: their actions, and the actions that a picture of directions
// disables.
#include <gtest/gtest.h>

#include <QActionGroup>
#include <QPainter>

#include "core/image/spherical_model.h"
#include "tests/ui/test_scene.h"
#include "ui/look/appearance.h"
#include "ui/screenshots/screenshot_plan.h"
#include "ui/text/language.h"
#include "ui/views/picture_painter.h"
#include "ui/window/main_window.h"
#include "ui/window/view_menu.h"

namespace cullscope::ui::spherical_look_test {
namespace {

struct SphericalLook : ::testing::Test {
    void SetUp() override {
        window.resize(1100, 720);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        openAndWait(session, QStringLiteral("knot:triangles=4000"));
        session.setActiveView(0);
        session.slot(0).choose("spherical");
        settle();
    }
    void settle() {
        ASSERT_TRUE(waitUntil(
            [&] { return !session.slot(0).building() && session.pictures()->isCurrent(0) && session.metricsSettled(); }));
    }
    [[nodiscard]] QImage pictureAfter(QAction* action) {
        action->trigger();
        settle();
        return session.picture(0)->colour;
    }
    [[nodiscard]] SceneView& picture() { return window.views().pane(0).picture(); }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(SphericalLook, commandsChangeThePictureOfTheActiveViewOnly) {
    const QImage plain = session.picture(0)->colour;
    const QImage bands = pictureAfter(window.actions().show("bands"));
    EXPECT_TRUE(session.setup(0).look.shows("bands") && window.actions().show("bands")->isChecked());
    EXPECT_FALSE(session.setup(1).look.shows("bands")) << "of the active view only";
    const QImage model = pictureAfter(window.actions().show("spherical-model"));
    EXPECT_TRUE(session.setup(0).look.shows("spherical-model") && window.actions().show("spherical-model")->isChecked());
    EXPECT_TRUE(plain != bands && plain != model && bands != model);
    EXPECT_EQ(pictureAfter(window.actions().show("spherical-model")), bands);
    EXPECT_EQ(pictureAfter(window.actions().show("bands")), plain);
    session.setActiveView(1);
    session.setActiveView(0);
    EXPECT_FALSE(window.actions().show("bands")->isChecked());
}

TEST_F(SphericalLook, viewsMenuHasThem) {
    QMenu menu;
    ViewMenu filler(session, window.views().pane(0), window.actions(), menu);
    filler.addLook();
    const auto entry = [&](const QString& text) -> QAction* {
        for (QAction* action : menu.findChild<QMenu*>()->actions())
            if (action->text().remove(QLatin1Char('&')) == text) return action;
        return nullptr;
    };
    for (const QString& text : {QStringLiteral("Contour bands"), QStringLiteral("Model in spherical coordinates")}) {
        ASSERT_NE(entry(text), nullptr) << text.toStdString();
        EXPECT_FALSE(entry(text)->isChecked());
        entry(text)->trigger();
    }
    EXPECT_TRUE(session.setup(0).look.shows("bands") && session.setup(0).look.shows("spherical-model"));
}

TEST_F(SphericalLook, nothingThatACameraSeesLiesOverTheModel) {
    window.actions().show("boxes")->trigger();
    window.actions().show("verdicts")->trigger();
    window.actions().truth->trigger();
    const QImage model = pictureAfter(window.actions().show("spherical-model"));
    EXPECT_EQ(session.viewRequest(0)->look, (ViewLook{"spherical-model"}));
    EXPECT_EQ(session.viewRequest(0)->wipe, Wipe::Mode::None);
    EXPECT_FALSE(picture().axes()) << "the axes of a camera";
    EXPECT_EQ(picture().extras().wipe.mode, Wipe::Mode::None);
    EXPECT_FALSE(picture().surfaceAt(QPointF(picture().rect().center()))) << "a place in the scene under a direction";
    const Wipe wipe = session.setup(0).wipe;
    EXPECT_EQ(wipe.mode, Wipe::Mode::Truth) << "what was chosen before stays chosen";
}

TEST_F(SphericalLook, chipCountsNoLossesInDirections) {
    const auto chipSays = [&](const QString& words) { return window.views().pane(0).chipText().contains(words); };
    const QString counts = QStringLiteral("missed pixels");
    (void)pictureAfter(window.actions().loss);
    EXPECT_TRUE(chipSays(counts));
    (void)pictureAfter(window.actions().show("spherical-model"));
    EXPECT_FALSE(chipSays(counts));
    EXPECT_TRUE(session.picture(0)->marks.isNull());
    (void)pictureAfter(window.actions().show("spherical-model"));
    EXPECT_TRUE(chipSays(counts)) << "what was chosen before stays chosen";
}

TEST_F(SphericalLook, commandsWithoutEffectAreGrey) {
    const WindowActions& actions = window.actions();
    const std::array camerasOnly{actions.show("verdicts"),
                                 actions.show("frustum"),
                                 actions.show("boxes"),
                                 actions.show("bands"),
                                 actions.axes,
                                 actions.truth,
                                 actions.loss};
    const QString tip = actions.show("bands")->toolTip();
    (void)pictureAfter(actions.show("spherical-model"));
    for (const QAction* action : camerasOnly) {
        EXPECT_FALSE(action->isEnabled()) << action->text().toStdString();
        EXPECT_EQ(action->toolTip(), WindowActions::modelStandsInPlace()) << action->text().toStdString();
    }
    EXPECT_FALSE(actions.nextLoss->isEnabled());
    EXPECT_TRUE(actions.show("spherical-model")->isEnabled() && actions.freeze->isEnabled() && actions.loupe->isEnabled());
    session.setActiveView(1);
    EXPECT_TRUE(actions.show("bands")->isEnabled()) << "of the active view only";
    session.setActiveView(0);
    (void)pictureAfter(actions.show("spherical-model"));
    for (const QAction* action : camerasOnly) EXPECT_TRUE(action->isEnabled()) << action->text().toStdString();
    EXPECT_EQ(actions.show("bands")->toolTip(), tip);
}

TEST_F(SphericalLook, viewsMenuCallsThingsAsTheWindowsMenusDo) {
    QMenu menu;
    ViewMenu filler(session, window.views().pane(0), window.actions(), menu);
    filler.addLook();
    filler.addCameras();
    filler.addComparisons();
    QStringList texts;
    for (const QMenu* part : menu.findChildren<QMenu*>())
        for (const QAction* action : part->actions()) texts << action->text();
    const WindowActions& actions = window.actions();
    for (const QAction* action : {actions.freeze, actions.truth, actions.loss})
        EXPECT_TRUE(texts.contains(action->text())) << action->text().toStdString();
    for (const auto& [show, action] : actions.shows) EXPECT_TRUE(texts.contains(action->text())) << show->id;
}

TEST_F(SphericalLook, choicesThatExcludeEachOtherAreRadioItems) {
    QMenu menu;
    ViewMenu filler(session, window.views().pane(0), window.actions(), menu);
    filler.addStrategies();
    filler.addCameras();
    filler.addComparisons();
    filler.addSizes();
    filler.addUploads();
    int menus = 0;
    for (const QMenu* part : menu.findChildren<QMenu*>()) {
        ++menus;
        int checked = 0;
        for (const QAction* action : part->actions()) {
            if (!action->isCheckable()) continue;
            EXPECT_TRUE(action->actionGroup() && action->actionGroup()->isExclusive()) << action->text().toStdString();
            checked += action->isChecked() ? 1 : 0;
        }
        EXPECT_EQ(checked, 1) << part->title().toStdString();
    }
    EXPECT_EQ(menus, 5);
    // One comparison at most, in the window's menu, too; the same key ends it.
    session.setActiveView(0);
    const WindowActions& actions = window.actions();
    for (QAction* action : {actions.truth, actions.loss}) {
        action->trigger();
        EXPECT_TRUE(actions.truth->isChecked() != actions.loss->isChecked());
        EXPECT_TRUE(action->isChecked());
    }
    actions.loss->trigger();
    EXPECT_EQ(session.setup(0).wipe.mode, Wipe::Mode::None);
    EXPECT_FALSE(actions.truth->isChecked() || actions.loss->isChecked());
}

TEST_F(SphericalLook, viewsMenuGreysWhatHasNoEffect) {
    for (const bool model : {false, true}) {
        if (model) (void)pictureAfter(window.actions().show("spherical-model"));
        QMenu menu;
        ViewMenu filler(session, window.views().pane(0), window.actions(), menu);
        filler.addLook();
        filler.addComparisons();
        int enabled = 0, greyed = 0;
        for (const QMenu* part : menu.findChildren<QMenu*>())
            for (const QAction* action : part->actions()) {
                if (action->isSeparator()) continue;
                ++(action->isEnabled() ? enabled : greyed);
                if (model && !action->isEnabled()) {
                    EXPECT_EQ(action->toolTip(), WindowActions::modelStandsInPlace());
                }
            }
        EXPECT_EQ(model ? enabled : greyed, 1) << "the model's own entry; without it, what needs verdicts";
        EXPECT_GT(model ? greyed : enabled, 5);
    }
}

TEST_F(SphericalLook, scalesAndTheHintArePainted) {
    const auto inkOf = [&](const PictureExtras& extras) {
        const ViewPicturePointer shown = session.picture(0);
        QImage painted = shown->colour.convertToFormat(QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&painted);
        paintPicture(painter, painted.rect(), *shown, extras);
        painter.end();
        const QImage bare = shown->colour.convertToFormat(QImage::Format_ARGB32_Premultiplied);
        const MapArea area = sphericalModelArea(shown->request.size, shown->request.style);
        // The areas left of the map, at the ticks below it, farther below, and above it.
        std::array<int, 4> ink{};
        for (int y = 0; y < painted.height(); ++y)
            for (int x = 0; x < painted.width(); ++x) {
                if (painted.pixel(x, y) == bare.pixel(x, y)) continue;
                const int up = painted.height() - y;
                if (x < area.left - 5 && up > area.bottom) ++ink[0];
                if (up <= area.bottom - 5) ++ink[up > area.bottom - 20 ? 1 : 2];
                if (up > area.bottom + area.height + 2) ++ink[3];
            }
        return ink;
    };
    (void)pictureAfter(window.actions().show("spherical-model"));
    const PictureExtras extras = picture().extras();
    const std::array part = inkOf(extras);
    EXPECT_GT(part[0], 30) << "θ";
    EXPECT_GT(part[1], 60) << "φ";
    EXPECT_GT(part[2], 200) << "the hint";
    EXPECT_GT(part[3], 200) << "the colours of R";
    EXPECT_EQ(inkOf(PictureExtras{}), (std::array{0, 0, 0, 0})) << "without what lies over it";
    EXPECT_TRUE(session.picture(0)->partOfModel);
    session.slot(0).choose("all");
    settle();
    EXPECT_FALSE(session.picture(0)->partOfModel);
    const std::array whole = inkOf(extras);
    EXPECT_EQ(whole[0], part[0]);
    EXPECT_EQ(whole[3], part[3]);
    EXPECT_LT(whole[2], part[2] - 200) << "nothing is left out: no hint";
}

TEST_F(SphericalLook, clickPicksWhatLiesInThatDirection) {
    (void)pictureAfter(window.actions().show("spherical-model"));
    const Viewport size = session.viewRequest(0)->size;
    const Scene& scene = *session.opened()->scene;
    const Vec3 centre = scene.meshOf(0).localSphere().centre;
    // Clicks along the equator, parts of which the knot covers.
    int picked = 0;
    for (int x = size.width / 10; x < size.width; x += size.width / 10) {
        session.setPick(std::nullopt);
        session.pickAt(0, x, size.height / 2);
        if (!QTest::qWaitFor([&] { return session.pick().has_value(); }, 500)) continue;
        ++picked;
        const Vec3 outward = session.pick()->point - centre;
        EXPECT_NEAR(outward.z / glm::length(outward), 0.0, 0.05);
    }
    EXPECT_GT(picked, 2);
}

TEST_F(SphericalLook, screenshotWithoutOverlaysHasNoBands) {
    window.actions().show("bands")->trigger();
    settle();
    ScreenshotOptions options;
    const auto extras = [](int) { return PictureExtras{}; };
    EXPECT_TRUE(planScreenshot(session, options, extras, false).parts.front().request.look.shows("bands"));
    options.overlays = false;
    EXPECT_FALSE(planScreenshot(session, options, extras, false).parts.front().request.look.shows("bands"));
    options.overlays = true;
    (void)pictureAfter(window.actions().show("spherical-model"));
    EXPECT_FALSE(planScreenshot(session, options, extras, true).parts.front().wanted.items) << "directions have no depth";
    const auto shown = [this](int) { return picture().extras(); };
    const ScreenshotPlan plan = planScreenshot(session, options, shown, false);
    EXPECT_TRUE(plan.parts.front().extras.modelScales);
}

}  // namespace
}  // namespace cullscope::ui::spherical_look_test
