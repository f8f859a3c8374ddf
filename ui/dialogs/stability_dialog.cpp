#include "ui/dialogs/stability_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/experiments/reports.h"
#include "core/gpu/context.h"
#include "ui/statistics/history_store.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr QSize kStabilitySize{1320, 640};
constexpr int kCaseColumn = 0, kVerdictColumn = 1, kRightColumn = 2, kFoundColumn = 3, kCaseColumns = 4;
constexpr std::array<int, 3> kCaseColumnWidths{430, 80, 380};  // the last column takes the rest

QString findingWords(const Message& message) {
    // A number alone is the same in every language.
    return message.text == "%1" && !message.arguments.empty() ? QString::fromStdString(message.arguments.front())
                                                              : translated(message);
}

}  // namespace

StabilityDialog::StabilityDialog(Session& session, QWidget* parent)
    : RunDialog(session, Measures::Losses, parent),
      m_conclusion(new QLabel(this)),
      m_cases(new QTreeWidget(this)),
      m_progress(new QProgressBar(this)),
      m_run(new QPushButton(tr("&Run all"), this)),
      m_runChosen(new QPushButton(tr("Run the &chosen cases"), this)),
      m_cancel(new QPushButton(tr("C&ancel"), this)),
      m_close(new QPushButton(tr("C&lose"), this)) {
    setWindowTitle(tr("Stability: the battery of extreme cases"));
    m_conclusion->setWordWrap(true);
    m_cases->setColumnCount(kCaseColumns);
    m_cases->setHeaderLabels({tr("Case"), tr("Verdict"), tr("Right answer"), tr("Found")});
    m_cases->setAccessibleName(tr("Cases with their right answers and what was found"));
    m_cases->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_cases->setAlternatingRowColors(true);
    for (size_t column = 0; column < kCaseColumnWidths.size(); ++column)
        m_cases->setColumnWidth(int(column), kCaseColumnWidths[column]);
    m_cases->header()->setStretchLastSection(true);
    m_progress->setAccessibleName(tr("Progress"));
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_progress, 1);
    for (QPushButton* button : {m_run, m_runChosen, m_cancel, m_close}) bottom->addWidget(button);
    for (QPushButton* button : {m_runChosen, m_cancel, m_close}) button->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_conclusion);
    layout->addWidget(m_cases, 1);
    layout->addLayout(bottom);
    connect(m_run, &QPushButton::clicked, this, [this] { start(stability::casesNamed("")); });
    connect(m_runChosen, &QPushButton::clicked, this, [this] { start(chosen()); });
    cancelBy(m_cancel);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_cases, &QTreeWidget::itemSelectionChanged, this, &StabilityDialog::showState);
    connect(m_cases, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) { openSceneOf(*item); });
    fill();
    showState();
    resize(kStabilitySize.boundedTo(screen()->availableGeometry().size()));
}

void StabilityDialog::fill() {
    for (const stability::StabilityCase& which : stability::battery()) {
        auto* item = new QTreeWidgetItem(m_cases);
        item->setText(kCaseColumn, QStringLiteral("%1  %2").arg(which.number).arg(translated(which.title)));
        item->setText(kRightColumn, translated(which.expected));
        item->setData(kCaseColumn, Qt::UserRole, QString::fromStdString(which.id));
        const QString scene = tr("Double click: open %1").arg(QString::fromStdString(which.scene));
        item->setToolTip(kCaseColumn, item->text(kCaseColumn) + QLatin1Char('\n') + scene);
        item->setToolTip(kRightColumn, item->text(kRightColumn));
    }
}

QTreeWidgetItem* StabilityDialog::itemOf(const stability::StabilityCase& which) const {
    return m_cases->topLevelItem(int(&which - stability::battery().data()));
}

