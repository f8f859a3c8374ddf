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
constexpr int kSentence = 66;            // of two lines, at most
constexpr int kStructureWidth = 480;     // beside several views
constexpr double kMostOfPicture = 0.46;  // of the width: one picture beside the structure, which is read, too
constexpr double kLeastOfPicture = 0.4;  // the same where little height is left
constexpr double kShapeOfPicture = 4.0 / 3;
constexpr double kMapShare = 0.5;          // of the structure's height: the map, with the view that watches beside it
constexpr double kMapShareByCurve = 0.38;  // the same where a curve stands below, which needs room, too
constexpr int kLeastMap = 110;             // so high is a map at least, above a curve that needs the rest
constexpr double kWatchingWidth = 0.42;    // of the structure's width, at most: that view beside a map
constexpr int kFoot = 56;
constexpr int kButton = 40;
constexpr int kSmallestLetters = 20;
constexpr int kTitleLetters = 26;
constexpr int kSentenceLetters = 24;
constexpr int kNumberLetters = 24;
constexpr int kPaneGap = 4;
constexpr double kWatchingShare = 0.5;  // of the height: the view that watches from outside, over the structure
constexpr double kLeastWatchingShare = 0.3;
constexpr double kWatchingStepsShare = 0.42;  // the same while a frame is stepped, which the listing tells

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
    const int sentence = std::min(scaled(kSentence), m_sentence->heightForWidth(across) + scaled(kPaneGap));
    m_sentence->setGeometry(margin, title, across, sentence);
    m_foot->setGeometry(0, height() - foot, width(), foot);
    m_foot->layout()->activate();
    int bottom = height() - foot;
    m_legend->explain(views(), scaled(kSmallestLetters), moreToExplain());
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
    const int top = title + sentence;
    arrangePanes(QRect(0, top, width(), std::max(1, bottom - top)));
}

bool LectureWindow::watched() const {
    const std::vector<int> shown = views();
    return shown.size() == 2 && m_session.culledBy(shown[0]) == m_session.culledBy(shown[1]);
}

bool LectureWindow::showsStructure() const { return m_panes.size() == 1 || watched() || stepped() || m_asked; }

LegendStrip::More LectureWindow::moreToExplain() const {
    LegendStrip::More more;
    if (m_session.question()) return more;
    const auto add = [&](const MapPanel& panel) {
        const std::vector<TriangleState> states = panel.map().states();
        more.states.insert(more.states.end(), states.begin(), states.end());
        for (const MapLegend::Entry& line : panel.map().lines())
            if (std::ranges::none_of(more.lines, [&](const MapLegend::Entry& other) { return other.words == line.words; }))
                more.lines.push_back(line);
        const QString scale = panel.map().scaleWords();
        if (!scale.isEmpty() && !more.scales.contains(scale)) more.scales << scale;
    };
    if (showsStructure()) {
        more.states = m_structure->statesOfCurve();
        if (!m_structure->map().isHidden()) add(m_structure->map());
    }
    for (const ViewPane* pane : m_panes)
        if (const auto* map = qobject_cast<const MapPanel*>(pane->strip())) add(*map);
    return more;
}

void LectureWindow::fit() {
    const bool room = m_structure->leastBelowMap(m_structure->width()) != m_belowMap;
    if (!m_panes.empty() && (room || m_legend->outdated(views(), moreToExplain()))) arrange();
}

void LectureWindow::arrangePanes(const QRect& place) {
    const std::vector<int> shown = views();
    const bool watched = this->watched(), structure = showsStructure();
    const bool map = structure && !m_structure->map().isHidden();
    const int margin = scaled(kPageMargin);
    // One picture is as wide as its height lets it be. What tells of it has the rest: lines of a listing stay lines.
    const int one = std::clamp(int(kShapeOfPicture * place.height()), int(kLeastOfPicture * place.width()),
                               int(kMostOfPicture * place.width()));
    const int side = !structure ? 0 : shown.size() == 1 || watched ? place.width() - one : scaled(kStructureWidth);
    const QRect pictures = place.adjusted(0, 0, -side, 0);
    QRect inside(pictures.right() + 1 + margin, place.top(), std::max(0, side - 2 * margin), place.height());
    const double ofMap = m_structure->showsCurve() ? kMapShareByCurve : kMapShare;
    int strip = int(ofMap * inside.height());
    m_belowMap = m_structure->leastBelowMap(inside.width());
    if (structure) strip = std::min(strip, std::max(scaled(kLeastMap), inside.height() - m_belowMap));
    // No higher than the map beside the watching view needs: the listing below has ten lines.
    const int widest = watched ? std::min(int(kShapeOfPicture * strip), int(kWatchingWidth * inside.width())) : 0;
    if (map) strip = std::min(strip, m_structure->map().map().wholeHeight(inside.width() - widest - scaled(kPaneGap)));
    int besideMap = 0;
    for (ViewPane* pane : m_panes) {
        pane->setLent(shown.size() == 1 || watched ? ViewPane::Lent::Alone : ViewPane::Lent::Beside, scaled(kSmallestLetters));
        pane->setFiguresHidden(!m_revealed);
    }
    if (watched) {
        m_panes[0]->setCompare(false);
        m_panes[1]->setCompare(false);
        m_panes[0]->setGeometry(pictures);
        if (map) {
            const int across = std::min(int(kShapeOfPicture * strip), widest);
            m_panes[1]->setGeometry(inside.left(), inside.top(), across, strip);
            besideMap = across + scaled(kPaneGap);
        } else {
            // The lines of a listing are read, too: they come before the height of the picture.
            const int most = int((stepped() ? kWatchingStepsShare : kWatchingShare) * place.height());
            const int rest = inside.height() - kPaneGap - m_belowMap;
            const int watching = std::min(most, std::max(rest, int(kLeastWatchingShare * place.height())));
            m_panes[1]->setGeometry(inside.left(), inside.top(), inside.width(), watching);
            inside.setTop(inside.top() + watching + kPaneGap);
        }
    } else {
        const std::vector<QRect> cells = m_views.cells(pictures, shown);
        for (size_t i = 0; i < m_panes.size(); ++i) {
            m_panes[i]->setCompare(shown.size() > 2);
            m_panes[i]->setGeometry(cells[i]);
        }
    }
    m_structure->setAudienceMap(strip, besideMap);
    m_structure->setVisible(structure && !m_blank && !m_session.question());
    m_structure->setGeometry(inside);
    // Now, and not with the next event: what stands beside the map has its place now, too.
    m_structure->layout()->activate();
    // The view beside the map stands in the structure's free room.
    m_structure->lower();
}

}  // namespace cullscope::ui
