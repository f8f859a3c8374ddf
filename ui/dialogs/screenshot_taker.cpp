#include "ui/dialogs/screenshot_taker.h"

#include "core/base/error.h"
#include "core/image/picture_file.h"
#include "ui/dialogs/screenshot_dialog.h"
#include "ui/jobs/picture_tiles.h"
#include "ui/session/session_file.h"

namespace cullscope::ui {

namespace {

constexpr int kPatience = 700;  // ms that a screenshot may take before its progress window opens
constexpr int kPercent = 100;

/// The wipe of the view, without the labels that the window adds.
PictureExtras wipeOf(const Session& session, int view) {
    PictureExtras extras;
    extras.wipe = session.setup(view).wipe;
    return extras;
}

}  // namespace

ScreenshotTaker::ScreenshotTaker(Session& session, QWidget* window)
    : QObject(window),
      m_session(session),
      m_window(window),
      m_sessionText([] { return std::string(); }),
      m_extras([&session](int view) { return wipeOf(session, view); }) {}

ScreenshotTaker::~ScreenshotTaker() { delete m_progress; }

void ScreenshotTaker::take(bool overlays) {
    ScreenshotSettings settings = ScreenshotSettings::load();
    if (!overlays) settings.options.overlays = settings.options.legend = settings.options.caption = false;
    take(settings);
}

void ScreenshotTaker::askAndTake() {
    ScreenshotDialog dialog(m_session, m_extras, ScreenshotSettings::load(), m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    dialog.settings().save();
    take(dialog.settings());
}

void ScreenshotTaker::take(const ScreenshotSettings& settings) {
    if (!m_session.gpu()) return;
    try {
        const std::filesystem::path path = screenshotPath(m_session, settings);
        ScreenshotPlan plan = planScreenshot(m_session, settings.options, m_extras, keepsDepth(path));
        plan.metadata.emplace_back(kSessionMetadata, m_sessionText());
        m_waiting.push_back({std::move(plan), settings});
    } catch (const Error& error) {
        emit failed(error.message());
        return;
    }
    if (!m_running) startNext();
}

void ScreenshotTaker::startNext() {
    if (m_waiting.empty()) return;
    const Order order = std::move(m_waiting.front());
    m_waiting.pop_front();
    std::filesystem::path path;
    try {
        // Not before: the screenshot written just now has used up a file number.
        path = screenshotPath(m_session, order.settings);
    } catch (const Error& error) {
        emit failed(error.message());
        return startNext();
    }
    m_running = std::make_unique<Screenshot>(*m_session.gpu(), m_session.frames(), order.plan, path);
    showProgress();
    connect(m_running.get(), &Screenshot::progressed, this, [this](double share) {
        if (m_progress) m_progress->setValue(std::min(int(share * kPercent), kPercent - 1));
        emit progressed(share);
    });
    connect(m_running.get(), &Screenshot::done, this, [this](const QString& file) {
        finish();
        emit done(file);
        startNext();
    });
    connect(m_running.get(), &Screenshot::failed, this, [this](const Message& message) {
        finish();
        emit failed(message);
        startNext();
    });
    m_running->start();
}

void ScreenshotTaker::showProgress() {
    if (!m_window) return;
    m_progress = new QProgressDialog(tr("Saving the screenshot…"), tr("Cancel"), 0, kPercent, m_window);
    m_progress->setMinimumDuration(kPatience);
    m_progress->setAutoClose(false);
    m_progress->setAutoReset(false);
    connect(m_progress, &QProgressDialog::canceled, this, &ScreenshotTaker::cancel);
    m_progress->setValue(0);
}

void ScreenshotTaker::finish() {
    if (m_progress) m_progress->deleteLater();
    m_progress.clear();
    // Deferred: this function runs in a signal of that very object.
    m_running.release()->deleteLater();
}

void ScreenshotTaker::cancel() {
    m_waiting.clear();
    if (!m_running) return;
    m_running->cancel();
    finish();
    emit cancelled();
}

QImage ScreenshotTaker::clipboardImage(int view, bool overlays) {
    std::optional<ViewRequest> request = m_session.viewRequest(view);
    if (!request) return {};
    if (!overlays) {
        request->look.leaveOutOverlays();
        request->wipe = Wipe::Mode::None;
    }
    const ViewPicturePointer shown = m_session.picture(view);
    const ViewPicturePointer picture = shown && shown->request == *request ? shown : m_session.pictures()->drawNow(*request);
    if (!overlays) return picture->colour;
    QImage image = newImage(request->size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paintPicture(painter, QRectF(image.rect()), *picture, m_extras(view));
    painter.end();
    return image;
}

}  // namespace cullscope::ui
