// Files that cannot be written: on a full disk, and in a folder that allows no new file. Each failure is one sentence in the
// window's message bar that names the file. The old file stays, no incomplete file appears, and the session is unchanged. Root
// ignores permissions and may run the tests, so these tests use folders in which root cannot write either.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QApplication>
#include <QFile>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <csignal>

#include "core/base/error.h"
#include "tests/ui/made_up_result.h"
#include "tests/ui/test_scene.h"
#include "ui/dialogs/screenshot_taker.h"
#include "ui/panels/message_bar.h"
#include "ui/session/camera_recorder.h"
#include "ui/session/session_opener.h"
#include "ui/session/undo_recorder.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::failing_places_test {
namespace {

using ::testing::HasSubstr;

const QByteArray kOld("what was saved before");

/// Simulates a full disk during its lifetime: limits the size of files to a few bytes, so that a write fails as on a full disk.
class FullDisk {
public:
    FullDisk() : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit full = m_before;
        full.rlim_cur = 16;
        setrlimit(RLIMIT_FSIZE, &full);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit m_before{};
    void (*m_handler)(int);
};

struct FailingPlaces : ::testing::Test {
    void SetUp() override {
        window.resize(1366, 768);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled() && !session.pictures()->busy(); }));
        QFile old(fileNamed("old"));
        ASSERT_TRUE(old.open(QIODevice::WriteOnly));
        old.write(kOld);
        QObject::connect(&session, &Session::messageRaised, [this](Severity severity, const Message& message) {
            said.push_back(message.english());
            severities.push_back(severity);
        });
    }

    [[nodiscard]] QString fileNamed(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] QString barText() const { return window.findChild<MessageBar*>()->text(); }
    [[nodiscard]] static QByteArray contents(const QString& file) {
        QFile read(file);
        return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
    }

    using Save = std::function<void(const QString& file)>;

    void expectOneSentence(const Save& save, const QString& file, const std::string& sentence) {
        said.clear();
        severities.clear();
        save(file);
        ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
        QTest::qWait(20);
        ASSERT_EQ(said.size(), 1u) << said.back();
        EXPECT_EQ(severities.front(), Severity::Error) << said.front();
        EXPECT_THAT(said.front(), HasSubstr(sentence));
        EXPECT_EQ(barText().toStdString(), said.front());
    }
    void expectCannotBeWritten(const Save& save, const QString& file) {
        expectOneSentence(save, file, file.toStdString() + " cannot be written: ");
        EXPECT_THAT(said.front(), HasSubstr("Choose another place or free some space."));
    }
    void expectOnlyTheOldFile() const {
        EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System), QStringList{QStringLiteral("old")});
        EXPECT_EQ(contents(fileNamed("old")), kOld);
    }

    /// Calls `save` with files in all places that fail.
    void expectNothingLost(const Save& save, const char* ending) {
        SCOPED_TRACE(ending);
        const SessionState state = captureState(session);
        const QImage picture = session.picture(0)->colour;
        const QString file = fileNamed("kept.") + QString::fromLatin1(ending);
        ASSERT_TRUE(QFile::copy(fileNamed("old"), file));
        {
            const FullDisk full;
            expectCannotBeWritten(save, file);
        }
        EXPECT_EQ(contents(file), kOld);
        // A full device.
        const QString device = fileNamed("full.") + QString::fromLatin1(ending);
        ASSERT_TRUE(QFile::link(QStringLiteral("/dev/full"), device));
        expectCannotBeWritten(save, device);
        // A folder in which no user, not even root, can make a file, and a path through a file.
        expectCannotBeWritten(save, QStringLiteral("/proc/none.") + QString::fromLatin1(ending));
        expectCannotBeWritten(save, fileNamed("old/none.") + QString::fromLatin1(ending));
        ASSERT_TRUE(QFile::remove(file) && QFile::remove(device));
        expectOnlyTheOldFile();
        EXPECT_EQ(captureState(session), state);
        EXPECT_EQ(session.picture(0)->colour, picture);
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
    QTemporaryDir folder;
    std::vector<std::string> said;
    std::vector<Severity> severities;
};

TEST_F(FailingPlaces, aSessionThatCannotBeWrittenIsOneSentence) {
    auto* opener = window.findChild<SessionOpener*>();
    ASSERT_NE(opener, nullptr);
    expectNothingLost([&](const QString& file) { EXPECT_FALSE(opener->save(file, {})); }, "cullscope");
    EXPECT_TRUE(opener->save(fileNamed("good.cullscope"), {}));
}

TEST_F(FailingPlaces, aCameraPathThatCannotBeWrittenIsOneSentence) {
    auto* recorder = window.findChild<CameraRecorder*>();
    ASSERT_NE(recorder, nullptr);
    recorder->addPose();
    // As PathCommands does after the user has chosen a file.
    const auto save = [&](const QString& file) {
        try {
            recorder->save(file.toStdString());
        } catch (const Error& error) {
            session.raise(Severity::Error, error.message());
        }
    };
    expectNothingLost(save, "json");
    EXPECT_EQ(recorder->path().poses.size(), 1u) << "the recorded path is there to be saved elsewhere";
}

