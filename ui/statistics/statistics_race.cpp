// The axes of the plot of two figures, and the table of each strategy against each.
#include <QHeaderView>

#include "core/experiments/pairwise.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kRaceRowHeight = 22;
constexpr int kAxisLetters = 16;

QString pairTip(const PairOfRuns& pair, const QString& one, const QString& other) {
    const auto number = [](double value) { return QString::number(value, 'f', 2); };
    QStringList lines{StatisticsPanel::tr("%1 is %2 times as fast as %3.", "a strategy, a ratio, another strategy")
                          .arg(one, QString::fromStdString(pairText(pair)), other)};
    lines << (pair.difference.hasInterval
                  ? StatisticsPanel::tr("It takes %1 ms less a view (95 %: %2 to %3).")
                        .arg(number(pair.difference.ratio), number(pair.difference.ci95[0]), number(pair.difference.ci95[1]))
                  : StatisticsPanel::tr("It takes %1 ms less a view.").arg(number(pair.difference.ratio)));
    if (pair.lostDifference != 0.0)
        lines << StatisticsPanel::tr("It misses %1 of a million pixels more.").arg(number(pair.lostDifference));
    if (!pair.decided()) lines << StatisticsPanel::tr("The interval holds 1: which one is faster is not decided.");
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

void StatisticsPanel::setUpAxes() {
    for (QComboBox* box : {m_across, m_up}) {
        // The longest titles are in the list; the row has no room for them.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kAxisLetters);
        for (const TradeFigure& figure : tradeFigures()) box->addItem({}, QString::fromStdString(figure.key));
        connect(box, &QComboBox::activated, this, [this] {
            m_pareto->setAxes(tradeFigures()[size_t(m_across->currentIndex())], tradeFigures()[size_t(m_up->currentIndex())]);
            refreshControls();
        });
    }
    m_across->setCurrentIndex(m_across->findData(QString::fromLatin1(kUsualAcross)));
    m_up->setCurrentIndex(m_up->findData(QString::fromLatin1(kUsualUp)));
    connect(m_pareto, &ParetoPlot::strategyChosen, this, &StatisticsPanel::strategyChosen);
}

void StatisticsPanel::retranslateAxes() {
    m_across->setAccessibleName(tr("Figure across"));
    m_up->setAccessibleName(tr("Figure upwards"));
    for (QComboBox* box : {m_across, m_up}) {
        box->setToolTip(box->accessibleName());
        for (int i = 0; i < box->count(); ++i) {
            const TradeFigure& figure = tradeFigures()[size_t(i)];
            //: An axis of a plot and its figure.
            box->setItemText(i, (box == m_across ? tr("→ %1") : tr("↑ %1")).arg(translated(figure.title)));
            if (!figure.meaning.empty()) box->setItemData(i, translated(figure.meaning), Qt::ToolTipRole);
        }
    }
}

void StatisticsPanel::setUpRace() {
    m_race->setFrameShape(QFrame::NoFrame);
    m_race->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_race->setAlternatingRowColors(true);
    m_race->setTabKeyNavigation(false);
    m_race->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_race->horizontalHeader()->setSectionsClickable(false);
    m_race->verticalHeader()->setSectionsClickable(false);
    m_race->verticalHeader()->setDefaultSectionSize(kRaceRowHeight);
    m_pages->addWidget(m_race);
}

void StatisticsPanel::refreshRace() {
    if (m_tabs->currentIndex() != Race) return;
    MeasureResult raced;
    if (m_result)
        for (const RunMeasurement& run : m_result->runs)
            if (raced.runs.size() < kMostRaced && !run.frames.empty()) raced.runs.push_back(run);
    const int count = int(raced.runs.size());
    QStringList names;
    for (const RunMeasurement& run : raced.runs) names << runLabel(run.strategy);
    m_race->clear();
    m_race->setRowCount(count);
    m_race->setColumnCount(count);
    m_race->setHorizontalHeaderLabels(names);
    m_race->setVerticalHeaderLabels(names);
    for (const PairOfRuns& pair : pairsOf(raced)) {
        auto* cell = new QTableWidgetItem(QString::fromStdString(pairText(pair)));
        cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        cell->setToolTip(pairTip(pair, names[qsizetype(pair.one)], names[qsizetype(pair.other)]));
        QFont letters = cell->font();
        // Faster, and that is decided.
        letters.setBold(pair.decided() && pair.ratio.ratio > 1.0);
        cell->setFont(letters);
        m_race->setItem(int(pair.one), int(pair.other), cell);
    }
}

}  // namespace cullscope::ui
