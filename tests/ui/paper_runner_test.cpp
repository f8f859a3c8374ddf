#include "ui/session/paper_runner.h"

#include <gtest/gtest.h>

#include <set>

#include "core/experiments/experiment_list.h"
#include "core/experiments/lecture_table.h"
#include "core/visibility/registry.h"
#include "tests/ui/test_scene.h"

namespace cullscope::ui::paper_runner_test {
namespace {

/// Table 2 with a generated scene and two settings, the second one in four windows.
Experiment smallTable(const std::string& path) {
    Experiment experiment = findExperiment("table-2");
    experiment.settings.resize(2);
    for (Setting& setting : experiment.settings) {
        setting.scene = "star:seed=7,triangles=500";
        setting.strategies = {"all", "backface", "frustum"};
        setting.shown = "frustum";
        setting.path = path;
        setting.views = {};
        setting.size = {64, 48};
    }
    experiment.settings[1].windows = 4;
    return experiment;
}

/// A session in a state that the user has changed, and a runner.
struct Papers : ::testing::Test {
    void SetUp() override {
        QObject::connect(&runner, &PaperRunner::ended, [this] { ++endings; });
        QObject::connect(&session, &Session::messageRaised,
                         [this](Severity, const Message& message) { messages.push_back(message.english()); });
        openAndWait(session, QStringLiteral("field:mesh=torus:triangles=300,n=3"));
        session.setViewCount(2);
        session.setActiveView(1);
        session.slot(0).choose("frustum");
        session.setSetup(1, ViewSetup{});
        ViewSetup small;
        small.size = Viewport{100, 80};
        session.setSetup(0, small);
        session.setHidden({false, true, false, false, false, false, false, false, true});
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(33.0), {}));
        session.setPick(Pick{2, 700, Vec3(1.0)});
        before = captureState(session);
        opened = session.opened();
    }

    void expectSessionIsBack() {
        EXPECT_EQ(session.opened(), opened);
        EXPECT_EQ(captureState(session), before);
        EXPECT_EQ(session.pick(), (Pick{2, 700, Vec3(1.0)}));
    }

    Session session{sessionOptions(true)};
    PaperRunner runner{session};
    SessionState before;
    OpenedScenePointer opened;
    int endings = 0;
    std::vector<std::string> messages;
};

TEST_F(Papers, sessionIsGivenBack) {
    const Experiment experiment = smallTable("fibonacci:3");
    runner.start(experiment, 1);
    EXPECT_TRUE(runner.running());
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_FALSE(runner.running());
    EXPECT_EQ(runner.table().rows.size(), 6u);
    EXPECT_FALSE(runner.table().interrupted);
    EXPECT_EQ(runner.table().triangles, 500u);
    expectSessionIsBack();
    EXPECT_TRUE(messages.empty()) << messages.front();
}

TEST_F(Papers, windowShowsWhatIsMeasured) {
    const Experiment experiment = smallTable("fibonacci:60");
    double last = 0.0;
    std::vector<Vec3> eyes;
    QObject::connect(&runner, &PaperRunner::progressed, [&](double share, const QString&) {
        EXPECT_GE(share, last - 1e-9);
        last = share;
    });
    QObject::connect(&session, &Session::cameraChanged, [&] {
        if (session.opened() != opened) eyes.push_back(session.camera().eye);
    });
    QObject::connect(&runner, &PaperRunner::tableChanged, [&] {
        if (runner.table().rows.empty()) return;
        const Setting& shown = experiment.settings[runner.table().rows.size() / 3 - 1];
        EXPECT_EQ(session.opened()->scene->triangleCount(), 500u);
        EXPECT_EQ(session.viewCount(), shown.windows);
        for (const int view : session.shownViews()) {
            EXPECT_EQ(session.slot(view).id(), "frustum");
            EXPECT_EQ(session.renderSize(view), (Viewport{64, 48}));
            EXPECT_EQ(session.setup(view).role, Role::Linked);
        }
    });
    runner.start(experiment, 20);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_GT(last, 0.5);
    // The initial camera and the first pose of each setting, and poses in between.
    EXPECT_GT(eyes.size(), 6u) << "the camera stands still";
}

TEST_F(Papers, buildingDoesNotCountAsMeasuring) {
    Experiment experiment = smallTable("fibonacci:3");
    experiment.settings.resize(1);
    experiment.settings[0].scene = "sphere:triangles=300000";
    experiment.settings[0].strategies = {"all", "backface", "spherical"};
    double last = 0.0;
    QObject::connect(&runner, &PaperRunner::progressed, [&](double share, const QString& stage) {
        EXPECT_GE(share, last) << stage.toStdString();
        EXPECT_TRUE(stage == QStringLiteral("measuring") || share < 0.05 + 1e-9) << stage.toStdString() << ": " << share;
        last = share;
    });
    runner.start(experiment, 1);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_EQ(runner.share(), last);
    EXPECT_EQ(runner.table().rows.size(), 3u);
}

TEST_F(Papers, cancelBetweenSettingsKeepsTheRows) {
    const Experiment experiment = smallTable("fibonacci:3");
    QObject::connect(&runner, &PaperRunner::tableChanged, [this] {
        if (runner.table().rows.size() == 3) runner.cancel();
    });
    runner.start(experiment, 1);
    ASSERT_TRUE(waitUntil([this] { return endings > 0; }));
    EXPECT_TRUE(runner.table().interrupted);
    EXPECT_EQ(runner.table().rows.size(), 3u);
    expectSessionIsBack();
    QTest::qWait(200);
    EXPECT_EQ(endings, 1);
}

