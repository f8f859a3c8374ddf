// The axes of the plot of two figures, and the table of each strategy against each.
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/experiments/pairwise.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kRaceRowHeight = 38;
constexpr int kRaceMargin = 6;

/// "−0.52 ms [−0.60, −0.44]": what the first of a pair takes more or less than the second.
QString savedText(const PairOfRuns& pair) {
    const auto number = [](double value) {
        const QString text = QLocale().toString(std::abs(value), 'f', 2);
        return value > 0.0 ? QStringLiteral("−") + text : value < 0.0 ? QStringLiteral("+") + text : text;
    };
    const RatioEstimate& saved = pair.difference;
    QString text = StatisticsPanel::tr("%1 ms").arg(number(saved.ratio));
    if (saved.hasInterval) text += QStringLiteral(" [%1, %2]").arg(number(saved.ci95[1]), number(saved.ci95[0]));
    return text;
}

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
        // The longest titles are in the list: the row has room for what is chosen alone.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        // With {} in place of QString() the key would be the text of an item with an icon, and no item would have it as its data.
        for (const TradeFigure& figure : tradeFigures()) box->addItem(QString(), QString::fromStdString(figure.key));
        connect(box, &QComboBox::activated, this, [this] {
            m_pareto->setAxes(tradeFigures()[size_t(m_across->currentIndex())], tradeFigures()[size_t(m_up->currentIndex())]);
            fitAxes();
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
            const std::string& name = figure.brief.empty() ? figure.title : figure.brief;
            box->setItemText(i, (box == m_across ? tr("→ %1") : tr("↑ %1")).arg(translated(name)));
            const std::string& tip = figure.meaning.empty() && !figure.brief.empty() ? figure.title : figure.meaning;
            if (!tip.empty()) box->setItemData(i, translated(tip), Qt::ToolTipRole);
        }
    }
    fitAxes();
}

void StatisticsPanel::fitAxes() {
    for (QComboBox* box : {m_across, m_up}) {
        // The length that a box asks for is in letters as wide as X.
        const QFontMetrics metrics(box->font());
        const int letter = std::max(1, metrics.horizontalAdvance(QLatin1Char('X')));
        box->setMinimumContentsLength(1 + (metrics.horizontalAdvance(box->currentText()) + letter - 1) / letter);
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
    m_raceWords->setWordWrap(true);
    m_raceWords->setContentsMargins(kRaceMargin, kRaceMargin, kRaceMargin, kRaceMargin);
    auto* const page = new QWidget(this);
    auto* const layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_raceWords);
    layout->addWidget(m_race, 1);
    m_pages->addWidget(page);
}

void StatisticsPanel::refreshRace() {
    if (m_tabs->currentIndex() != Race) return;
    MeasureResult raced;
    if (m_result)
        for (const RunMeasurement& run : m_result->runs)
            if (raced.runs.size() < kMostRaced && !run.frames.empty()) raced.runs.push_back(run);
    const int count = int(raced.runs.size());
    m_race->setVisible(count > 0);
    m_raceWords->setText(count > 0 ? tr("How many times as fast as the column's strategy the row's is, and how many milliseconds "
                                        "a view it takes less (−) or more (+), "
                                        "each with its 95 % interval. Bold: faster for certain; ≈: not decided.")
                                   : tr("Each strategy is held against each other one as soon as an experiment has ended."));
    QStringList names;
    for (const RunMeasurement& run : raced.runs) names << runLabel(run.strategy);
    m_race->clear();
    m_race->setRowCount(count);
    m_race->setColumnCount(count);
    m_race->setHorizontalHeaderLabels(names);
    m_race->setVerticalHeaderLabels(names);
    for (const PairOfRuns& pair : pairsOf(raced)) {
        auto* cell = new QTableWidgetItem(QString::fromStdString(pairText(pair)) + QLatin1Char('\n') + savedText(pair));
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
