#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <array>

#include "ui/views/view_grid.h"

namespace cullscope::ui {

/// The lecture's frame: one view at a time, full screen and light, with its structure and its three numbers large enough for the
/// back row. Page Up and Down (a presenter's clicker) step through the shown views, B blanks, Esc leaves.
class LectureWindow : public QWidget {
    Q_OBJECT

public:
    /// Borrows the panes of `views` one after the other. `structure` stands beside the picture and belongs to this window.
    LectureWindow(Session& session, ViewGrid& views, QWidget* structure, QWidget* parent = nullptr);
    ~LectureWindow() override;

    /// On the second screen where there is one.
    void begin();
    [[nodiscard]] int shownView() const { return m_pane ? m_pane->view() : -1; }
    [[nodiscard]] bool blank() const { return m_blank; }

signals:
    void left();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeFoot();
    void showView(int view);
    void giveBack();
    void step(int way);
    void setBlank(bool blank);
    void arrange();
    void refresh();
    /// One of its lengths at the size it is designed for, scaled to the screen.
    [[nodiscard]] int scaled(int length) const;

    Session& m_session;
    ViewGrid& m_views;
    ViewPane* m_pane = nullptr;
    QLabel* m_title;
    QLabel* m_explanation;
    QWidget* m_structure;
    QWidget* m_foot;
    std::array<QLabel*, 3> m_numbers{};
    QLabel* m_software = nullptr;  ///< beside the speed, which is not a graphics card's
    QPushButton *m_back, *m_next;
    bool m_blank = false;
};

}  // namespace cullscope::ui
