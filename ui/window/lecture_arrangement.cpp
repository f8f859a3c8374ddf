// Where everything stands in the lecture window.
#include "ui/window/lecture_window.h"

#include <QAction>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QScreen>
#include <algorithm>

#include "core/visibility/registry.h"
#include "ui/look/appearance.h"
#include "ui/panels/question_bar.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

// Lengths for a screen of 1280 × 720; larger screens scale them.
constexpr QSize kDesign{1280, 720};
constexpr int kTitle = 44;
constexpr int kSentence = 66;
constexpr int kStructureWidth = 480;
constexpr int kMapHeight = 260;
constexpr double kMapShare = 0.52;         // of the structure's height, at most
constexpr double kMapShareByCurve = 0.45;  // the same where a curve stands below, which needs room, too
constexpr int kFoot = 56;
constexpr int kButton = 40;
constexpr int kSmallestLetters = 20;
constexpr int kTitleLetters = 26;
constexpr int kSentenceLetters = 24;
constexpr int kNumberLetters = 24;
constexpr int kPaneGap = 4;
constexpr double kWatchingStepsShare = 0.32;  // the same while a frame is stepped, which the listing tells
constexpr double kWatchingByMapShare = 0.26;  // the same where a map needs room
constexpr double kWatchingShare = 0.45;       // of the height: the view that watches from outside, over the structure

void setLetters(QWidget& widget, int pixels, bool bold = false) {
    QFont font = widget.font();
    font.setPixelSize(pixels);
    font.setBold(bold);
    widget.setFont(font);
}

}  // namespace

int LectureWindow::scaled(int length) const {
    const double scale = std::min(double(width()) / kDesign.width(), double(height()) / kDesign.height());
    return int(length * scale);
}

void LectureWindow::arrange() {
    const int title = scaled(kTitle), foot = scaled(kFoot), margin = scaled(kPageMargin), across = width() - 2 * margin;
    setLetters(*m_title, scaled(kTitleLetters), true);
    setLetters(*m_place, scaled(kTitleLetters));
    for (QLabel* words : {m_sentence, m_stepSentence}) setLetters(*words, scaled(kSentenceLetters));
    for (QWidget* small : std::initializer_list<QWidget*>{m_structure, m_software, m_back, m_next, m_ask})
        setLetters(*small, scaled(kSmallestLetters));
    for (QLabel* number : m_numbers) setLetters(*number, scaled(kNumberLetters), true);
    for (QPushButton* button : {m_back, m_next}) button->setMinimumSize(scaled(3 * kButton), scaled(kButton));
    m_ask->setMinimumHeight(scaled(kButton));
    const int place = m_place->sizeHint().width();
    m_title->setGeometry(margin, 0, across - place - margin, title);
    m_place->setGeometry(margin + across - place, 0, place, title);
    m_sentence->setGeometry(margin, title, across, scaled(kSentence));
    m_foot->setGeometry(0, height() - foot, width(), foot);
    m_foot->layout()->activate();
    int bottom = height() - foot;
    m_legend->explain(views(), scaled(kSmallestLetters));
    m_legend->setVisible(!m_blank && !m_legend->empty());
    if (!m_legend->empty()) {
        const int high = m_legend->layout()->heightForWidth(across) + scaled(kPaneGap);
        m_legend->setGeometry(margin, bottom - high, across, high);
        bottom -= high;
    }
    m_stepSentence->setVisible(!m_blank && !m_stepSentence->text().isEmpty());
    if (!m_stepSentence->text().isEmpty()) {
        const int high = 2 * lineHeight(m_stepSentence->fontMetrics()) + scaled(kPaneGap);
        m_stepSentence->setGeometry(margin, bottom - high, across, high);
        bottom -= high;
    }
    const int top = title + scaled(kSentence);
    arrangePanes(QRect(0, top, width(), std::max(1, bottom - top)));
}

void LectureWindow::arrangePanes(const QRect& place) {
    const std::vector<int> shown = views();
    const bool watched = shown.size() == 2 && m_session.culledBy(shown[0]) == m_session.culledBy(shown[1]);
    const bool structure = shown.size() == 1 || watched || stepped();
    const bool map = structure && !m_structure->map().isHidden();
    const int side = structure ? scaled(kStructureWidth) : 0, margin = scaled(kPageMargin);
    QRect pictures = place.adjusted(0, 0, -side, 0);
    QRect inside(pictures.right() + 1 + margin, place.top(), std::max(0, side - 2 * margin), place.height());
    for (ViewPane* pane : m_panes) {
        pane->setLent(shown.size() == 1 || watched ? ViewPane::Lent::Alone : ViewPane::Lent::Beside, scaled(kSmallestLetters));
        pane->setFiguresHidden(!m_revealed);
    }
    if (watched) {
        m_panes[0]->setCompare(false);
        m_panes[1]->setCompare(false);
        const double share = map ? kWatchingByMapShare : stepped() ? kWatchingStepsShare : kWatchingShare;
        const int watching = int(share * place.height());
        m_panes[0]->setGeometry(pictures);
        m_panes[1]->setGeometry(pictures.right() + 1 + kPaneGap, place.top(), side - kPaneGap, watching);
        inside.setTop(place.top() + watching + kPaneGap);
    } else {
        const std::vector<QRect> cells = m_views.cells(pictures, shown);
        for (size_t i = 0; i < m_panes.size(); ++i) {
            m_panes[i]->setCompare(shown.size() > 2);
            m_panes[i]->setGeometry(cells[i]);
        }
    }
    const double ofMap = m_structure->showsCurve() ? kMapShareByCurve : kMapShare;
    m_structure->setAudienceMapHeight(std::min(scaled(kMapHeight), int(ofMap * inside.height())));
    m_structure->setVisible(structure && !m_blank && !m_session.question());
    m_structure->setGeometry(inside);
}

}  // namespace cullscope::ui
