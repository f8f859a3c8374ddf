#include "ui/startup/window_picture.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageWriter>
#include <QPixmap>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr int kLookInterval = 50;  // ms between two checks
constexpr int kSettleTime = 150;   // ms that the window gets to paint its last changes

/// As Qt names it.
QByteArray formatOf(const std::filesystem::path& file) {
    return QByteArray::fromStdString(file.extension().string()).mid(1).toLower();
}

}  // namespace

void requireWindowPictureFormat(const std::filesystem::path& file) {
    if (!QImageWriter::supportedImageFormats().contains(formatOf(file)))
        throwUsage("--screenshot %1: name a file that ends in .png or .jpg.", {file.string()});
}

WindowPicture::WindowPicture(MainWindow& window, Session& session, std::filesystem::path file, QObject* parent)
    : QObject(parent), m_window(window), m_session(session), m_file(std::move(file)) {
    m_poll.setInterval(kLookInterval);
    connect(&m_poll, &QTimer::timeout, this, &WindowPicture::look);
    connect(&window.document().opener(), &SessionOpener::failed, this, [this] { m_failed = true; });
    m_poll.start();
}

bool WindowPicture::settled() const {
    if (m_session.loader().loading()) return false;
    const bool uploaded = m_session.buffers() || !m_session.uploadFailure().empty();
    // A large scene has no metrics before the user asks for them; its pictures are drawn all the same.
    const bool drawn = !m_session.pictures() || !m_session.pictures()->busy();
    return m_failed || (m_session.opened() && uploaded && drawn && m_session.metricsSettled());
}

void WindowPicture::look() {
    if (!settled()) return;
    m_poll.stop();
    QTimer::singleShot(kSettleTime, this, &WindowPicture::take);
}

void WindowPicture::take() {
    // QWidget::grab() may trigger a layout, which makes metrics stale: then try again.
    const QPixmap picture = m_window.grab();
    if (!settled()) {
        m_poll.start();
        return;
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!picture.save(&buffer, formatOf(m_file).constData())) bytes.clear();
    if (bytes.isEmpty()) {
        m_session.raise(Severity::Error, {QT_TRANSLATE_NOOP("core", "There is not enough memory."), {}});
        emit done(3);
        return;
    }
    try {
        writeFileAtomically(m_file, [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
    } catch (const Error& failure) {
        m_session.raise(Severity::Error, failure.message());
        emit done(2);
        return;
    }
    emit done(m_failed ? 3 : m_session.uploadFailure().empty() ? 0 : 4);
}

}  // namespace cullscope::ui
