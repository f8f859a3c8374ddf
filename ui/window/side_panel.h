#pragma once

#include <QFrame>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QWidget>
#include <vector>

namespace cullscope::ui {

/// A rail of buttons at the window's left edge, and beside it the page of the pressed button. Covers nothing: what lies beside it
/// gets narrower.
class SidePanel : public QWidget {
    Q_OBJECT

public:
    static constexpr int kRailWidth = 40;
    static constexpr int kPageWidth = 280;

    explicit SidePanel(QWidget* parent = nullptr);

    /// `icon` is a name in resources/icons.
    void addPage(QWidget* page, const QString& icon);
    /// Adds a button that triggers an action, below the buttons of the pages.
    void addAction(QAction* action);
    void setPageTitle(int page, const QString& title);

    /// The number of the open page; -1: none is open.
    [[nodiscard]] int openPage() const { return m_open; }
    void setOpenPage(int page);
    [[nodiscard]] QToolButton& button(int page) { return *m_buttons[size_t(page)]; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void arrange();

    QWidget* m_rail;
    QFrame* m_frame;  ///< around the pages
    QLabel* m_title;
    QStackedWidget* m_pages;
    std::vector<QToolButton*> m_buttons;
    int m_open = -1;
};

}  // namespace cullscope::ui
