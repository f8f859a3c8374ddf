#include "ui/startup/display.h"

#include <unistd.h>

#include <QMessageBox>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QTimer>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "core/base/last_words.h"
#include "core/base/memory_limit.h"
#include "ui/look/wrapped_tips.h"
#include "ui/startup/abrupt_end.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr const char* kUnreachable =
    "cullscope: the display cannot be reached. Start it in a desktop session, or use cullbench, which needs no display.\n";

constexpr int kMessageTime = 20'000;  // ms

constexpr const char* kUnknownPlatform =
    "cullscope: the Qt platform that QT_QPA_PLATFORM names is unknown here or has no OpenGL. Unset QT_QPA_PLATFORM, or use "
    "cullbench, which needs no display.\n";

std::string askedPlatform() { return qEnvironmentVariable("QT_QPA_PLATFORM").section(QLatin1Char(':'), 0, 0).toStdString(); }

/// Whether the platform plugin fails only if there is no display.
bool usualPlatform(const std::string& platform) {
    return platform.empty() || platform == "xcb" || platform.starts_with("wayland");
}

/// Message handler: prints one sentence when Qt calls qFatal because no platform plugin can start. Qt's warnings before are
/// dropped.
void endWithSentence(QtMsgType type, const QMessageLogContext&, const QString& text) {
    endWhereQtCannotGoOn(text);
    if (type != QtFatalMsg) return;
    if (memoryIsShort()) endForWant();
    std::fputs(usualPlatform(askedPlatform()) ? kUnreachable : kUnknownPlatform, stderr);
    std::_Exit(int(ErrorKind::OpenGl));
}

}  // namespace

void requireDisplay() {
    const std::string platform = askedPlatform();
    constexpr std::array withoutOpenGl{"offscreen", "minimal", "minimalegl", "vnc", "linuxfb"};
    for (const char* refused : withoutOpenGl)
        if (platform == refused)
            throwOpenGl(QT_TRANSLATE_NOOP("core",
                                          "The Qt platform %1 has no OpenGL for windows. Unset QT_QPA_PLATFORM, or use "
                                          "cullbench, which needs no display."),
                        {platform});
    const bool x11 = !qEnvironmentVariableIsEmpty("DISPLAY");
    const bool wayland = !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
    if (usualPlatform(platform) && !x11 && !wayland)
        throwOpenGl(QT_TRANSLATE_NOOP("core",
                                      "There is no display: neither DISPLAY nor WAYLAND_DISPLAY is set. Start cullscope in a "
                                      "desktop session, or use cullbench, which needs no display."));
}

void setDefaultSurfaceFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CompatibilityProfile);
    // Without this option Qt asks for a forward-compatible context even in the compatibility profile.
    format.setOption(QSurfaceFormat::DeprecatedFunctions);
    format.setDepthBufferSize(24);
    format.setSwapInterval(0);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

std::unique_ptr<Application> makeApplication(int& argc, char** argv) {
    const QtMessageHandler previous = qInstallMessageHandler(endWithSentence);
    auto application = std::make_unique<Application>(argc, argv);
    qInstallMessageHandler(previous);
    application->installEventFilter(new WrappedTips(application.get()));
    return application;
}

GlInfo requireOpenGl() {
    if (tooFewThreadsForOpenGl())
        throwInput(QT_TRANSLATE_NOOP("core",
                                     "OpenGL cannot be started, for want of threads. Close other programs, or allow this one "
                                     "more (ulimit -u)."));
    QOffscreenSurface surface;
    surface.setFormat(QSurfaceFormat::defaultFormat());
    surface.create();
    QOpenGLContext context;
    context.setFormat(QSurfaceFormat::defaultFormat());
    const bool made = surface.isValid() && context.create() && context.makeCurrent(&surface);
    if (!made && memoryIsShort())
        throwInput(QT_TRANSLATE_NOOP("core",
                                     "OpenGL cannot be started, for want of memory. Close other programs, or allow this one more "
                                     "(ulimit -v)."));
    if (!made)
        throwOpenGl(QT_TRANSLATE_NOOP("core",
                                      "This display offers no OpenGL 4.5. Update the graphics driver, or use cullbench, which "
                                      "needs no display."));
    const GlInfo info = requireOpenGl45();
    context.doneCurrent();
    return info;
}

void showWithoutTerminal(const Error& error) {
    if (isatty(STDERR_FILENO) == 1) return;
    QMessageBox box(QMessageBox::Critical, QStringLiteral("Cullscope"), translated(error.message()), QMessageBox::Close);
    QTimer::singleShot(kMessageTime, &box, &QDialog::reject);
    box.exec();
}

}  // namespace cullscope::ui
