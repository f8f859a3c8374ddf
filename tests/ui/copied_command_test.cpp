// The copied `cullbench` command repeats a view's picture for all cameras and looks.
#include <gtest/gtest.h>

#include "tests/ui/cullbench_picture.h"
#include "ui/views/scene_view.h"

namespace cullscope::ui::copied_command_test {
namespace {

struct CopiedCommand : ::testing::Test {
    void SetUp() override {
        first.resize(400, 300);
        second.resize(400, 300);
        first.show();
        second.show();
        ASSERT_TRUE(waitUntil([&] { return session.viewport(0).width > 1 && session.viewport(1).width > 1; }));
        open(QStringLiteral("field:mesh=sphere:triangles=320,n=5,spacing=3"));
    }

    void open(const QString& scene) {
        openAndWait(session, scene);
        session.slot(0).choose("frustum");
        session.slot(1).choose("frustum");
        session.setCamera(zoomed(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(33.3), Angle::fromDegrees(7.7)),
                                 session.camera().target, 0.4, 1.0));
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            for (const int view : {0, 1})
                if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
            return session.metricsSettled();
        }));
    }

    void change(int view, const std::function<void(ViewSetup&)>& edit) {
        ViewSetup setup = session.setup(view);
        edit(setup);
        session.setSetup(view, setup);
        settle();
    }

    void expectSame(const SceneView& view) {
        const QImage drawn = pixelsAlone(view.picture(), QImage::Format_RGB888);
        EXPECT_EQ(cullbenchPicture(view.subject()), drawn) << cullbenchCommand(view.subject()).toStdString();
        int covered = 0;
        for (int y = 0; y < drawn.height(); ++y)
            for (int x = 0; x < drawn.width(); ++x) covered += drawn.pixel(x, y) != drawn.pixel(0, 0) ? 1 : 0;
        EXPECT_GT(covered, 500);
    }

    Session session{sessionOptions(true)};
    SceneView first{session, 0}, second{session, 1};
};

TEST_F(CopiedCommand, repeatsALinkedView) { expectSame(first); }

TEST_F(CopiedCommand, repeatsALinkedViewWithVerdicts) {
    change(0, [](ViewSetup& setup) { setup.look.show("verdicts", true); });
    expectSame(first);
}

TEST_F(CopiedCommand, repeatsAnObserverWithVerdictsBoxesAndFrustum) {
    session.observe(1, 0);
    change(1, [](ViewSetup& setup) { setup.look = {"verdicts", "frustum", "boxes"}; });
    expectSame(second);
    session.slot(0).choose("frustum-octree");
    change(1, [](ViewSetup& setup) { setup.look.showWithAll(commonShow(Show::Kind::Planes), true); });
    expectSame(second);
    session.slot(0).choose("frustum-query");
    settle();
    expectSame(second);
    // A strategy without boxes shows none, and the command has no option for them.
    session.slot(0).choose("backface");
    settle();
    expectSame(second);
}

TEST_F(CopiedCommand, repeatsAnObserverOfAnotherSizeThanWhatItWatches) {
    session.observe(1, 0);
    change(1, [](ViewSetup& setup) {
        setup.look = {"verdicts", "frustum"};
        setup.size = Viewport{333, 444};
    });
    expectSame(second);
}

TEST_F(CopiedCommand, repeatsFrozenCullingWithOnlyWhatWasDrawn) {
    session.setFrozen(0, true);
    session.setViewingCamera(0, turned(session.viewingCamera(0), UpAxis::Y, Angle::fromDegrees(90.0), {}));
    change(0, [](ViewSetup& setup) {
        setup.look = {"verdicts", "frustum"};
        setup.look.show("culled_too", false);
    });
    expectSame(first);
    change(0, [](ViewSetup& setup) { setup.look = {}; });
    expectSame(first);
}

TEST_F(CopiedCommand, repeatsAParallelViewAndItsObserver) {
    session.setCamera(inParallel(session.camera()));
    session.observe(1, 0);
    change(1, [](ViewSetup& setup) { setup.look = {"verdicts", "frustum", "boxes"}; });
    expectSame(first);
    expectSame(second);
}

TEST_F(CopiedCommand, repeatsASectionAndItsObserver) {
    session.observe(1, 0);
    change(1, [](ViewSetup& setup) { setup.look = {"verdicts", "frustum"}; });
    for (const Section& section : {Section{Section::Axis::X, 0.4, false}, Section{Section::Axis::View, 0.5, true}}) {
        const QImage before = first.picture();
        session.setSection(section);
        settle();
        EXPECT_NE(first.picture(), before);
        expectSame(first);
        expectSame(second);
    }
}

TEST_F(CopiedCommand, repeatsASphericalStrategysOverlays) {
    session.observe(1, 0);
    session.slot(0).choose("spherical");
    change(1, [](ViewSetup& setup) { setup.look = {"boxes", "bands"}; });
    EXPECT_TRUE(second.subject().look.shows("boxes") && second.subject().look.shows("bands"));
    expectSame(second);
    change(1, [](ViewSetup& setup) {
        setup.look.show("spherical-model", true);
        setup.wipe.mode = Wipe::Mode::Truth;
    });
    expectSame(second);
    // A strategy without bands shows none, and the command has no option for them.
    session.slot(0).choose("frustum");
    change(1, [](ViewSetup& setup) { setup.look.show("spherical-model", false); });
    EXPECT_FALSE(second.subject().look.shows("bands"));
}

TEST_F(CopiedCommand, repeatsAViewWithHiddenObjects) {
    std::vector<bool> hidden(session.hidden().size(), false);
    for (const size_t object : {1, 3, 4, 5, 20}) hidden[object] = true;
    session.setHidden(hidden);
    settle();
    EXPECT_EQ(first.subject().hidden, "1,3-5,20");
    expectSame(first);
}

TEST_F(CopiedCommand, repeatsAViewOfASplitScene) {
    open(QStringLiteral("split:mesh=torus:triangles=2000,by=clusters,triangles=200"));
    expectSame(first);
}

}  // namespace
}  // namespace cullscope::ui::copied_command_test
