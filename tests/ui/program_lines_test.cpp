// Command lines of the desktop's program that end by themselves, put together at random of valid and hostile pieces, and the
// program where memory, settings, its folder or its display are taken away: it ends by itself with a sentence and a status of the
// table.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QProcess>
#include <QTemporaryDir>
#include <fstream>
#include <random>
#include <set>

#include "tests/support/command_lines.h"
#include "tests/support/long_mode.h"
#include "tests/ui/test_scene.h"

namespace cullscope::ui::program_lines_test {
namespace {

using test::CommandEnd;
using test::CommandLine;
using test::Stream;
using ::testing::HasSubstr;

constexpr double kMostSeconds = 90.0;
/// Starting a window takes a second; so few are started at once that each one has a processor.
constexpr int kTogether = 2;

const std::string kLong(300, 'a');
const std::string kEscapes = "\x1b]0;title\x07\x1b[2J";

struct Expected {
    CommandLine line;
    std::set<int> statuses;
};

class ProgramLines : public testing::Test {
protected:
    ProgramLines() { std::filesystem::create_directories(in() / "folder.obj"); }

    [[nodiscard]] std::filesystem::path folder() const { return m_folder.path().toStdString(); }
    [[nodiscard]] std::filesystem::path in() const { return folder() / "in"; }
    void write(const std::string& name, const std::string& bytes) const { std::ofstream(in() / name, std::ios::binary) << bytes; }

    /// With settings of its own.
    [[nodiscard]] CommandLine lineOf(std::vector<std::string> words) const {
        CommandLine line;
        line.words = std::move(words);
        line.set = {{"XDG_CONFIG_HOME", folder() / "settings"}, {"XDG_DATA_HOME", folder() / "data"}};
        return line;
    }
    /// With a picture of the window at the end.
    [[nodiscard]] CommandLine pictureOf(const std::string& scene) const {
        return lineOf({scene, "--size", "800x600", "--screenshot", "window.png"});
    }

