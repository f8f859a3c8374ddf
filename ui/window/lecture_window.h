#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <array>

#include "ui/session/stepper.h"
#include "ui/views/view_grid.h"

namespace cullscope::ui {

/// The window of a lecture: one view at a time, full screen and light, with the structure and three numbers in letters that can
/// be read from the back row. Page Up and Page Down (a presenter's clicker) step through the shown views, B blanks the screen,
/// Esc closes it.
class LectureWindow : public QWidget {
    Q_OBJECT

public:
    /// Borrows the panes of `views` one after the other. Shows `structure` beside the picture and takes ownership of it.
    LectureWindow(Session& session, ViewGrid& views, QWidget* structure, QWidget* parent = nullptr);
    ~LectureWindow() override;

    /// While a view is stepped, the keys and buttons go through its frame, not through the views. Outlives this window.
    void setStepper(Stepper* stepper);
    /// Shows the window, on the second screen if there is one.
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
    /// A length of the 1280 × 720 design, scaled to the screen.
    [[nodiscard]] int scaled(int length) const;

    Session& m_session;
    Stepper* m_stepper = nullptr;
    ViewGrid& m_views;
    ViewPane* m_pane = nullptr;
    QLabel* m_title;
    QLabel* m_explanation;
    QWidget* m_structure;
    QWidget* m_foot;
    std::array<QLabel*, 3> m_numbers{};
    QLabel* m_software = nullptr;  ///< badge beside the speed: software OpenGL
    QPushButton *m_back, *m_next;
    bool m_blank = false;
};

}  // namespace cullscope::ui
