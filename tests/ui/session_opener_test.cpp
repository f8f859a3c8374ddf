#include "ui/session/session_opener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "core/image/picture_file.h"
#include "core/mesh/save.h"
#include "tests/ui/test_scene.h"
#include "ui/session/session_file.h"

namespace cullscope::ui::session_opener_test {
namespace {

using ::testing::HasSubstr;

struct Opener : ::testing::Test {
    Opener() {
        QObject::connect(&session, &Session::messageRaised,
                         [&](Severity, const Message& message) { said.push_back(message.english()); });
        QObject::connect(&opener, &SessionOpener::opened, [&](const QString& what) { opened.push_back(what.toStdString()); });
        QObject::connect(&opener, &SessionOpener::restored, [&] { ++restored; });
        QObject::connect(&opener, &SessionOpener::failed, [&] { ++failed; });
    }
    [[nodiscard]] QString in(const char* name) const { return folder.filePath(QLatin1String(name)); }
    void expectSentence(const QString& file, const char* part) {
        const size_t before = said.size();
        const int failedBefore = failed;
        const SessionState state = opener.current({});
        const OpenedScenePointer scene = session.opened();
        opener.open(file);
        ASSERT_TRUE(waitUntil([&] { return said.size() > before; })) << file.toStdString();
        QTest::qWait(20);
        EXPECT_EQ(said.size(), before + 1);
        EXPECT_THAT(said.back(), HasSubstr(part));
        EXPECT_EQ(failed, failedBefore + 1) << file.toStdString();
        EXPECT_EQ(session.opened(), scene);
        EXPECT_EQ(opener.current({}), state);
    }

    QTemporaryDir folder;
    Session session{sessionOptions(false)};
    CameraBookmarks bookmarks;
    SessionOpener opener{session, bookmarks};
    std::vector<std::string> said, opened;
    int restored = 0, failed = 0;
};

TEST_F(Opener, tellsTypesApart) {
    const auto kind = [](const char* what) { return SessionOpener::kindOf(QString::fromUtf8(what)); };
    EXPECT_EQ(kind("/a/b.cullscope"), SessionOpener::Kind::Session);
    EXPECT_EQ(kind("/a/b.JSON"), SessionOpener::Kind::Session);
    EXPECT_EQ(kind("shot.png"), SessionOpener::Kind::Picture);
    EXPECT_EQ(kind("shot.EXR"), SessionOpener::Kind::Picture);
    EXPECT_EQ(kind("a.obj"), SessionOpener::Kind::Scene);
    EXPECT_EQ(kind("png"), SessionOpener::Kind::Scene);
    EXPECT_EQ(kind("bunny"), SessionOpener::Kind::Scene);
    EXPECT_EQ(kind("field:mesh=a.json"), SessionOpener::Kind::Scene);
}

TEST_F(Opener, aSavedSessionComesBackWithItsMesh) {
    const OpenedScene torus = openScene("torus:triangles=400");
    const std::vector<PlacedMesh> meshes{{"torus", torus.scene->meshes().front().get()}};
    saveMeshFile(in("torus.ply").toStdString(), meshes);
    openAndWait(session, in("torus.ply"));
    session.slot(0).choose("frustum");
    session.observe(1, 0);
    session.setChosenNear(0.5);
    bookmarks.store(2, session);
    ASSERT_TRUE(opener.save(in("s.cullscope"), QStringLiteral("compare")));
    const SessionState state = opener.current(QStringLiteral("compare"));
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    session.slot(0).choose("all");
    session.setLinked(1);
    session.setViewCount(8);
    bookmarks.setPlaces({});
    opener.open(in("s.cullscope"));
    ASSERT_TRUE(waitUntil([&] { return restored == 1; }));
    EXPECT_EQ(opener.current(QStringLiteral("compare")), state);
    EXPECT_EQ(opened.back(), in("s.cullscope").toStdString());
    EXPECT_TRUE(said.empty());
}

TEST_F(Opener, whatCannotBeOpenedLeavesEverything) {
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    session.observe(1, 0);
    SessionState state = opener.current({});
    state.scene = in("gone.obj").toStdString();
    saveSession(in("gone.cullscope").toStdString(), state);
    std::ofstream(in("bad.json").toStdString()) << "{\"format\"";
    std::ofstream(in("bad.png").toStdString()) << "no picture";
    writePicture(in("plain.png").toStdString(), {{1, 1}, {1, 2, 3, 255}, {}});
    writePicture(in("damaged.png").toStdString(), {{1, 1}, {1, 2, 3, 255}, {{kSessionMetadata, "{\"format\""}}});
    expectSentence(in("gone.cullscope"), "gone.obj");
    expectSentence(in("bad.json"), "not JSON from byte");
    expectSentence(in("none.cullscope"), "cannot be opened");
    expectSentence(in("bad.png"), "bad.png");
    expectSentence(in("plain.png"), "only pictures that Cullscope saved can be opened.");
    expectSentence(in("damaged.png"), "not JSON from byte");
    EXPECT_EQ(restored, 0);
}

TEST_F(Opener, aPictureBringsItsSessionBack) {
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    session.slot(1).choose("frustum");
    const SessionState state = opener.current({});
    for (const char* name : {"a.png", "a.jpg", "a.exr", "a.tif"}) {
        const std::filesystem::path file = in(name).toStdString();
        writePicture(file, {{1, 1}, {1, 2, 3, 255}, {{kSessionMetadata, stateToText(state, file)}}});
        session.slot(1).choose("all");
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
        const int before = restored;
        opener.open(in(name));
        ASSERT_TRUE(waitUntil([&] { return restored > before; })) << name;
        EXPECT_EQ(opener.current({}), state) << name;
    }
}

TEST_F(Opener, aNewerOpenCancelsTheWaitingState) {
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    SessionState state = opener.current({});
    state.scene = "torus:triangles=400";
    state.views[0].strategy = "frustum";
    state.views[0].parameters.clear();
    session.slot(0).choose("all");
    opener.restore(state);
    session.open(QStringLiteral("sphere:triangles=80"));
    ASSERT_TRUE(waitUntil([&] { return !opened.empty() && opened.back() == "sphere:triangles=80"; }));
    EXPECT_EQ(session.slot(0).id(), "all");
    EXPECT_EQ(restored, 0);
    // A newer opening also wins while the session file itself is being read.
    saveSession(in("s.cullscope").toStdString(), state);
    opener.open(in("s.cullscope"));
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    QTest::qWait(50);
    EXPECT_EQ(session.opened()->specification, "sphere:triangles=320");
    EXPECT_EQ(restored, 0);
}

TEST_F(Opener, bookmarksStoreAndRecallTheActiveViewsCamera) {
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    EXPECT_FALSE(bookmarks.recall(0, session));
    session.observe(1, 0);
    session.setActiveView(1);
    const Camera observer = session.viewingCamera(1), linked = session.camera();
    bookmarks.store(0, session);
    session.setViewingCamera(1, turned(observer, UpAxis::Y, Angle::fromDegrees(40.0), {}));
    ASSERT_NE(session.viewingCamera(1), observer);
    EXPECT_TRUE(bookmarks.recall(0, session));
    EXPECT_EQ(session.viewingCamera(1), observer);
    EXPECT_EQ(session.camera(), linked);
}

}  // namespace
}  // namespace cullscope::ui::session_opener_test