    /// Returns the ends.
    std::vector<CommandEnd> run(const std::vector<Expected>& expected) const {
        std::vector<CommandLine> lines;
        for (const Expected& each : expected) lines.push_back(each.line);
        std::vector<CommandEnd> ends(lines.size());
        const auto judge = [&](size_t i, const CommandEnd& end) {
            ends[i] = end;
            std::string fault = test::faultOf("cullscope", lines[i], end, test::Said::ByLibraries);
            if (fault.empty() && !expected[i].statuses.contains(end.status)) fault = "not its status";
            const bool named = std::ranges::find(lines[i].words, "window.png") != lines[i].words.end();
            if (fault.empty() && end.status == 0 && named && !std::filesystem::exists(end.folder / "window.png"))
                fault = "no picture";
            EXPECT_EQ(fault, "") << lines[i].text("cullscope") << "\nstatus " << end.status << "\n" << end.err;
        };
        test::runCommandLines(CULLSCOPE_PROGRAM, lines, folder() / "runs", kTogether, kMostSeconds, judge);
        return ends;
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(ProgramLines, thatAreWrongUsageEndBeforeTheWindowWithOneSentence) {
    const std::vector<std::vector<std::string>> pieces{{"--nonsense"},
                                                       {"-s", ""},
                                                       {"-s", "nonsense"},
                                                       {"-s", "all,,frustum"},
                                                       {"-s", "all,all,all,all,all,all,all,all,all"},
                                                       {"-s", "bsp:plane=x"},
                                                       {"-s", kLong},
                                                       {"-s", kEscapes},
                                                       {"-s"},
                                                       {"--size", "wide"},
                                                       {"--size", "99999999999x600"},
                                                       {"--size", "319x240"},
                                                       {"--size", "4294968662x768"},
                                                       {"--size", " 800x600"},
                                                       {"--size", ""},
                                                       {"--size", "nanxinf"},
                                                       {"--language", "xx"},
                                                       {"--language", ""},
                                                       {"--language", kEscapes},
                                                       {"--models", ""},
                                                       {""},
                                                       {"a", "word", "too many"},
                                                       {"--screenshot", ""},
                                                       {"--screenshot", "."},
                                                       {"--screenshot", "none/a.png"},
                                                       {"--screenshot", "a.xyz"},
                                                       {"--screenshot", "-"},
                                                       {"--screenshot", kLong + ".png"},
                                                       {"--screenshot", "a\nb\x1b[31m"},
                                                       {"--screenshot", "/proc/none.png"},
                                                       {"--size", "800x600", "--size", "800x600"},
                                                       {"--\x1b[31m"}};
    const std::vector<std::vector<std::string>> valid{
        {}, {"-s", "all"}, {"--language", "ko"}, {"--models", "none"}, {"--size", "640x480"}};
    std::vector<Expected> expected;
    for (uint64_t seed = 0; seed < test::howMany(500, 60); ++seed) {
        std::mt19937_64 random(seed);
        std::vector<std::string> words;
        // Each hostile piece comes in turn, among valid ones.
        const std::vector<std::string>& hostile = pieces[seed % pieces.size()];
        const std::vector<std::string>& other = valid[random() % valid.size()];
        const bool same = !other.empty() && !hostile.empty() && other[0] == hostile[0];
        if (!same) words = other;
        words.insert(words.end(), hostile.begin(), hostile.end());
        Expected each{lineOf(words), {2}};
        if (random() % 6 == 0) each.line.err = random() % 2 == 0 ? Stream::Closed : Stream::Full;
        if (random() % 6 == 0) each.line.out = random() % 2 == 0 ? Stream::Closed : Stream::Full;
        if (random() % 6 == 0) each.line.in = Stream::Closed;
        each.line.folderGone = random() % 6 == 0;
        expected.push_back(std::move(each));
    }
    run(expected);
}

TEST_F(ProgramLines, helpAndVersionNeedNoDisplayAndAStandardOutputThatTakesThem) {
    std::vector<Expected> expected;
    for (const char* word : {"--help", "--version"})
        for (const auto& [out, status] :
             {std::pair(Stream::Usual, 0), {Stream::Closed, 2}, {Stream::Full, 2}, {Stream::ReaderGone, 0}}) {
            Expected each{lineOf({word}), {status}};
            each.line.out = out;
            each.line.set.emplace_back("DISPLAY", "");
            expected.push_back(std::move(each));
        }
    run(expected);
}

TEST_F(ProgramLines, whatCannotBeOpenedIsStatusThree) {
    const std::string in = "../../in/";
    write("empty.obj", "");
    write("garbage.obj", kEscapes + std::string(200, '\xfe'));
    write("truncated.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n");
    write("deep.cullscope", std::string(100'000, '['));
    write("escapes.cullscope", R"({"format": "cullscope session", "version": 1, "scene": ")" + kEscapes + "\"}");
    write("garbage.png", "\x89PNG\r\n\x1a\n" + kEscapes);
    write(kEscapes + ".obj", "v nan inf 1e999\nf 1 2 3\n");
    std::filesystem::create_symlink("/proc/self/mem", this->in() / "unreadable.obj");
    std::filesystem::create_symlink("loop.cullscope", this->in() / "loop.cullscope");
    ASSERT_EQ(mkfifo((this->in() / "fifo.obj").c_str(), 0600), 0);
    std::vector<std::string> scenes{in + "absent.obj",
                                    in + "empty.obj",
                                    in + "garbage.obj",
                                    in + "truncated.ply",
                                    in + "folder.obj",
                                    in + "unreadable.obj",
                                    in + "fifo.obj",
                                    in + "loop.cullscope",
                                    in + "deep.cullscope",
                                    in + "escapes.cullscope",
                                    in + "garbage.png",
                                    in + kEscapes + ".obj",
                                    "nonsense",
                                    kLong,
                                    kEscapes,
                                    "sphere:triangles=nan",
                                    "sphere:triangles=2e9",
                                    "field:n=1e9",
                                    ".",
                                    "/dev/zero",
                                    "./" + kLong + ".cullscope",
                                    "-"};
    const uint64_t count = test::howMany(scenes.size(), 8);
    std::shuffle(scenes.begin(), scenes.end(), std::mt19937_64(23));
    std::vector<Expected> expected;
    for (uint64_t i = 0; i < count; ++i) expected.push_back({pictureOf(scenes[i]), {3}});
    run(expected);
}

TEST_F(ProgramLines, endWithASentenceWhereMemoryIsWanting) {
#ifdef CULLSCOPE_SANITIZED
    GTEST_SKIP() << "The address sanitizer reserves terabytes of addresses; the development build runs this case.";
#endif
    std::vector<Expected> expected;
    // From what is too small for the libraries to more than is needed, in megabytes.
    for (const uint64_t megabytes : {200, 250, 300, 400, 500, 600, 700, 900, 1200, 4000}) {
        Expected each{pictureOf("sphere:triangles=2000"), {0, 3}};
        each.line.mostMemory = megabytes << 20;
        expected.push_back(std::move(each));
    }
    const std::vector<CommandEnd> ends = run(expected);
    EXPECT_EQ(ends.front().status, 3);
    EXPECT_EQ(ends.back().status, 0);
}

TEST_F(ProgramLines, needNoPlaceForSettings) {
    write("file", "");
    const std::string file = in() / "file";
    std::vector<Expected> expected;
    for (const std::string& place : {file, std::string("/proc/none"), std::string("/dev/null")}) {
        Expected each{pictureOf("sphere:triangles=80"), {0}};
        each.line.set = {{"XDG_CONFIG_HOME", place}, {"XDG_DATA_HOME", place}, {"XDG_CACHE_HOME", place}, {"HOME", place}};
        expected.push_back(std::move(each));
    }
    // Settings that are none.
    std::filesystem::create_directories(in() / "noise/cullscope");
    write("noise/cullscope/cullscope.conf", kEscapes + std::string(3000, '\xfe') + "\n[\n=\n");
    expected.push_back({pictureOf("sphere:triangles=80"), {0}});
    expected.back().line.set = {{"XDG_CONFIG_HOME", in() / "noise"}};
    run(expected);
}

TEST_F(ProgramLines, settingsThatWouldBeReadForEverAreRefused) {
    std::vector<Expected> expected;
    const auto expectWith = [&](const std::string& name, int status) {
        expected.push_back({pictureOf("sphere:triangles=80"), {status}});
        expected.back().line.set = {{"XDG_CONFIG_HOME", in() / name}};
    };
    for (const char* name : {"pipe", "pipe-of-the-organization", "endless"})
        std::filesystem::create_directories(in() / name / "cullscope");
    ASSERT_EQ(mkfifo((in() / "pipe/cullscope/cullscope.conf").c_str(), 0600), 0);
    ASSERT_EQ(mkfifo((in() / "pipe-of-the-organization/cullscope.conf").c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", in() / "endless/cullscope/cullscope.conf");
    expectWith("pipe", 3);
    expectWith("pipe-of-the-organization", 3);
    expectWith("endless", 3);
    const std::vector<CommandEnd> ends = run(expected);
    EXPECT_THAT(ends.front().err, HasSubstr("pipe/cullscope/cullscope.conf, the file of the settings, is a pipe"));
}

TEST_F(ProgramLines, aScaleOfTheScreenThatNoPictureCanHaveIsRefused) {
    std::vector<Expected> expected;
    for (const auto& [scale, status] : {std::pair("100", 2), {"2", 0}}) {
        expected.push_back({pictureOf("sphere:triangles=80"), {status}});
        expected.back().line.set.emplace_back("QT_SCALE_FACTOR", scale);
    }
    const std::vector<CommandEnd> ends = run(expected);
    EXPECT_THAT(ends.front().err, HasSubstr("QT_SCALE_FACTOR"));
}

TEST_F(ProgramLines, aWorkingFolderThatIsGoneCostsNothingThatIsNamedFromTheRoot) {
    const std::string picture = folder() / "window.png";
    Expected absolute{lineOf({"sphere:triangles=80", "--size", "800x600", "--screenshot", picture}), {0}};
    absolute.line.folderGone = true;
    Expected relative{pictureOf("sphere:triangles=80"), {2}};
    relative.line.folderGone = true;
    run({absolute, relative});
    EXPECT_TRUE(std::filesystem::exists(picture));
}

/// An X server of the test's own.
class Display {
public:
    Display() {
        m_server.start(QStringLiteral("Xvfb"),
                       {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-nolisten"), QStringLiteral("tcp"),
                        QStringLiteral("-screen"), QStringLiteral("0"), QStringLiteral("1280x800x24")});
        while (!m_name.endsWith(QLatin1Char('\n')) && m_server.waitForReadyRead(kPatience))
            m_name += QString::fromLatin1(m_server.readAllStandardOutput());
    }
    [[nodiscard]] QString name() const { return QLatin1Char(':') + m_name.trimmed(); }
    void kill() {
        m_server.kill();
        m_server.waitForFinished(kPatience);
    }

private:
    QProcess m_server;
    QString m_name;
};

TEST_F(ProgramLines, aDisplayThatEndsIsSaidAndTheSessionKept) {
    const std::filesystem::path kept = folder() / "data/cullscope/cullscope/kept.cullscope";
    // On a busy machine the scene is not there after a second or two; before, nothing is kept.
    for (int milliseconds = 250; !std::filesystem::exists(kept); milliseconds *= 2) {
        SCOPED_TRACE(milliseconds);
        ASSERT_LT(milliseconds, kPatience);
        Display display;
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("DISPLAY"), display.name());
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), QString::fromStdString(folder() / "settings"));
        environment.insert(QStringLiteral("XDG_DATA_HOME"), QString::fromStdString(folder() / "data"));
        program.setProcessEnvironment(environment);
        program.start(QStringLiteral(CULLSCOPE_PROGRAM), {QStringLiteral("torus:triangles=2000")});
        QTest::qWait(milliseconds);
        display.kill();
        ASSERT_TRUE(program.waitForFinished(kPatience));
        const std::string errors = program.readAllStandardError().toStdString();
        EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << errors;
        EXPECT_EQ(program.exitCode(), 4) << errors;
        EXPECT_THAT(errors, HasSubstr("cullscope: "));
        EXPECT_EQ(std::filesystem::exists(kept), errors.find("The session is kept") != std::string::npos) << errors;
    }
}

}  // namespace
}  // namespace cullscope::ui::program_lines_test
