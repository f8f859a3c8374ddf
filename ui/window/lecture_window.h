#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <array>

#include "ui/panels/structure_panel.h"
#include "ui/session/lesson_player.h"
#include "ui/session/stepper.h"
#include "ui/text/language.h"
#include "ui/views/view_grid.h"
#include "ui/window/legend_strip.h"
#include "ui/window/pointer_spot.h"

namespace cullscope::ui {

/// The window of a lecture: what the main window shows, full screen and light, in letters that can be read from the back row. One
/// view, or a view and the one that watches it, stand beside the strategy's map or tree and its listing; more views stand beside
/// each other. Figures are hidden until they are asked for (R). Page Up and Page Down (a presenter's clicker) walk through the
/// lesson, the stepped frame, or the views; B blanks the screen, P is a pointer, Esc closes the window. The keys of the main
/// window work in it, too.
class LectureWindow : public QWidget {
    Q_OBJECT

public:
    /// Borrows the panes of `views`. Shows `structure` beside the pictures and takes ownership of it. The actions of `parent` are
    /// actions of this window.
    LectureWindow(Session& session, ViewGrid& views, StructurePanel* structure, QWidget* parent = nullptr);
    ~LectureWindow() override;

    /// While a view is stepped, the keys and buttons go through its frame, not through the views. Outlives this window.
    void setStepper(Stepper* stepper);
    /// While a lesson is on, they go through the lesson, whose sentence stands over the pictures. Both outlive this window.
    void setLessons(LessonPlayer* lessons, const Language* language);
    /// Shows the window, on the second screen if there is one.
    void begin();
    /// The active one of the shown views; -1: the window is not open.
    [[nodiscard]] int shownView() const { return m_panes.empty() ? -1 : m_session.activeView(); }
    /// Whether the active view stands alone, or with the one that watches it, although the main window shows more.
    [[nodiscard]] bool alone() const { return m_alone; }
    [[nodiscard]] bool blank() const { return m_blank; }
    /// Whether the figures are shown.
    [[nodiscard]] bool revealed() const { return m_revealed; }
    [[nodiscard]] QString sentence() const { return m_sentence->text(); }
    [[nodiscard]] LegendStrip& legend() { return *m_legend; }
    [[nodiscard]] StructurePanel& structure() { return *m_structure; }
    [[nodiscard]] PointerSpot& spot() { return *m_spot; }

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
    static constexpr int kPageMargin = 16;  ///< pixels at 1280 × 720
    void makeFoot();
    void follow();
    void borrow();
    void giveBack();
    void step(int way);
    void setAlone(bool alone, int view);
    void setBlank(bool blank);
    void reveal(bool revealed);
    void arrange();
    void arrangePanes(const QRect& place);
    /// Whether the first view is watched by the second one, and nothing else is shown.
    [[nodiscard]] bool watched() const;
    [[nodiscard]] bool showsStructure() const;
    /// What the legend explains besides the colours of the views.
    [[nodiscard]] LegendStrip::More moreToExplain() const;
    /// Arranges the window where something asks for another room than it has, or for other words.
    void fit();
    void refresh();
    void showFigures();
    [[nodiscard]] std::vector<int> wantedViews() const;
    [[nodiscard]] std::vector<int> views() const;
    [[nodiscard]] bool inLesson() const { return m_lessons && m_lessons->active(); }
    [[nodiscard]] bool stepped() const;
    [[nodiscard]] QString titleText() const;
    [[nodiscard]] QString sentenceText() const;
    /// A length of the 1280 × 720 design, scaled to the screen.
    [[nodiscard]] int scaled(int length) const;

    Session& m_session;
    Stepper* m_stepper = nullptr;
    LessonPlayer* m_lessons = nullptr;
    const Language* m_language = nullptr;
    ViewGrid& m_views;
    std::vector<ViewPane*> m_panes;
    QLabel *m_title, *m_place, *m_sentence, *m_stepSentence;
    StructurePanel* m_structure;
    LegendStrip* m_legend;
    QWidget* m_foot;
    std::array<QLabel*, 3> m_numbers{};
    QPushButton* m_ask = nullptr;  ///< in place of the figures until they are asked for
    QLabel* m_software = nullptr;  ///< badge beside the speed: software OpenGL
    QPushButton *m_back, *m_next;
    PointerSpot* m_spot;
    int m_belowMap = 0;  ///< the height for which there is room below the map
    QTimer m_nothingPicked;
    bool m_asked = false;  ///< something was picked: why stands beside the views
    bool m_alone = false;
    bool m_blank = false;
    bool m_revealed = false;
};

}  // namespace cullscope::ui
