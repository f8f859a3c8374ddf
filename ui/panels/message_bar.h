#pragma once

#include <QFrame>
#include <QLabel>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <functional>
#include <string>

#include "core/base/message.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Shows one sentence in a status bar until the user closes it or another sentence replaces it. Information also disappears after
/// six seconds (setInformationTime), or at the next click or key press in the window. The bar never blocks the user, covers
/// nothing, and takes no room from the views: what is longer than its line ends in dots, with a button that shows all of it.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    /// Joins the status bar.
    explicit MessageBar(QStatusBar& bar);

    /// How long information stays; 6000 unless it is set.
    void setInformationTime(int milliseconds) { m_end.setInterval(milliseconds); }
    void show(Severity severity, const Message& message);
    /// Shows a sentence with a button that does something about it and closes the bar. Sentence and button are marked for
    /// translation.
    void offer(Severity severity, const Message& message, const std::string& action, std::function<void()> take);
    /// Confirms that a file was written, and offers to open its folder.
    void confirmSaved(const QString& file);
    /// What opens a folder; the desktop's own program unless it is set.
    void setFolderOpener(std::function<void(const QString&)> open) { m_openFolder = std::move(open); }
    /// The button; hidden where nothing is offered.
    [[nodiscard]] QToolButton& offered() { return *m_take; }
    [[nodiscard]] QString text() const { return translatedText(); }
    /// The button that shows a sentence that is longer than the line; hidden where all of it is shown.
    [[nodiscard]] QToolButton& whole() { return *m_whole; }

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    [[nodiscard]] QString translatedText() const;
    /// Shows as much of the sentence as the line has room for.
    void fit();
    void showWhole();

    QLabel* m_icon;
    QLabel* m_text;
    QToolButton* m_take;
    QToolButton* m_whole;
    QToolButton* m_close;
    std::string m_action;
    std::function<void()> m_taken;
    std::function<void(const QString&)> m_openFolder;
    Severity m_severity = Severity::Information;
    Message m_message;
    QTimer m_end;
};

}  // namespace cullscope::ui