std::vector<const stability::StabilityCase*> StabilityDialog::chosen() const {
    std::vector<const stability::StabilityCase*> cases;
    for (const stability::StabilityCase& which : stability::battery()) {
        const QTreeWidgetItem& item = *itemOf(which);
        bool selected = item.isSelected();
        for (int child = 0; child < item.childCount(); ++child) selected = selected || item.child(child)->isSelected();
        if (selected) cases.push_back(&which);
    }
    return cases;
}

void StabilityDialog::openSceneOf(const QTreeWidgetItem& item) {
    const QTreeWidgetItem& top = item.parent() != nullptr ? *item.parent() : item;
    const stability::StabilityCase& which =
        *stability::casesNamed(top.data(kCaseColumn, Qt::UserRole).toString().toStdString()).front();
    emit sceneWanted(QString::fromStdString(which.scene));
}

void StabilityDialog::start(const std::vector<const stability::StabilityCase*>& cases) {
    if (running() || cases.empty()) return;
    m_results.clear();
    m_asked = cases.size();
    for (const stability::StabilityCase* which : cases) {
        QTreeWidgetItem& item = *itemOf(*which);
        qDeleteAll(item.takeChildren());
        item.setText(kVerdictColumn, QStringLiteral("…"));
        item.setText(kFoundColumn, {});
    }
    run([this, cases](const Progress& progress) -> Result {
        Renderer renderer;
        const GlInfo gl = requireOpenGl45();
        for (const stability::StabilityCase* which : cases) {
            stability::CaseResult result = stability::runCase({renderer, gl, {nullptr, progress.stop}}, *which);
            whileRunning([this, result = std::move(result)] { showResult(result); });
        }
        return [this, gl] { keepReport(m_session, reportOf(m_results, gl)); };
    });
}

void StabilityDialog::showResult(const stability::CaseResult& result) {
    QTreeWidgetItem& item = *itemOf(*result.which);
    item.setText(kVerdictColumn, result.right() ? tr("right") : tr("WRONG"));
    item.setText(kFoundColumn, translated(result.found()));
    item.setToolTip(kFoundColumn, item.text(kFoundColumn));
    for (const stability::Finding& finding : result.findings) {
        auto* row = new QTreeWidgetItem(&item);
        row->setText(kCaseColumn, QString::fromStdString(finding.subject));
        row->setText(kVerdictColumn, !finding.right    ? tr("WRONG")
                                     : finding.control ? tr("control")
                                     : finding.refused ? tr("refuses")
                                                       : tr("right"));
        row->setText(kRightColumn, findingWords(finding.expected));
        row->setText(kFoundColumn, findingWords(finding.found));
        row->setToolTip(kFoundColumn, row->text(kFoundColumn));
    }
    if (!result.right()) item.setExpanded(true);
    m_results.push_back(result);
    showState();
}

void StabilityDialog::showFailure(const Message& failure) { m_session.raise(Severity::Error, failure); }

void StabilityDialog::showState() {
    for (int row = 0; !running() && row < m_cases->topLevelItemCount(); ++row)
        if (m_cases->topLevelItem(row)->text(kVerdictColumn) == QStringLiteral("…"))
            m_cases->topLevelItem(row)->setText(kVerdictColumn, {});
    m_run->setEnabled(!running());
    m_runChosen->setEnabled(!running() && !m_cases->selectedItems().isEmpty());
    m_cancel->setEnabled(running());
    m_progress->setRange(0, std::max(1, int(m_asked)));
    m_progress->setValue(int(m_results.size()));
    const auto wrong = std::ranges::count_if(m_results, [](const stability::CaseResult& result) { return !result.right(); });
    if (m_results.empty())
        m_conclusion->setText(
            tr("Each case is a scene or a computation at the edge of what numbers hold, with its right answer. "
               "Run them, and see what every strategy does there; a double click opens the scene."));
    else if (wrong > 0)
        m_conclusion->setText(tr("%1 of %2 cases are wrong.").arg(wrong).arg(m_results.size()));
    else
        m_conclusion->setText(tr("All %1 cases are right.").arg(m_results.size()));
}

}  // namespace cullscope::ui
