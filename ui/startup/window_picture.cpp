#include "ui/startup/window_picture.h"

#include <QPixmap>
#include <QSaveFile>
#include <cstdio>

namespace cullscope::ui {

namespace {

constexpr int kLookInterval = 50;  // ms between two checks
constexpr int kSettleTime = 150;   // ms that the window gets to paint its last changes

}  // namespace

WindowPicture::WindowPicture(MainWindow& window, Session& session, QString file, QObject* parent)
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
    const QByteArray format = m_file.section(QLatin1Char('.'), -1).toLatin1();
    QSaveFile file(m_file);
    if (!file.open(QIODevice::WriteOnly) || !picture.save(&file, format.constData()) || !file.commit()) {
        std::fprintf(stderr,
                     "cullscope: %s cannot be written. Name a file ending in .png or .jpg in a folder that can be written to.\n",
                     qPrintable(m_file));
        emit done(2);
        return;
    }
    emit done(m_failed ? 3 : m_session.uploadFailure().empty() ? 0 : 4);
}

}  // namespace cullscope::ui
