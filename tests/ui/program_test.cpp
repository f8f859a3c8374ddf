// The program as a process: its exit statuses and the picture that it saves.
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <array>
#include <set>

#include "tests/ui/test_scene.h"
#include "ui/startup/first_views.h"

namespace cullscope::ui::program_test {
namespace {

struct Ended {
    int status = -1;
    QString errors;
};

Ended runProgram(const QStringList& arguments, const std::function<void(QProcessEnvironment&)>& change = {}) {
    const QTemporaryDir home;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.path());
    if (change) change(environment);
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(CULLSCOPE_PROGRAM), arguments);
    EXPECT_TRUE(process.waitForFinished(kPatience));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardError())};
}

TEST(Program, withoutOpenGlItEndsWithASentence) {
    for (const char* platform : {"offscreen", "minimal"}) {
        const Ended ended = runProgram({}, [&](QProcessEnvironment& environment) {
            environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QString::fromLatin1(platform));
        });
        EXPECT_EQ(ended.status, 4) << platform;
        EXPECT_TRUE(ended.errors.startsWith(QStringLiteral("cullscope: "))) << ended.errors.toStdString();
        EXPECT_TRUE(ended.errors.contains(QStringLiteral("cullbench")));
    }
}

TEST(Program, aDisplayWhoseOpenGlIsMissingOrTooOldIsSaidInOneSentence) {
    struct Display {
        const char* name;
        const char* value;
        const char* mentions;
        std::unique_ptr<QProcess> process = std::make_unique<QProcess>();
    };
    std::array displays{Display{"LIBGL_DRIVERS_PATH", "/nonexistent", "offers no OpenGL 4.5"},
                        Display{"QT_XCB_GL_INTEGRATION", "none", "offers no OpenGL 4.5"},
                        Display{"MESA_GL_VERSION_OVERRIDE", "3.3", "this machine has 3.3"},
                        Display{"MESA_GL_VERSION_OVERRIDE", "4.4COMPAT", "this machine has 4.4"}};
    const QTemporaryDir home;
    // Start all at once: without a terminal each one shows its sentence in a message box for some time.
    for (Display& display : displays) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.path());
        environment.insert(QString::fromLatin1(display.name), QString::fromLatin1(display.value));
        display.process->setProcessEnvironment(environment);
        display.process->start(QStringLiteral(CULLSCOPE_PROGRAM), {QStringLiteral("sphere:triangles=80")});
    }
    for (Display& display : displays) {
        SCOPED_TRACE(display.value);
        ASSERT_TRUE(display.process->waitForFinished(kPatience));
        EXPECT_EQ(display.process->exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(display.process->exitCode(), 4);
        // Mesa and Qt may write lines of their own: count only those of Cullscope.
        const QString errors = QString::fromUtf8(display.process->readAllStandardError());
        EXPECT_EQ(errors.count(QStringLiteral("cullscope: ")), 1) << errors.toStdString();
        EXPECT_TRUE(errors.contains(QString::fromLatin1(display.mentions))) << errors.toStdString();
    }
}

TEST(Program, anUnknownPlatformIsSaidWithItsVariable) {
    const Ended ended = runProgram({}, [](QProcessEnvironment& environment) {
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("nonsense"));
    });
    EXPECT_EQ(ended.status, 4);
    EXPECT_EQ(ended.errors.count(QLatin1Char('\n')), 1) << ended.errors.toStdString();
    EXPECT_TRUE(ended.errors.contains(QStringLiteral("QT_QPA_PLATFORM"))) << ended.errors.toStdString();
}

TEST(Program, withoutADisplayItEndsWithASentence) {
    const Ended none = runProgram({}, [](QProcessEnvironment& environment) {
        environment.remove(QStringLiteral("DISPLAY"));
        environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    });
    EXPECT_EQ(none.status, 4);
    EXPECT_TRUE(none.errors.contains(QStringLiteral("cullbench")));
    const Ended unreachable = runProgram({}, [](QProcessEnvironment& environment) {
        environment.insert(QStringLiteral("DISPLAY"), QStringLiteral("localhost:4711"));
        environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    });
    EXPECT_EQ(unreachable.status, 4);
    EXPECT_EQ(unreachable.errors.count(QLatin1Char('\n')), 1) << unreachable.errors.toStdString();
}

