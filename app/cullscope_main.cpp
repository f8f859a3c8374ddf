// The desktop: reads the command line, checks that there is a display with OpenGL, and creates the window.
#include <CLI/CLI.hpp>
#include <QIcon>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <optional>
#include <sstream>

#include "app/command_words.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/last_words.h"
#include "core/base/standard_streams.h"
#include "core/base/terminal_text.h"
#include "core/scene/absolute_files.h"
#include "core/scene/viewport_text.h"
#include "core/visibility/strategy_request.h"
#include "ui/startup/abrupt_end.h"
#include "ui/startup/display.h"
#include "ui/startup/first_views.h"
#include "ui/startup/recovery.h"
#include "ui/startup/settings_file.h"
#include "ui/startup/start_size.h"
#include "ui/startup/window_picture.h"
#include "ui/window/main_window.h"

namespace {

using namespace cullscope;

constexpr QSize kUsualSize{1366, 768};

struct CommandLine {
    std::string scene;
    std::vector<StrategyRequest> strategies;
    std::vector<std::filesystem::path> modelFolders;
    std::string language;
    std::optional<Viewport> size;  ///< none: the largest that fits on the screen
    std::string screenshot;
    std::string lesson;
    std::string handout;
    int lessonStep = 0;  ///< from 0
};

Viewport sizeFromText(const std::string& text) {
    const std::optional<Viewport> size = viewportFromText(text);
    if (!size || size->width < 320 || size->height < 240)
        throwUsage("--size %1: write a size such as 1366x768, between 320x240 and 16384x16384.", {text});
    return *size;
}

/// One strategy for each view, written as for cullbench.
std::vector<StrategyRequest> strategiesOfViews(const std::vector<std::string>& texts) {
    std::vector<StrategyRequest> requests = strategiesFromText(texts);
    if (requests.size() > ui::Session::kMostViews)
        throwUsage("-s: there are at most %1 views, and %2 strategies are named; name as many as views or fewer.",
                   {std::to_string(ui::Session::kMostViews), std::to_string(requests.size())});
    return requests;
}

void sayError(const std::string& sentence) { std::fprintf(stderr, "cullscope: %s\n", terminalLine(sentence).c_str()); }

/// Ends with help, the version, or what is wrong with the words. A reader that has read enough is no error.
[[noreturn]] void endWith(const CLI::App& parser, const CLI::ParseError& failure) {
    std::ostringstream out, err;
    const int status = parser.exit(failure, out, err) == 0 ? 0 : int(ErrorKind::Usage);
    std::fputs(terminalText(err.str()).c_str(), stderr);
    std::fputs(terminalText(out.str()).c_str(), stdout);
    if (std::fflush(stdout) != 0 && errno != EPIPE) {
        sayError("Standard output cannot be written: " + systemReason(errno) + ". Send it somewhere else.");
        std::exit(int(ErrorKind::Usage));
    }
    std::exit(status);
}

CommandLine parse(int argc, char** argv) {
    CommandLine line;
    std::string size;
    std::vector<std::string> strategies;
    CLI::App parser("Cullscope: shows what each culling strategy draws, how fast, and what it loses.", "cullscope");
    sayFailuresOnOneLine(parser);
    parser.add_option("SCENE", line.scene, "A mesh file, or a generator such as field:n=20 (cullbench list scenes)");
    parser
        .add_option("-s,--strategy", strategies,
                    "The strategies of the views, A,B:key=value,…: as many as 8 (cullbench list strategies)")
        ->allow_extra_args(false);
    parser
        .add_option("--models", line.modelFolders, "A folder in which models such as the bunny are looked for; may be repeated")
        ->allow_extra_args(false);
    parser.add_option("--language", line.language, "The language of the window")->check(CLI::IsMember({"en", "ko", "zh_CN"}));
    parser.add_option("--size", size,
                      "The size of the window, as WIDTHxHEIGHT (default: 1366x768, or the screen where it is smaller)");
    parser.add_option("--screenshot", line.screenshot, "Save a picture of the window once the figures are there, and leave");
    parser.add_option("--lesson", line.lesson,
                      "Begin with a lesson, NAME or NAME:STEP, or a lesson's file (File, Lessons lists them)");
    parser.add_option("--handout", line.handout, "With --lesson: save all its steps as a .pdf or .html file, and leave");
    parser.set_version_flag("--version", CULLSCOPE_VERSION);
    refuseEmptyValues(parser);
    try {
        refuseEmptyAssignments(argc, argv);
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& failure) {
        endWith(parser, failure);
    }
    // The working folder may go away while the window is open.
    for (std::filesystem::path& folder : line.modelFolders) folder = absoluteFile(folder.string());
    if (!size.empty()) line.size = sizeFromText(size);
    if (!line.screenshot.empty()) {
        ui::requireWindowPictureFormat(line.screenshot);
        requireWritable(line.screenshot);
    }
    if (!line.lesson.empty()) {
        QString name = QString::fromStdString(line.lesson);
        line.lessonStep = ui::LessonPlayer::cutStep(name);
        line.lesson = name.toStdString();
        (void)ui::LessonPlayer::read(name);
        if (!line.scene.empty() || !strategies.empty())
            throwUsage("--lesson %1: a lesson says itself which scene and strategies it shows; leave out SCENE and -s.",
                       {line.lesson});
    }
    if (!line.handout.empty()) {
        if (line.lesson.empty()) throwUsage("--handout %1: name the lesson by --lesson.", {line.handout});
        ui::LessonHandout::requireFormat(QString::fromStdString(line.handout));
        requireWritable(line.handout);
    }
    if (!strategies.empty()) line.strategies = strategiesOfViews(strategies);
    return line;
}

void chooseLanguage(ui::Language& language, const std::string& asked) {
    const QString stored = QSettings().value(QStringLiteral("language")).toString();
    if (!asked.empty())
        language.use(QString::fromStdString(asked));
    else
        language.use(ui::Language::isKnown(stored) ? stored : ui::Language::ofSystem());
}

int show(ui::Application& application, ui::AbruptEnd& abruptEnd, const CommandLine& line) {
    ui::Language language;
    chooseLanguage(language, line.language);
    ui::Appearance appearance;
    appearance.setMode(ui::Appearance::fromId(QSettings().value(QStringLiteral("appearance")).toString()));

    ui::Session::Options options;
    options.sceneSource.modelFolders = line.modelFolders;
    ui::Session session(options);
    QObject::connect(&session, &ui::Session::messageRaised,
                     [said = std::string()](ui::Severity severity, const Message& message) mutable {
                         // What fails in every view is one failure.
                         if (severity == ui::Severity::Error && std::exchange(said, message.english()) != message.english())
                             sayError(said);
                     });
    ui::showFirstViews(session, line.strategies);

    ui::MainWindow window(session, language, appearance);
    ui::requireDrawable(window);
    // A picture of the window must be the same on every machine, so it neither reads nor stores a layout.
    const bool remembers = line.screenshot.empty() && line.handout.empty();
    window.setKeepsLayout(remembers);
    const bool restored = remembers && window.restoreLayout(line.strategies.empty());
    if (line.size) {
        window.resize(line.size->width, line.size->height);
        window.show();
    } else if (restored) {
        window.show();
    } else {
        ui::showFitting(window, kUsualSize);
    }
    ui::Recovery recovery(application, session, window, ui::Recovery::usualFile());
    if (remembers) abruptEnd.keepBy([&] { return recovery.keep(); });
    const std::string scene = line.scene.empty() ? defaultSceneSpecification(options.sceneSource) : line.scene;
    std::unique_ptr<ui::WindowPicture> picture;
    if (!line.screenshot.empty()) {
        picture = std::make_unique<ui::WindowPicture>(window, session, line.screenshot);
        QObject::connect(picture.get(), &ui::WindowPicture::done, &application, &QCoreApplication::exit);
    }
    if (line.lesson.empty() && line.scene.empty() && line.strategies.empty())
        window.lessons().player().show(ui::LessonPlayer::firstStep(restored ? session.viewCount() : 2, session.setup(0).size));
    else if (line.lesson.empty())
        window.document().opener().open(QString::fromStdString(scene));
    else
        window.lessons().player().begin(QString::fromStdString(line.lesson), line.lessonStep);
    if (!line.handout.empty()) {
        ui::LessonHandout& handout = window.lessons().handout();
        QObject::connect(&handout, &ui::LessonHandout::done, &application, [] { QCoreApplication::exit(0); });
        QObject::connect(&handout, &ui::LessonHandout::failed, &application,
                         [] { QCoreApplication::exit(int(ErrorKind::Usage)); });
        handout.make(QString::fromStdString(line.handout));
    }
    if (line.screenshot.empty()) recovery.offer();
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    keepStandardStreams();
    endWithSentenceOnTerminate();
    endWithSentenceOnWant();
    const ExitsForWant exits;
    try {
        const CommandLine line = parse(argc, argv);
        ui::AbruptEnd abruptEnd;
        ui::requireDisplay();
        ui::setDefaultSurfaceFormat();
        QCoreApplication::setOrganizationName(QStringLiteral("cullscope"));
        QCoreApplication::setApplicationName(QStringLiteral("cullscope"));
        int qtArgc = 1;
        ui::requireReadableSettings();
        const std::unique_ptr<ui::Application> application = ui::makeApplication(qtArgc, argv);
        QGuiApplication::setDesktopFileName(QStringLiteral("cullscope"));
        QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/cullscope.svg")));
        try {
            static_cast<void>(ui::requireOpenGl());
            const int status = show(*application, abruptEnd, line);
            abruptEnd.keepBy({});
            return status;
        } catch (const Error& error) {
            abruptEnd.keepBy({});
            sayError(error.what());
            if (line.screenshot.empty()) ui::showWithoutTerminal(error);
            return int(error.kind());
        }
    } catch (const Error& error) {
        sayError(error.what());
        return int(error.kind());
    } catch (const std::bad_alloc&) {
        sayError("It cannot be started for want of memory. Close other programs, or allow it more memory (ulimit -v).");
        return int(ErrorKind::Input);
    } catch (const std::exception& error) {
        sayError(std::string("It cannot be started: ") + error.what() +
                 ". Close other programs, or allow it more memory (ulimit -v).");
        return int(ErrorKind::Input);
    }
}
