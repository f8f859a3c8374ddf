#include "ui/views/budget_bar.h"

#include <QEvent>
#include <QPainter>
#include <numeric>

#include "ui/look/verdict_swatch.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kNarrowestLoss = 2;
constexpr double kPaleShare = 0.35;
constexpr auto kLoss = size_t(TriangleState::WronglyCulled);

}  // namespace

BudgetBar::BudgetBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFixedHeight(kHeight);
    describe();
}

void BudgetBar::setFigures(const ViewMetrics& figures) {
    if (figures.states && figures.state == ViewMetrics::State::Ready) {
        m_counts = figures.states->counts;
        m_known = true;
        m_stale = false;
    } else if (figures.state == ViewMetrics::State::Stale) {
        m_stale = m_known;
    } else {
        clear();
    }
    describe();
    update();
}

void BudgetBar::clear() {
    m_counts = {};
    m_known = false;
    m_stale = false;
    describe();
    update();
}

std::array<int, kTriangleStateCount> BudgetBar::widths() const {
    std::array<int, kTriangleStateCount> widths{};
    const uint64_t total = std::accumulate(m_counts.begin(), m_counts.end(), uint64_t{0});
    if (total == 0) return widths;
    int whole = width();
    if (m_counts[kLoss] > 0) {
        const int share = int(std::lround(double(m_counts[kLoss]) / double(total) * whole));
        widths[kLoss] = std::min(whole, std::max(kNarrowestLoss, share));
        whole -= widths[kLoss];
    }
    // Round the boundaries and not the widths, so that the widths add up.
    const uint64_t others = total - m_counts[kLoss];
    uint64_t before = 0;
    int left = 0;
    for (size_t state = 0; state < kLoss && others > 0; ++state) {
        before += m_counts[state];
        const int right = int(std::lround(double(before) / double(others) * whole));
        widths[state] = right - left;
        left = right;
    }
    if (others == 0) widths[kLoss] = width();
    return widths;
}

void BudgetBar::describe() {
    setAccessibleName(tr("Where the triangles went"));
    QStringList lines;
    const uint64_t total = std::accumulate(m_counts.begin(), m_counts.end(), uint64_t{0});
    for (size_t state = 0; state < kTriangleStateCount && total > 0; ++state) {
        if (m_counts[state] == 0 && state != kLoss) continue;
        //: A state of triangles, how many, and their share of all.
        lines << tr("%1: %2 triangles, %3 %")
                     .arg(translated(triangleStateName(TriangleState(state))), countText(m_counts[state]),
                          percentText(double(m_counts[state]) / double(total)));
    }
    if (!m_known) lines << tr("Not known yet.");
    if (m_stale) lines << tr("The view changed since: being counted anew.");
    setToolTip(lines.join(QLatin1Char('\n')));
    setAccessibleDescription(lines.join(QStringLiteral("; ")));
}

void BudgetBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    if (m_stale) painter.setOpacity(kPaleShare);
    const auto widths = this->widths();
    int left = 0;
    for (size_t state = 0; state < kTriangleStateCount; ++state) {
        if (widths[state] == 0) continue;
        const QRect segment(left, 0, widths[state], height());
        const auto which = TriangleState(state);
        // A hatch or a wireframe would not be legible in so narrow a bar: place, colour and tooltip identify the state.
        painter.fillRect(segment, verdictColour(which, palette()));
        left += widths[state];
        if (left < width() && segment.width() > kNarrowestLoss)
            painter.fillRect(left - 1, 0, 1, height(), palette().color(QPalette::Window));
    }
}

void BudgetBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) describe();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
