// The plane that cuts pictures: what it changes, and what it leaves.
#include <gtest/gtest.h>

#include "tests/ui/test_scene.h"
#include "ui/dialogs/section_dialog.h"
#include "ui/session/session_state.h"
#include "ui/views/scene_view.h"

#include <QCheckBox>
#include <QSlider>

namespace cullscope::ui::section_test {
namespace {

struct SectionOfViews : ::testing::Test {
    void SetUp() override {
        for (SceneView* shown : {&view, &other}) {
            shown->resize(400, 300);
            shown->show();
        }
        ASSERT_TRUE(waitUntil([&] { return session.viewport(0).width > 1 && session.viewport(1).width > 1; }));
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=320,n=3,spacing=3"));
        for (const int each : {0, 1}) session.slot(each).choose("frustum");
        settle();
    }
    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            for (const int each : {0, 1})
                if (session.slot(each).building() || !session.pictures()->isCurrent(each)) return false;
            return session.metricsSettled();
        }));
    }
    [[nodiscard]] size_t covered() const {
        const std::vector<float>& depth = session.picture(0)->depth;
        return depth.size() - size_t(std::count(depth.begin(), depth.end(), 0.0f));
    }

    Session session{sessionOptions(true)};
    SceneView view{session, 0}, other{session, 1};
};

TEST_F(SectionOfViews, cutsThePictureAndNoFigure) {
    const size_t whole = covered();
    const uint64_t submitted = session.picture(0)->consideredTriangles;
    const ViewMetrics before = session.figures(0);
    session.setSection(Section{Section::Axis::X, 0.5, false});
    settle();
    EXPECT_LT(covered(), whole);
    EXPECT_GT(covered(), 0u);
    EXPECT_EQ(session.picture(0)->consideredTriangles, submitted);
    EXPECT_EQ(session.figures(0).accuracy.missedPixels, before.accuracy.missedPixels);
    EXPECT_EQ(session.figures(0).accuracy.visibleTriangles, before.accuracy.visibleTriangles);
    const size_t half = covered();
    session.setSection(Section{Section::Axis::X, 0.5, true});
    settle();
    EXPECT_NE(covered(), half);
    session.setSection(std::nullopt);
    settle();
    EXPECT_EQ(covered(), whole);
}

TEST_F(SectionOfViews, aPickHitsWhatTheCutPictureShows) {
    session.setSection(Section{Section::Axis::View, 0.5, false});
    settle();
    const ViewPicturePointer shown = session.picture(0);
    const Plane plane = sectionPlane(*session.section(), session.scene()->bounds(), session.camera());
    const int width = shown->request.size.width;
    size_t picks = 0;
    for (size_t pixel = 0; pixel < shown->depth.size(); pixel += 401) {
        if (!(shown->depth[pixel] > 0.0f)) continue;
        const auto picked = session.pictures()->pickNow(shown->request, int(pixel) % width, int(pixel) / width);
        ASSERT_TRUE(picked);
        EXPECT_GT(plane.distance(picked->point), -1e-3);
        ++picks;
    }
    EXPECT_GT(picks, 5u);
}

TEST_F(SectionOfViews, isKeptByTheStateAndEndsWithTheScene) {
    session.setSection(Section{Section::Axis::Z, 0.3, true});
    const SessionState state = captureState(session);
    session.setSection(std::nullopt);
    applyState(session, state);
    EXPECT_EQ(session.section(), (Section{Section::Axis::Z, 0.3, true}));
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    EXPECT_FALSE(session.section());
}

TEST_F(SectionOfViews, theDialogSetsAndFollowsIt) {
    SectionDialog dialog(session);
    EXPECT_FALSE(session.section());
    dialog.begin();
    ASSERT_TRUE(session.section()) << "opening it cuts";
    auto* place = dialog.findChild<QSlider*>();
    place->setValue(place->maximum() / 4);
    EXPECT_DOUBLE_EQ(session.section()->share, 0.25);
    session.setSection(Section{Section::Axis::Y, 0.123456, true});
    EXPECT_EQ(place->value(), 123);
    const QList<QCheckBox*> boxes = dialog.findChildren<QCheckBox*>();
    ASSERT_EQ(boxes.size(), 2);
    boxes.last()->setChecked(false);
    EXPECT_EQ(session.section(), (Section{Section::Axis::Y, 0.123456, false})) << "a share between two steps is kept";
    boxes.first()->setChecked(false);
    EXPECT_FALSE(session.section());
    EXPECT_FALSE(place->isEnabled());
    boxes.first()->setChecked(true);
    EXPECT_EQ(session.section(), (Section{Section::Axis::Y, 0.123456, false}));
}

}  // namespace
}  // namespace cullscope::ui::section_test
