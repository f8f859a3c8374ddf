// The camera path in hand: made, stepped, changed and kept, with the bar that shows it.
#include "ui/session/path_desk.h"

#include <QTemporaryDir>
#include <QToolButton>

#include "core/base/error.h"
#include "tests/ui/test_scene.h"
#include "ui/panels/path_bar.h"

namespace cullscope::ui::path_desk_test {
namespace {

struct Desk : ::testing::Test {
    Desk() {
        QObject::connect(&desk, &PathDesk::ownPathChanged, [this](const CameraPath& path) { own.push_back(path); });
    }
    void SetUp() override { openAndWait(session, QStringLiteral("field:n=4")); }
    void make(const QString& name) {
        desk.makeBuiltIn(name);
        EXPECT_EQ(desk.making(), name);
        ASSERT_TRUE(waitUntil([&] { return desk.making().isEmpty(); }));
    }
    void turn(double degrees) { session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(degrees), {})); }
    [[nodiscard]] Vec3 eyeOf(int pose) const { return desk.path().poses.at(size_t(pose)).eye; }

    Session session{sessionOptions(false)};
    PathDesk desk{session};
    PathBar bar{desk};
    std::vector<CameraPath> own;
};

TEST_F(Desk, everyBuiltInPathIsMadeBesideTheWindowAndStepped) {
    for (const BuiltInPath& path : builtInPaths()) {
        const QString name = QString::fromStdString(path.id).replace(QStringLiteral(":N"), QStringLiteral(":5"));
        make(name);
        EXPECT_EQ(desk.path().name, name.toStdString());
        EXPECT_FALSE(desk.player().playing());
        EXPECT_EQ(session.camera().eye, eyeOf(0)) << path.id;
        desk.step(1);
        // A path that the scene gives may have one pose.
        EXPECT_EQ(session.camera().eye, eyeOf(std::min(1, int(desk.path().poses.size()) - 1)));
        desk.step(-7);
        EXPECT_EQ(desk.player().pose(), 0) << "stays at the first";
        desk.go(1000);
        EXPECT_EQ(desk.player().pose(), int(desk.path().poses.size()) - 1);
        desk.stop();
        EXPECT_FALSE(bar.isVisibleTo(nullptr));
    }
    EXPECT_TRUE(own.empty()) << "a built-in path is none of the user's own";
}

TEST_F(Desk, theBarTellsThePlaceAndMovesTheCamera) {
    make(QStringLiteral("orbit:9"));
    EXPECT_EQ(bar.placeText(), QStringLiteral("1 of 9"));
    bar.slider().setValue(4);
    EXPECT_EQ(bar.placeText(), QStringLiteral("5 of 9"));
    EXPECT_EQ(session.camera().eye, eyeOf(4));
    EXPECT_EQ(bar.name().text(), QStringLiteral("orbit:9"));
}

TEST_F(Desk, recordingIsCountedAndThenInHand) {
    desk.recorder().start();
    EXPECT_TRUE(bar.chipText().contains(QStringLiteral("poses: 1"))) << bar.chipText().toStdString();
    for (int i = 0; i < 3; ++i) {
        turn(10);
        QTest::qWait(50);
    }
    const size_t poses = desk.path().poses.size();
    EXPECT_GE(poses, 3u);
    EXPECT_TRUE(bar.chipText().contains(QString::number(poses))) << bar.chipText().toStdString();
    desk.recorder().stop();
    ASSERT_FALSE(own.empty());
    EXPECT_EQ(own.back().poses.size(), desk.path().poses.size());
    EXPECT_TRUE(desk.own());
    // The bar stays, with what can be done with the path.
    EXPECT_TRUE(desk.player().active());
    EXPECT_FALSE(desk.player().playing());
    EXPECT_EQ(desk.player().pose(), int(desk.path().poses.size()) - 1);
    EXPECT_FALSE(bar.isHidden());
    EXPECT_FALSE(bar.name().isHidden());
}

TEST_F(Desk, aPathIsTrimmedSmoothedAndNamedAndThenTheUsersOwn) {
    make(QStringLiteral("orbit:9"));
    const Vec3 third = eyeOf(3), sixth = eyeOf(6);
    desk.go(3);
    desk.beginHere();
    EXPECT_EQ(desk.path().poses.size(), 6u);
    EXPECT_EQ(eyeOf(0), third);
    EXPECT_EQ(desk.player().pose(), 0);
    EXPECT_TRUE(desk.path().name.empty()) << "it is orbit:9 no more";
    desk.go(3);
    desk.endHere();
    EXPECT_EQ(desk.path().poses.size(), 4u);
    EXPECT_EQ(eyeOf(3), sixth);
    const Vec3 second = eyeOf(1);
    desk.smooth();
    EXPECT_NE(eyeOf(1), second);
    EXPECT_EQ(eyeOf(3), sixth);
    desk.rename(QStringLiteral("around the corner"));
    EXPECT_EQ(own.back().name, "around the corner");
    EXPECT_EQ(own.back().poses.size(), 4u);
    // A pose that is added goes on from what was changed.
    desk.recorder().addPose();
    EXPECT_EQ(desk.path().poses.size(), 5u);
    EXPECT_EQ(eyeOf(3), sixth);
}

TEST_F(Desk, isSavedAndReadAgain) {
    make(QStringLiteral("walk:7"));
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("walk.json")).toStdString();
    desk.save(file);
    EXPECT_EQ(desk.path().name, file.string());
    EXPECT_EQ(bar.name().text(), QStringLiteral("walk")) << "the file's place is in the tip";
    EXPECT_EQ(bar.name().toolTip().toStdString(), file.string());
    emit bar.name().editingFinished();
    EXPECT_EQ(desk.path().name, file.string()) << "nothing was typed";
    const CameraPath written = readCameraPath(file);
    ASSERT_EQ(written.poses.size(), 7u);
    EXPECT_EQ(written.poses[6].eye, eyeOf(6));
    desk.open(file);
    EXPECT_TRUE(desk.player().playing());
    EXPECT_THROW(desk.open(folder.filePath(QStringLiteral("missing.json")).toStdString()), Error);
}

TEST_F(Desk, anotherSceneLeavesABuiltInPathAndKeepsTheUsersOwn) {
    make(QStringLiteral("orbit:4"));
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    EXPECT_TRUE(desk.path().poses.empty());
    EXPECT_FALSE(desk.player().active());
    desk.recorder().addPose();
    openAndWait(session, QStringLiteral("field:n=4"));
    EXPECT_EQ(desk.path().poses.size(), 1u);
}

}  // namespace
}  // namespace cullscope::ui::path_desk_test