TEST(Program, wrongUsageEndsWithTwo) {
    EXPECT_EQ(runProgram({QStringLiteral("--nonsense")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("-s"), QStringLiteral("nonsense")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("-s"), QStringLiteral("all,all,all,all,all,all,all,all,all")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("-s"), QStringLiteral("bsp:plane=nonsense")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("-s"), QStringLiteral("bsp:nonsense=1")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("--size"), QStringLiteral("wide")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("--language"), QStringLiteral("xx")}).status, 2);
    EXPECT_EQ(runProgram({QStringLiteral("--help")}).status, 0);
}

TEST(Program, strategiesOfTheViewsHaveTheirParameters) {
    Session session{sessionOptions(false)};
    showFirstViews(session, strategiesFromText({"bsp:plane=given", "painter", "spherical:rows=45", "band=10"}));
    EXPECT_EQ(session.viewCount(), 4);
    EXPECT_EQ(session.slot(0).id(), "bsp");
    EXPECT_EQ(session.slot(0).parameters().choice("plane"), "given");
    EXPECT_EQ(session.slot(1).id(), "painter");
    EXPECT_EQ(session.slot(2).parameters().integer("rows"), 45);
    EXPECT_EQ(session.slot(2).parameters().real("band"), 10.0);
}

TEST(Program, viewsBesideTheChosenOnesHaveOtherStrategies) {
    for (const std::vector<std::string>& chosen :
         {std::vector<std::string>{"spherical", "bsp"}, {"all"}, {"octree-query", "all", "frustum"}}) {
        Session session{sessionOptions(false)};
        showFirstViews(session, strategiesFromText(chosen));
        session.setViewCount(Session::kMostViews);
        std::set<std::string> ids;
        for (int view = 0; view < Session::kMostViews; ++view) ids.insert(session.slot(view).id());
        EXPECT_EQ(ids.size(), size_t(Session::kMostViews)) << "eight views compare eight strategies";
    }
}

TEST(Program, savesAPictureOfItsWindow) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    const Ended ended = runProgram({QStringLiteral("-s"), QStringLiteral("all,frustum"), QStringLiteral("sphere:triangles=1280"),
                                    QStringLiteral("--size"), QStringLiteral("900x600"), QStringLiteral("--screenshot"), file});
    EXPECT_EQ(ended.status, 0) << ended.errors.toStdString();
    EXPECT_EQ(QImage(file).size(), QSize(900, 600));
}

TEST(Program, sceneAfterAFolderOfModelsIsOpened) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png")), models = QStringLiteral("--models");
    const Ended ended = runProgram({QStringLiteral("--screenshot"), file, models, folder.path(), models,
                                    QStringLiteral("/nowhere"), QStringLiteral("sphere:triangles=80")});
    EXPECT_EQ(ended.status, 0) << ended.errors.toStdString();
    EXPECT_FALSE(QImage(file).isNull());
}

TEST(Program, whatCannotBeReadIsSaidAndShown) {
    const QTemporaryDir folder;
    const auto written = [&](const char* name, const QByteArray& bytes) {
        const QString path = folder.filePath(QLatin1String(name));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        return path;
    };
    const QByteArray noScene =
        R"({"format": "cullscope session", "version": 1, "scene": "/nonexistent.obj", "views": [{"strategy": "all"}],)"
        R"( "camera": {"eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fovy_rad": 0.8,)"
        R"( "near": 0.01, "far": 100}})";
    for (const QString& named :
         {QStringLiteral("/nonexistent.obj"), QStringLiteral("/nonexistent.cullscope"), QStringLiteral("/nonexistent.png"),
          written("incomplete.cullscope", R"({"format":"cullscope session"})"), written("no-scene.cullscope", noScene),
          written("no-picture.png", "no picture")}) {
        SCOPED_TRACE(named.toStdString());
        const QString file = folder.filePath(QStringLiteral("window.png"));
        const Ended ended = runProgram({named, QStringLiteral("--screenshot"), file});
        EXPECT_EQ(ended.status, 3);
        const QString name = named.contains(QStringLiteral("no-scene")) ? QStringLiteral("/nonexistent.obj") : named;
        EXPECT_TRUE(ended.errors.contains(name)) << ended.errors.toStdString();
        EXPECT_FALSE(QImage(file).isNull());
        EXPECT_TRUE(QFile::remove(file));
    }
}

}  // namespace
}  // namespace cullscope::ui::program_test