// The full disk is tested by ScreenshotTest.aFullDiskAndAFolderThatIsNoneAreSaid.
TEST_F(FailingPlaces, aScreenshotThatCannotBeWrittenIsOneSentence) {
    auto* taker = window.findChild<ScreenshotTaker*>();
    ASSERT_NE(taker, nullptr);
    const SessionState state = captureState(session);
    const auto save = [&](const QString& file) {
        const QFileInfo info(file);
        taker->take(ScreenshotSettings{ScreenshotOptions(), info.path(), info.fileName()});
    };
    for (const char* ending : {".png", ".jpg", ".tif", ".exr"}) {
        SCOPED_TRACE(ending);
        expectCannotBeWritten(save, QStringLiteral("/proc/none") + QString::fromLatin1(ending));
        expectOneSentence(save, fileNamed("old/none") + QString::fromLatin1(ending),
                          "There is no folder " + fileNamed("old").toStdString());
        EXPECT_FALSE(taker->busy());
    }
    expectOnlyTheOldFile();
    EXPECT_EQ(captureState(session), state);
}

TEST_F(FailingPlaces, statisticsThatCannotBeWrittenAreOneSentence) {
    auto* panel = window.findChild<StatisticsPanel*>();
    ASSERT_NE(panel, nullptr);
    MeasureResult result = madeUpResult();
    result.request.scene = session.opened()->scene;
    panel->setRunning(true);
    panel->setResult(tableOf(result), result);
    panel->setRunning(false);
    panel->showTab(StatisticsPanel::Times);
    using File = StatisticsPanel::File;
    for (const auto& [kind, ending] :
         {std::pair(File::Csv, "csv"), {File::Json, "json"}, {File::Svg, "svg"}, {File::Pdf, "pdf"}, {File::Html, "html"}})
        expectNothingLost([&panel, kind = kind](const QString& file) { panel->exportTo(kind, file.toStdString()); }, ending);
    EXPECT_EQ(panel->model().rowCount(), 3);
}

/// The message of `cullbench` when it cannot write.
std::string refusal(const QStringList& arguments) {
    QProcess shell;
    // A limit of 0 blocks of 512 bytes acts like a full disk.
    shell.start(QStringLiteral("/bin/sh"), QStringList{QStringLiteral("-c"), QStringLiteral("trap '' XFSZ; ulimit -f 0; \"$@\""),
                                                       QStringLiteral("sh"), QStringLiteral(CULLSCOPE_CULLBENCH)} +
                                               arguments);
    EXPECT_TRUE(shell.waitForFinished(kPatience));
    EXPECT_EQ(shell.exitCode(), 2);
    return shell.readAllStandardError().toStdString();
}

TEST_F(FailingPlaces, cullbenchSaysInOneSentenceWhatItCannotWrite) {
    const QString scene = QStringLiteral("sphere:triangles=80");
    const auto expectSentence = [&](const QStringList& arguments) {
        const std::string errors = refusal(arguments);
        EXPECT_THAT(errors, ::testing::StartsWith("cullbench: " + arguments.back().toStdString() + " cannot be written: "));
        EXPECT_THAT(errors, HasSubstr("Choose another place or free some space.\n"));
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    };
    const QStringList measure{QStringLiteral("measure"), scene,
                              QStringLiteral("-s"),      QStringLiteral("all"),
                              QStringLiteral("--path"),  QStringLiteral("orbit:2"),
                              QStringLiteral("--size"),  QStringLiteral("64x48")};
    const QString old = fileNamed("old.json");
    ASSERT_TRUE(QFile::copy(fileNamed("old"), old));
    expectSentence(measure + QStringList{QStringLiteral("--json"), old});
    EXPECT_EQ(contents(old), kOld);
    ASSERT_TRUE(QFile::remove(old));
    expectSentence(measure + QStringList{QStringLiteral("--csv"), fileNamed("new.csv")});
    expectSentence({QStringLiteral("path"), QStringLiteral("orbit:2"), scene, QStringLiteral("-o"), fileNamed("new.json")});
    const QString device = fileNamed("full.png");
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/full"), device));
    const QStringList render{QStringLiteral("render"), scene, QStringLiteral("-s"), QStringLiteral("all"),
                             QStringLiteral("-o"),     device};
    QProcess process;
    process.start(QStringLiteral(CULLSCOPE_CULLBENCH), render);
    ASSERT_TRUE(process.waitForFinished(kPatience));
    EXPECT_EQ(process.exitCode(), 2);
    EXPECT_THAT(process.readAllStandardError().toStdString(),
                ::testing::StartsWith("cullbench: " + device.toStdString() + " cannot be written: "));
    ASSERT_TRUE(QFile::remove(device));
    expectOnlyTheOldFile();
}

}  // namespace
}  // namespace cullscope::ui::failing_places_test
