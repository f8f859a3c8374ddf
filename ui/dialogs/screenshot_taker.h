#pragma once

#include <QPointer>
#include <QProgressDialog>
#include <deque>

#include "ui/screenshots/screenshot.h"
#include "ui/screenshots/screenshot_settings.h"

namespace cullscope::ui {

/// Takes screenshots of what a session shows, one after the other, without stopping the window; what a screenshot shows is fixed
/// when it is asked for. A picture that takes a while has a small window with its progress and a button that stops it.
class ScreenshotTaker : public QObject {
    Q_OBJECT

public:
    /// JSON of the session's state, for the file's metadata.
    using SessionText = std::function<std::string()>;

    /// `window` is the dialogs' parent; null: no dialogs.
    explicit ScreenshotTaker(Session& session, QWidget* window = nullptr);
    ~ScreenshotTaker() override;

    void setSessionText(SessionText text) { m_sessionText = std::move(text); }
    /// What is painted over the pictures in the window.
    void setExtras(ExtrasOf extras) { m_extras = std::move(extras); }

    /// As the last time, without asking. Without overlays: the pictures alone, no legend and no caption either.
    void take(bool overlays = true);
    void askAndTake();
    /// The same with given settings.
    void take(const ScreenshotSettings& settings);
    [[nodiscard]] bool busy() const { return m_running || !m_waiting.empty(); }
    /// Stops the one under way and forgets those that wait.
    void cancel();

    /// The picture that a view shows in the window, with what is painted over it or without; null: it shows none. Throws what
    /// core throws where it has to be drawn first.
    [[nodiscard]] QImage clipboardImage(int view, bool overlays);

signals:
    void progressed(double share);
    /// A file was written.
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
