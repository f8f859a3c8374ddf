#include "ui/panels/plane_legend.h"

#include "core/frame/cause.h"
#include "ui/look/plane_swatch.h"
#include "ui/look/verdict_swatch.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kTwoColumnRows = 4;

}  // namespace

PlaneLegend::PlaneLegend(QWidget* parent) : QWidget(parent), m_heading(new QLabel(this)), m_grid(new QGridLayout(this)) {
    m_heading->setWordWrap(true);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(6);
    m_grid->setVerticalSpacing(2);
    m_grid->addWidget(m_heading, 0, 0, 1, 7);
    for (size_t line = 0; line < kLines; ++line) {
        if (line < kFrustumPlaneCount)
            m_swatches[line] = new PlaneSwatch(FrustumPlane(line), this);
        else
            m_swatches[line] =
                new VerdictSwatch(line == kFrustumPlaneCount ? TriangleState::OutsideFrustum : TriangleState::Visible, this);
        m_words[line] = new QLabel(this);
        m_numbers[line] = new QLabel(this);
        m_numbers[line]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    m_grid->setColumnStretch(1, 1);
    setRows(kTwoColumnRows);
    retranslate();
}

void PlaneLegend::setRows(int rows) {
    const bool oneColumn = rows >= int(kLines);
    for (int line = 0; line < int(kLines); ++line) {
        const int row = 1 + line % rows, column = 4 * (line / rows);
        m_grid->addWidget(m_swatches[size_t(line)], row, column);
        m_grid->addWidget(m_words[size_t(line)], row, column + 1);
        m_grid->addWidget(m_numbers[size_t(line)], row, column + 2);
    }
    m_grid->setColumnMinimumWidth(3, oneColumn ? 0 : 6);
    m_grid->setColumnStretch(5, oneColumn ? 0 : 1);
}

QString PlaneLegend::wordsOf(size_t line) {
    if (line < kFrustumPlaneCount) return translated(planeName(FrustumPlane(line)));
    return line == kFrustumPlaneCount ? tr("no single plane", "rejected a box") : tr("kept", "a box");
}

uint64_t PlaneLegend::countOf(const PlaneCounts& counts, size_t line) {
    if (line < kFrustumPlaneCount) return counts.rejected[line];
    return line == kFrustumPlaneCount ? counts.withoutPlane : counts.kept;
}

void PlaneLegend::setCounts(const std::optional<PlaneCounts>& counts) {
    if (counts == m_counts) return;
    m_counts = counts;
    retranslate();
}

void PlaneLegend::retranslate() {
    m_heading->setText(tr("Boxes by the plane that rejected them, in objects:"));
    setAccessibleName(m_heading->text());
    for (size_t line = 0; line < kLines; ++line) {
        const QString words = wordsOf(line);
        m_words[line]->setText(words);
        m_numbers[line]->setText(m_counts ? countText(countOf(*m_counts, line)) : QStringLiteral("…"));
        m_numbers[line]->setAccessibleName(tr("%1: %2 objects", "what became of a box").arg(words, m_numbers[line]->text()));
    }
}

}  // namespace cullscope::ui
