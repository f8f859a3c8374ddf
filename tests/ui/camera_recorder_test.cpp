#include "ui/session/camera_recorder.h"

#include <gtest/gtest.h>

#include <QKeyEvent>
#include <QTemporaryDir>
#include <QWidget>

#include "core/base/error.h"
#include "tests/ui/test_scene.h"
#include "ui/session/camera_player.h"

namespace cullscope::ui::camera_recorder_test {
namespace {

struct Recording : ::testing::Test {
    void SetUp() override { openAndWait(session, QStringLiteral("sphere:triangles=320")); }
    void turn(double degrees) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(degrees), {}));
        went.push_back(session.camera());
    }
    [[nodiscard]] std::vector<Vec3> eyes() const {
        std::vector<Vec3> eyes;
        for (const CameraPath::Pose& pose : recorder.path().poses) eyes.push_back(pose.eye);
        return eyes;
    }

    Session session{sessionOptions(false)};
    CameraRecorder recorder{session};
    std::vector<Camera> went;
};

TEST_F(Recording, ofMovesInOneInstantKeepsTheFirstAndTheLastPose) {
    const Camera first = session.camera();
    recorder.start();
    for (int i = 0; i < 100; ++i) turn(1.0);
    EXPECT_EQ(recorder.path().poses.size(), 1u);
    recorder.stop();
    EXPECT_FALSE(recorder.recording());
    EXPECT_EQ(eyes(), (std::vector<Vec3>{first.eye, went.back().eye}));
    turn(1.0);
    EXPECT_EQ(recorder.path().poses.size(), 2u);
}

TEST_F(Recording, theLastMoveArrivesWithoutAnotherOne) {
    recorder.start();
    turn(1.0);
    turn(1.0);
    ASSERT_TRUE(waitUntil([&] { return recorder.path().poses.size() == 2; }));
    EXPECT_EQ(eyes().back(), went.back().eye);
    // A camera that does not move adds no pose.
    QTest::qWait(150);
    recorder.stop();
    EXPECT_EQ(recorder.path().poses.size(), 2u);
}

TEST_F(Recording, hasAtMostThirtyPosesASecond) {
    recorder.start();
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < 500) {
        turn(0.5);
        QTest::qWait(1);
    }
    recorder.stop();
    const double seconds = double(time.elapsed()) / 1000.0;
    EXPECT_GE(recorder.path().poses.size(), 3u);
    EXPECT_LE(double(recorder.path().poses.size()), 30.0 * seconds + 2.0);
    // Every pose is a camera that the session had, in the same order.
    auto place = went.begin();
    for (size_t i = 1; i < recorder.path().poses.size(); ++i) {
        place = std::find_if(place, went.end(), [&](const Camera& camera) { return camera.eye == recorder.path().poses[i].eye; });
        ASSERT_NE(place, went.end()) << i;
    }
}

TEST_F(Recording, keyPosesNeedNoRecording) {
    recorder.addPose();
    turn(90.0);
    recorder.addPose();
    turn(90.0);
    EXPECT_EQ(recorder.path().poses.size(), 2u);
    EXPECT_EQ(eyes().back(), went.front().eye);
    recorder.clear();
    EXPECT_TRUE(recorder.path().poses.empty());
}

TEST_F(Recording, aPathHasOneLensThatTakesInAll) {
    recorder.addPose();
    const Camera first = session.camera();
    EXPECT_FALSE(recorder.lensDiffers());
    Camera wide = first;
    wide.fovy = Angle::fromDegrees(80.0);
    session.setCamera(zoomed(wide, wide.target, 3.0, 1.0));
    const Camera far = session.camera();
    recorder.addPose();
    session.setCamera(zoomed(far, far.target, 0.05, 1.0));
    const Camera near = session.camera();
    recorder.addPose();
    EXPECT_TRUE(recorder.lensDiffers());
    EXPECT_EQ(recorder.path().fovy, first.fovy);
    EXPECT_EQ(recorder.path().nearDistance, near.nearDistance);
    EXPECT_EQ(recorder.path().farDistance, far.farDistance);
    ASSERT_LT(near.nearDistance, first.nearDistance);
    ASSERT_GT(far.farDistance, first.farDistance);
}

TEST_F(Recording, anotherSceneEndsItAndItsCameraIsNoPose) {
    recorder.start();
    turn(5.0);
    const Vec3 last = session.camera().eye;
    openAndWait(session, QStringLiteral("field:n=5"));
    EXPECT_FALSE(recorder.recording());
    EXPECT_EQ(eyes().back(), last);
    EXPECT_EQ(recorder.path().poses.size(), 2u);
}

