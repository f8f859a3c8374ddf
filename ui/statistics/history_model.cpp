#include "ui/statistics/history_model.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <iterator>

#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

QString pathAndSize(const std::string& path, const Viewport& size) {
    //: A camera path and the size of the pictures.
    return QCoreApplication::translate("cullscope::ui::StatisticsPanel", "%1 · %2 × %3")
        .arg(QString::fromStdString(path).section(QLatin1Char('/'), -1))
        .arg(size.width)
        .arg(size.height);
}

void HistoryModel::setExperiments(std::vector<PastExperiment> experiments) {
    m_all = std::move(experiments);
    std::ranges::reverse(m_all);
    show();
}

void HistoryModel::setFilter(const QString& text) {
    m_filter = text.trimmed();
    show();
}

bool HistoryModel::shown(const PastExperiment& experiment) const {
    const auto has = [&](const QString& text) { return text.contains(m_filter, Qt::CaseInsensitive); };
    return has(experiment.scene) || has(experiment.what) || has(experiment.when.toLocalTime().toString(Qt::ISODate)) ||
           std::ranges::any_of(experiment.rows, [&](const ResultRow& row) { return has(row.name); });
}

void HistoryModel::show() {
    beginResetModel();
    m_experiments.clear();
    std::ranges::copy_if(m_all, std::back_inserter(m_experiments), [&](const PastExperiment& each) { return shown(each); });
    m_strategies.clear();
    for (const PastExperiment& experiment : m_experiments)
        for (const ResultRow& row : experiment.rows)
            if (!m_strategies.contains(row.name)) m_strategies << row.name;
    endResetModel();
}

void HistoryModel::retranslate() {
    if (m_experiments.empty()) return;
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int HistoryModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_strategies.size()); }

int HistoryModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_experiments.size()); }

const ResultRow* HistoryModel::row(const QModelIndex& index) const {
    const std::vector<ResultRow>& rows = m_experiments[size_t(index.column())].rows;
    const auto found = std::ranges::find(rows, m_strategies[index.row()], &ResultRow::name);
    return found == rows.end() ? nullptr : &*found;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
    const ResultRow* measured = row(index);
    if (role == Qt::DisplayRole) {
        if (!measured || !measured->speedup) return QStringLiteral("–");
        const QString speed = QStringLiteral("×%1").arg(QLocale().toString(measured->speedup->ratio, 'f', 2));
        return measured->missedPpm ? tr("%1 · %2 ppm missed", "a ratio of times, missed pixels of a million")
                                         .arg(speed, ResultTableModel::value(*measured, ResultTableModel::MissedPpm))
                                   : speed;
    }
    if (role == Qt::ToolTipRole && measured) return ResultTableModel::value(*measured, ResultTableModel::Speedup);
    return {};
}

QVariant HistoryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (section < 0) return {};
    if (orientation == Qt::Vertical)
        return role == Qt::DisplayRole && section < m_strategies.size() ? QVariant(m_strategies[section]) : QVariant();
    if (size_t(section) >= m_experiments.size()) return {};
    const PastExperiment& experiment = m_experiments[size_t(section)];
    // Of today the time tells them apart, of other days the day.
    const QDateTime when = experiment.when.toLocalTime();
    const QString time = when.date() == QDate::currentDate() ? QLocale().toString(when.time(), QLocale::ShortFormat)
                                                             : QLocale().toString(when, QLocale::ShortFormat);
    if (role == Qt::DisplayRole) {
        const QString text = tr("%1, %2\n%3", "scene, time, path and size").arg(experiment.scene, time, experiment.what);
        // The number that files and error messages call the measurement by.
        return experiment.number > 0 ? tr("%1: %2", "number of a measurement, scene and time").arg(experiment.number).arg(text)
                                     : text;
    }
    if (role == Qt::ToolTipRole) return QLocale().toString(experiment.when.toLocalTime(), QLocale::LongFormat);
    return {};
}

}  // namespace cullscope::ui