TEST_F(Papers, cancelInTheMiddleOfASettingKeepsItsPoses) {
    const Experiment experiment = smallTable("walk:5000");
    QObject::connect(&runner, &PaperRunner::progressed, [this](double share, const QString&) {
        // Opening the scene takes a twentieth of the first half, and building a tenth of the rest: poses have been measured.
        if (share < 0.5 * 0.16) return;
        runner.cancel();
        runner.cancel();
    });
    runner.start(experiment, 1);
    ASSERT_TRUE(waitUntil([this] { return endings > 0; }));
    EXPECT_TRUE(runner.table().interrupted);
    EXPECT_EQ(runner.table().rows.size(), 3u) << "of the poses measured until then";
    expectSessionIsBack();
}

TEST_F(Papers, cancelAtOnceGivesTheSessionBack) {
    const Experiment experiment = smallTable("fibonacci:3");
    runner.start(experiment, 1);
    runner.cancel();
    EXPECT_EQ(endings, 1);
    expectSessionIsBack();
    QTest::qWait(300);
    expectSessionIsBack();
    EXPECT_TRUE(runner.table().rows.empty());
}

TEST_F(Papers, whatCannotBeMeasuredIsOneSentence) {
    Experiment experiment = smallTable("fibonacci:3");
    experiment.settings[1].strategies.push_back("no-such-strategy");
    experiment.settings[1].shown = "no-such-strategy";
    runner.start(experiment, 1);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_TRUE(messages.front().starts_with("There is no strategy \"no-such-strategy\".")) << messages.front();
    EXPECT_EQ(runner.table().rows.size(), 3u) << "what was measured before";
    expectSessionIsBack();

    experiment.settings[0].scene = "no-such-file.obj";
    runner.start(experiment, 1);
    ASSERT_TRUE(waitUntil([this] { return endings == 2; }));
    ASSERT_EQ(messages.size(), 2u);
    expectSessionIsBack();
}

TEST_F(Papers, sceneThatSomebodyOpensMeanwhileStays) {
    const Experiment experiment = smallTable("walk:5000");
    runner.start(experiment, 1);
    ASSERT_TRUE(waitUntil([this] { return session.opened() != opened; }));
    openAndWait(session, QStringLiteral("sphere:triangles=1000"));
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_EQ(session.opened()->specification, "sphere:triangles=1000");
}

TEST_F(Papers, structuresAreBuiltBesideTheWindow) {
    Experiment experiment = findExperiment("table-1");
    experiment.settings[0].scene = "sphere:triangles=5000";
    runner.start(experiment);
    EXPECT_TRUE(runner.table().rows.empty());
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_EQ(runner.table().rows.size(), 5u);
    expectSessionIsBack();
}

/// As any timed table: on the window's thread, between the pictures of the setting's views.
TEST_F(Papers, lectureTableIsMeasuredInTheWindow) {
    LectureTableSize size;
    size.overlaps = {2};
    size.surfaces = {10};
    size.views = {1, 3};
    size.size = {64, 48};
    size.repetitions = 1;
    const Experiment experiment = lectureTable(size);
    std::set<std::string> shown;
    QObject::connect(&session, &Session::cameraChanged, [&] {
        if (session.opened() != opened) shown.insert(session.opened()->specification + " " + session.slot(0).id());
    });
    runner.start(experiment);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    EXPECT_EQ(runner.table().rows.size(), 2 * lectureMethods().size());
    EXPECT_TRUE(shown.contains(experiment.settings[0].scene + " backface"));
    for (size_t row = 0; row < runner.table().rows.size(); ++row)
        EXPECT_EQ(numberOf(runner.table().value(row, "missed_pixels")), 0.0);
    expectSessionIsBack();
    EXPECT_TRUE(messages.empty()) << messages.front();
}

TEST_F(Papers, pointsComeBeforeTheEnd) {
    Experiment experiment = findExperiment("vfc-40-views");
    Setting& setting = experiment.settings[0];
    setting.scene = "field:mesh=star:triangles=500,n=3,spacing=2.5";
    setting.path = "walk:60";
    setting.size = {64, 64};
    std::vector<size_t> points;
    QObject::connect(&runner, &PaperRunner::plotsChanged, [&] {
        EXPECT_TRUE(runner.table().rows.empty());
        const std::vector<PlotLine>& lines = runner.table().plots.front().lines;
        EXPECT_GE(lines.size(), 5u);
        points.push_back(lines.front().points.size());
    });
    runner.start(experiment, 20);
    ASSERT_TRUE(waitUntil([this] { return endings == 1; }));
    ASSERT_FALSE(points.empty());
    EXPECT_LT(points.front(), 60u);
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
    EXPECT_EQ(runner.table().plots.front().lines.front().points.size(), 60u);
    EXPECT_EQ(runner.table().rows.size() + 1, runner.table().plots.front().lines.size()) << "what no culling can exceed";
    expectSessionIsBack();
    EXPECT_TRUE(messages.empty()) << messages.front();
}

TEST(PaperRunner, mayBeDestroyedInTheMiddle) {
    const Experiment experiment = smallTable("walk:5000");
    Session session{sessionOptions(true)};
    openAndWait(session, QStringLiteral("torus:triangles=300"));
    PaperRunner runner(session);
    runner.start(experiment, 1);
    QTest::qWait(200);
}

}  // namespace
}  // namespace cullscope::ui::paper_runner_test
