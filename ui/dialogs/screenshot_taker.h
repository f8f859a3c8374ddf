#pragma once

#include <QPointer>
#include <QProgressDialog>
#include <deque>

#include "ui/screenshots/screenshot.h"
#include "ui/screenshots/screenshot_settings.h"

namespace cullscope::ui {

/// Takes screenshots of what a session shows, one after the other, without blocking the window. A screenshot shows the session as
/// it was at the call of take(). One that takes long has a small window with its progress and a cancel button.
class ScreenshotTaker : public QObject {
    Q_OBJECT

public:
    /// Returns the session's state as JSON, for the file's metadata.
    using SessionText = std::function<std::string()>;

    /// `window` is the parent of the dialogs; null: no dialogs are shown.
    explicit ScreenshotTaker(Session& session, QWidget* window = nullptr);
    ~ScreenshotTaker() override;

    void setSessionText(SessionText text) { m_sessionText = std::move(text); }
    /// Sets the overlays that the window paints over a view's picture.
    void setExtras(ExtrasOf extras) { m_extras = std::move(extras); }

    /// Takes a screenshot with the settings of the last one, without a dialog. Without `overlays` it has no legend and no caption
    /// either.
    void take(bool overlays = true);
    void askAndTake();
    /// Takes a screenshot with the given settings.
    void take(const ScreenshotSettings& settings);
    [[nodiscard]] bool busy() const { return m_running || !m_waiting.empty(); }
    /// Stops the running screenshot and drops the waiting ones.
    void cancel();

    /// The picture that a view shows in the window, with or without the overlays; null: the view shows none. Throws what core
    /// throws if the picture has to be drawn first.
    [[nodiscard]] QImage clipboardImage(int view, bool overlays);

signals:
    void progressed(double share);
    /// Emitted after the file was written.
    void done(const QString& path);
    void failed(const cullscope::Message& message);
    void cancelled();

private:
    struct Order {
        ScreenshotPlan plan;
        ScreenshotSettings settings;
    };

    void startNext();
    void finish();
    void showProgress();

    Session& m_session;
    QPointer<QWidget> m_window;
    SessionText m_sessionText;
    ExtrasOf m_extras;
    std::deque<Order> m_waiting;
    std::unique_ptr<Screenshot> m_running;
    QPointer<QProgressDialog> m_progress;
};

}  // namespace cullscope::ui
