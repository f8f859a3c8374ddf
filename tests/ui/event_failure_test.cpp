// What fails in the handler of an event ends neither the program nor the session, and a working folder may go away.
#include <gmock/gmock.h>

#include <QPushButton>
#include <QTemporaryDir>

#include "core/mesh/save.h"
#include "tests/ui/shown_window.h"
#include "ui/session/cullbench_command.h"
#include "ui/session/session_file.h"
#include "ui/session/session_state.h"
#include "ui/startup/recovery.h"

namespace cullscope::ui::event_failure_test {
namespace {

using ::testing::HasSubstr;

struct FailingEvents : Window {
    Application& application = dynamic_cast<Application&>(*QCoreApplication::instance());
    QTemporaryDir folder;
    std::filesystem::path kept = folder.filePath(QStringLiteral("data/kept.cullscope")).toStdString();
    Recovery recovery{application, session, window, kept};

    [[nodiscard]] bool says(const char* words) {
        return waitUntil([&] { return window.message().isVisible() && window.message().text().contains(QLatin1String(words)); });
    }
};

TEST_F(FailingEvents, areSaidAndTheProgramGoesOn) {
    QTimer::singleShot(0, &window, [] { throw std::runtime_error("the timer's work failed."); });
    EXPECT_TRUE(says("This failed, and Cullscope goes on: the timer's work failed. The session is kept"));
    QPushButton button(&window);
    QObject::connect(&button, &QPushButton::clicked, [] { throwInput("a.obj, line 3: no number."); });
    button.show();
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_TRUE(says("a.obj, line 3: no number."));
    session.gpu()->post([] { throw std::bad_alloc(); });
    EXPECT_TRUE(says("There is not enough memory."));
    session.gpu()->post([] { throw 7; });
    EXPECT_TRUE(says("The reason is not known."));
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(10.0), {}));
    settle();
    EXPECT_TRUE(session.picture(0));
}

TEST_F(FailingEvents, theSessionIsOfferedAtTheNextStart) {
    session.slot(0).choose("frustum");
    settle();
    QTimer::singleShot(0, &window, [] { throw std::runtime_error("it failed."); });
    ASSERT_TRUE(says("The session is kept"));
    const SessionState state = loadSession(kept);
    EXPECT_EQ(state.views[0].strategy, "frustum");

    session.slot(0).choose("all");
    recovery.offer();
    EXPECT_FALSE(window.message().offered().isVisible()) << "before a scene is there, the bar would be closed at once";
    window.document().opener().open(QStringLiteral("sphere:triangles=80"));
    ASSERT_TRUE(says("Something failed when Cullscope last ran."));
    ASSERT_TRUE(window.message().offered().isVisible());
    EXPECT_EQ(window.message().offered().text(), QStringLiteral("Open it"));
    QTest::mouseClick(&window.message().offered(), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return session.opened()->specification == "torus:triangles=2000"; }));
    EXPECT_TRUE(waitUntil([&] { return session.slot(0).id() == "frustum"; }));
    EXPECT_TRUE(waitUntil([&] { return !std::filesystem::exists(kept); }));
    EXPECT_FALSE(window.message().isVisible());
    session.raise(Severity::Error, Message{"Something else", {}});
    EXPECT_FALSE(window.message().offered().isVisible()) << "the button belongs to the offer alone";
}

TEST_F(FailingEvents, withoutAKeptSessionNothingIsOffered) {
    recovery.offer();
    window.document().opener().open(QStringLiteral("sphere:triangles=80"));
    ASSERT_TRUE(waitUntil([&] { return session.opened()->specification == "sphere:triangles=80"; }));
    settle();
    EXPECT_FALSE(window.message().isVisible());
}

TEST_F(FailingEvents, aWorkingFolderThatGoesAwayIsNoFailure) {
    const std::filesystem::path before = std::filesystem::current_path();
    const std::filesystem::path gone = std::filesystem::canonical(folder.path().toStdString()) / "gone";
    std::filesystem::create_directories(gone);
    std::filesystem::current_path(gone);
    const OpenedScene torus = openScene("torus:triangles=400");
    saveMeshFile("mesh.ply", std::vector<PlacedMesh>{{"torus", torus.scene->meshes().front().get()}});
    window.document().opener().open(QStringLiteral("mesh.ply"));
    const std::string file = (gone / "mesh.ply").string();
    EXPECT_TRUE(waitUntil([&] { return session.opened()->specification == file; })) << session.opened()->specification;
    settle();
    std::filesystem::remove_all(gone);

    bool failed = false;
    QObject::connect(&application, &Application::eventFailed, &window, [&] { failed = true; });
    EXPECT_EQ(captureState(session).scene, file);
    for (const int key : {Qt::Key_V, Qt::Key_F, Qt::Key_Home}) QTest::keyClick(&picture(0), Qt::Key(key));
    QTest::mousePress(&picture(0), Qt::LeftButton, {}, QPoint(50, 50));
    QTest::mouseMove(&picture(0), QPoint(90, 70));
    QTest::mouseRelease(&picture(0), Qt::LeftButton, {}, QPoint(90, 70));
    settle();
    session.setViewCount(4);
    QTest::qWait(600);  // the undo recorder takes the state after a rest
    EXPECT_TRUE(window.document().opener().save(folder.filePath(QStringLiteral("s.cullscope")), {}));
    EXPECT_THAT(cullbenchCommand(pictureSubject(session, 0, session.viewRequest(0))).toStdString(), HasSubstr(file));
    EXPECT_EQ(loadSession(folder.filePath(QStringLiteral("s.cullscope")).toStdString()).scene, file);
    window.document().opener().open(QStringLiteral("relative.cullscope"));
    EXPECT_TRUE(says("relative.cullscope cannot be opened"));
    EXPECT_FALSE(failed);
    std::filesystem::current_path(before);
}

}  // namespace
}  // namespace cullscope::ui::event_failure_test
