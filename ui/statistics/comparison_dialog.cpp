#include "ui/statistics/comparison_dialog.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "ui/look/row_table.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

QString lostText(const std::optional<Losses>& losses) {
    if (!losses) return QStringLiteral("–");
    return QLocale().toString(qulonglong(losses->beyondSnapping ? losses->missedBeyondSnapping : losses->missedPixels));
}

QString timeOf(const store::Listed& listed) {
    const QDateTime when = QDateTime::fromString(QString::fromStdString(listed.started), Qt::ISODateWithMs);
    return QLocale().toString(when.toLocalTime(), QLocale::ShortFormat);
}

PlotLine lineOf(const store::StoredRun& run, const QString& name) {
    PlotLine line;
    line.name = name.toStdString();
    for (const FrameMeasurement& frame : run.run.frames) line.points.push_back({double(frame.pose), frame.frameMilliseconds});
    return line;
}

}  // namespace

ComparisonDialog::ComparisonDialog(const store::Stored& a, const store::Stored& b, QWidget* parent)
    : QDialog(parent),
      m_a(a),
      m_b(b),
      m_compared(store::compared(a, b)),
      m_table(new QTableWidget(this)),
      m_plot(new LinePlotWidget(this)) {
    setWindowTitle(tr("Compare two experiments"));
    auto* layout = new QVBoxLayout(this);
    auto* head = new QLabel(tr("%1 · A: %2, B: %3", "a scene, and the times of two experiments")
                                .arg(QString::fromStdString(a.listed.scene), timeOf(a.listed), timeOf(b.listed)),
                            this);
    head->setWordWrap(true);
    auto* note = new QLabel(
        tr("A and B were measured one after the other: what else the machine did then is not in the intervals."), this);
    note->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(head);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_plot, 2);
    layout->addWidget(note);
    layout->addWidget(buttons);
    m_plot->setMinimumHeight(220);
    m_table->setMinimumHeight(120);
    fill();
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) { showPlot(row); });
    m_table->setCurrentCell(0, 0);
    showPlot(0);
    resize(860, 560);
}

void ComparisonDialog::fill() {
    const QStringList titles{tr("Strategy"),    tr("Poses"),       tr("A, ms"),       tr("B, ms"),
                             tr("× of B to A"), tr("Missed by A"), tr("Missed by B"), tr("What the interval says")};
    setUpRows(*m_table, titles);
    m_table->setRowCount(int(m_compared.size()));
    m_table->setAccessibleName(windowTitle());
    const QLocale locale;
    for (int row = 0; row < int(m_compared.size()); ++row) {
        const store::Compared& each = m_compared[size_t(row)];
        QString ratio = QStringLiteral("×%1").arg(locale.toString(each.ratio.ratio, 'f', 2));
        if (each.ratio.hasInterval)
            ratio += QStringLiteral(" [%1, %2]")
                         .arg(locale.toString(each.ratio.ci95[0], 'f', 2), locale.toString(each.ratio.ci95[1], 'f', 2));
        const QString verdict = !each.ratio.hasInterval    ? tr("of single frames there is no interval")
                                : each.ratio.ci95[0] > 1.0 ? tr("B is faster")
                                : each.ratio.ci95[1] < 1.0 ? tr("B is slower")
                                                           : tr("no difference that it tells");
        const QStringList cells{QString::fromStdString(each.a).replace(QLatin1Char(':'), QLatin1Char(' ')),
                                QString::number(each.poses),
                                locale.toString(each.msOfA, 'f', 3),
                                locale.toString(each.msOfB, 'f', 3),
                                ratio,
                                lostText(each.lostByA),
                                lostText(each.lostByB),
                                verdict};
        for (int column = 0; column < int(cells.size()); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            const bool words = column == 0 || column + 1 == int(cells.size());
            item->setTextAlignment((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
    }
    m_table->resizeColumnsToContents();
}

void ComparisonDialog::showPlot(int row) {
    if (row < 0 || row >= int(m_compared.size())) return;
    const std::string& strategy = m_compared[size_t(row)].a;
    LinePlot plot;
    plot.title = QString::fromStdString(strategy).replace(QLatin1Char(':'), QLatin1Char(' ')).toStdString();
    plot.x.title = tr("Pose").toStdString();
    plot.x.whole = true;
    plot.y.title = tr("Frame, ms").toStdString();
    plot.y.zero = true;
    plot.lines = {lineOf(*m_a.find(strategy), QStringLiteral("A")), lineOf(*m_b.find(strategy), QStringLiteral("B"))};
    m_plot->setPlot(plot);
}

}  // namespace cullscope::ui