TEST_F(Recording, isSavedAsCoresPath) {
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("p.json")).toStdString();
    EXPECT_THROW(recorder.save(file), Error);
    EXPECT_FALSE(std::filesystem::exists(file));
    recorder.start();
    turn(33.0);
    recorder.stop();
    recorder.save(file);
    const CameraPath path = readCameraPath(file);
    ASSERT_EQ(path.poses.size(), 2u);
    EXPECT_EQ(path.poses[1].eye, session.camera().eye);
    EXPECT_EQ(path.nearDistance, recorder.path().nearDistance);
}

CameraPath orbit(const Session& session, const char* name) { return cameraPath(name, *session.opened()->scene); }

struct Playing : ::testing::Test {
    Playing() {
        player.setSpeed(100.0);
        QObject::connect(&player, &CameraPlayer::poseChanged, [&](int pose) {
            poses.push_back(pose);
            EXPECT_EQ(session.camera().eye, player.path().poses[size_t(pose)].eye);
        });
        QObject::connect(&player, &CameraPlayer::finished, [&] { ++finished; });
    }
    void SetUp() override { openAndWait(session, QStringLiteral("sphere:triangles=320")); }
    void press(Qt::Key key) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        QApplication::sendEvent(&widget, &event);
    }

    QWidget widget;
    Session session{sessionOptions(false)};
    CameraPlayer player{session};
    std::vector<int> poses;
    int finished = 0;
};

TEST_F(Playing, showsEveryPoseOnceInOrder) {
    player.play(orbit(session, "orbit:12"));
    ASSERT_TRUE(waitUntil([&] { return finished == 1; }));
    std::vector<int> all(12);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(poses, all);
    EXPECT_FALSE(player.playing());
    EXPECT_TRUE(player.active());
    player.resume();
    EXPECT_EQ(poses.back(), 0);
    player.stop();
}

TEST_F(Playing, escapeStopsIt) {
    player.play(orbit(session, "orbit:1000"));
    ASSERT_TRUE(waitUntil([&] { return poses.size() >= 8; }));
    press(Qt::Key_Space);
    EXPECT_TRUE(player.active());
    press(Qt::Key_Escape);
    EXPECT_FALSE(player.active());
    EXPECT_EQ(finished, 0);
    const size_t count = poses.size();
    QTest::qWait(50);
    EXPECT_EQ(poses.size(), count);
}

TEST_F(Playing, aHandOnTheCameraPauses) {
    player.play(orbit(session, "orbit:50"));
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(1.0), {}));
    EXPECT_FALSE(player.playing());
    EXPECT_TRUE(player.active());
    // A view's own camera does not pause the player.
    player.resume();
    session.observe(1, 0);
    session.setViewingCamera(1, turned(session.viewingCamera(1), UpAxis::Y, Angle::fromDegrees(1.0), {}));
    EXPECT_TRUE(player.playing());
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    EXPECT_FALSE(player.active());
}

TEST_F(Playing, nothingToPlayIsNotPlayed) {
    player.play({});
    EXPECT_FALSE(player.active());
    player.resume();
    EXPECT_TRUE(poses.empty());
}

/// At a speed that drawing cannot keep up with, every view draws every pose.
TEST(PlayingPictures, noPoseIsSkippedByAnyView) {
    Session session(sessionOptions(true));
    session.setViewCount(4);
    for (int view = 0; view < 4; ++view) session.setViewport(view, {160, 120});
    openAndWait(session, QStringLiteral("sphere:triangles=1280"));
    ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled() && !session.pictures()->busy(); }));
    std::array<std::vector<Vec3>, 4> drawn;
    QObject::connect(&session, &Session::pictureChanged, [&](int view) {
        const ViewPicturePointer picture = session.picture(view);
        ASSERT_TRUE(picture);
        std::vector<Vec3>& eyes = drawn[size_t(view)];
        if (eyes.empty() || eyes.back() != picture->request.viewing.eye) eyes.push_back(picture->request.viewing.eye);
    });
    CameraPlayer player(session);
    player.setSpeed(100.0);
    QSignalSpy finished(&player, &CameraPlayer::finished);
    const CameraPath path = orbit(session, "orbit:20");
    player.play(path);
    ASSERT_TRUE(waitUntil([&] { return finished.count() == 1; }));
    std::vector<Vec3> eyes;
    for (const CameraPath::Pose& pose : path.poses) eyes.push_back(pose.eye);
    for (const std::vector<Vec3>& seen : drawn) EXPECT_EQ(seen, eyes);
}

}  // namespace
}  // namespace cullscope::ui::camera_recorder_test
