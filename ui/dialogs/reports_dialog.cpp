#include "ui/dialogs/reports_dialog.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLocale>
#include <QScreen>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/experiments/store/result_store.h"
#include "ui/look/row_table.h"
#include "ui/statistics/history_store.h"

namespace cullscope::ui {
namespace {

constexpr QSize kReportsSize{1000, 560};
constexpr int kColumnRoom = 12;

QString kindWords(const std::string& kind) {
    if (kind == store::kCertificate) return ReportsDialog::tr("Certificate");
    if (kind == store::kAdvice) return ReportsDialog::tr("Advice");
    if (kind == store::kWorstView) return ReportsDialog::tr("Worst view");
    if (kind == store::kBattery) return ReportsDialog::tr("Battery");
    if (kind == store::kJudgement) return ReportsDialog::tr("Judgement");
    return QString::fromStdString(kind);
}

QString orDash(const std::string& text) {
    return text.empty() ? QStringLiteral("–") : QString::fromStdString(text).replace(QLatin1Char(':'), QLatin1Char(' '));
}

}  // namespace

ReportsDialog::ReportsDialog(Session& session, QWidget* parent)
    : QDialog(parent),
      m_session(session),
      m_table(new QTableWidget(this)),
      m_words(new QPlainTextEdit(this)),
      m_export(new QPushButton(tr("Export…"), this)) {
    setWindowTitle(tr("Kept reports"));
    const QStringList titles{tr("Number"), tr("When"), tr("Kind"), tr("Scene"), tr("Strategy")};
    setUpRows(*m_table, titles);
    m_table->setAccessibleName(windowTitle());
    m_words->setReadOnly(true);
    m_words->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_words->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_words->setAccessibleName(tr("What the report says"));
    m_words->setTabChangesFocus(true);
    m_words->setPlaceholderText(
        tr("What Advice, Worst view and Stability find is kept here, beside the experiments of the statistics' history."));
    auto* both = new QSplitter(Qt::Vertical, this);
    both->setChildrenCollapsible(false);
    both->addWidget(m_table);
    both->addWidget(m_words);
    both->setStretchFactor(0, 1);
    both->setStretchFactor(1, 2);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(m_export, QDialogButtonBox::ActionRole);
    m_export->setToolTip(tr("The chosen report as JSON"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(both, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_export, &QPushButton::clicked, this, &ReportsDialog::askWhereTo);
    connect(m_table, &QTableWidget::currentCellChanged, this, &ReportsDialog::showChosen);
    read();
    resize(kReportsSize.boundedTo(screen()->availableGeometry().size()));
}

bool ReportsDialog::event(QEvent* event) {
    if (event->type() == QEvent::WindowActivate) read();
    return QDialog::event(event);
}

void ReportsDialog::read() {
    std::vector<store::StoredReport> reports;
    try {
        reports = store::ResultStore(historyStore()).reports();
    } catch (const Error& failure) {
        m_session.raise(Severity::Warning, failure.message());
    }
    std::ranges::reverse(reports);
    const auto sameNumber = [](const store::StoredReport& a, const store::StoredReport& b) { return a.number == b.number; };
    if (m_table->rowCount() > 0 && std::ranges::equal(reports, m_reports, sameNumber)) return;
    m_reports = std::move(reports);
    fill();
}

void ReportsDialog::fill() {
    m_table->setRowCount(int(m_reports.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const store::StoredReport& each = m_reports[size_t(row)];
        const QDateTime added = QDateTime::fromString(QString::fromStdString(each.added), Qt::ISODateWithMs);
        const QStringList cells{QString::number(each.number), QLocale().toString(added.toLocalTime(), QLocale::ShortFormat),
                                kindWords(each.report.kind), orDash(each.report.scene), orDash(each.report.strategy)};
        for (int column = 0; column < int(cells.size()); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setTextAlignment((column == 0 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
    }
    m_table->resizeColumnsToContents();
    for (int column = 0; column < m_table->columnCount(); ++column)
        m_table->setColumnWidth(column, m_table->columnWidth(column) + kColumnRoom);
    if (!m_reports.empty()) m_table->setCurrentCell(0, 0);
    showChosen();
}

const store::StoredReport* ReportsDialog::chosen() const {
    const int row = m_table->currentRow();
    return row >= 0 && size_t(row) < m_reports.size() ? &m_reports[size_t(row)] : nullptr;
}

void ReportsDialog::showChosen() {
    const store::StoredReport* report = chosen();
    m_export->setEnabled(report != nullptr);
    if (report == nullptr) return m_words->clear();
    const std::string& words = report->report.words;
    m_words->setPlainText(QString::fromStdString(words.empty() ? report->report.document : words));
}

void ReportsDialog::askWhereTo() {
    QFileDialog dialog(this, tr("Export"), {}, QStringLiteral("JSON (*.json)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    if (dialog.exec() == QDialog::Accepted) save(dialog.selectedFiles().front());
}

void ReportsDialog::save(const QString& path) {
    const store::StoredReport* report = chosen();
    if (report == nullptr) return;
    try {
        writeFileAtomically(path.toStdString(), [&](std::ostream& out) { out << report->report.document; });
        m_session.tellSaved(path);
    } catch (const Error& failure) {
        m_session.raise(Severity::Error, failure.message());
    }
}

}  // namespace cullscope::ui
