#include "ui/statistics/result_table_model.h"
#include "ui/text/terms.h"

#include <QLocale>
#include <algorithm>
#include <set>

#include "core/experiments/sweeps.h"
#include "ui/statistics/run_figures.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kMillion = 1e6;

ResultRow emptyRow(const StrategyRequest& strategy, Promise promise) {
    ResultRow row;
    row.name = strategyWords(strategy);
    row.id = QString::fromStdString(strategy.id);
    row.promise = promise;
    return row;
}

/// A row of a sweep's table; what is not known there is empty.
class SweepRow {
public:
    SweepRow(const ResultTable& table, size_t row) : m_table(table), m_row(row) {}

    /// The strategy with the value that the row's sweep gives it.
    [[nodiscard]] StrategyRequest strategy() const {
        StrategyRequest request = strategyFromText(words("strategy").value_or(std::string()));
        if (const std::optional<std::string> key = words("parameter")) request.parameters.setFromText(*key, *words("value"));
        return request;
    }
    [[nodiscard]] std::optional<std::string> words(const char* key) const { return value<std::string>(key); }
    [[nodiscard]] std::optional<double> number(const char* key) const { return value<double>(key); }
    [[nodiscard]] std::optional<uint64_t> count(const char* key) const {
        const std::optional<double> found = number(key);
        return found ? std::optional(uint64_t(*found)) : std::nullopt;
    }
    [[nodiscard]] std::optional<RatioEstimate> estimate(const char* key) const { return value<RatioEstimate>(key); }

private:
    template <typename Value>
    [[nodiscard]] std::optional<Value> value(const char* key) const {
        const CellValue cell = m_table.value(m_row, key);
        const auto* found = std::get_if<Value>(&cell);
        return found != nullptr ? std::optional(*found) : std::nullopt;
    }

    const ResultTable& m_table;
    size_t m_row;
};

Promise promiseOf(const std::optional<std::string>& id) {
    for (const Promise promise : {Promise::Exact, Promise::Conservative})
        if (id == promiseId(promise)) return promise;
    return Promise::Approximate;
}

/// `missed`: all missed pixels, `beyond`: those of them that the raster's snapping does not explain, where it may explain some.
/// `rate`: of `missed`.
void countLoss(ResultRow& row, const std::optional<uint64_t>& missed, const std::optional<uint64_t>& beyond,
               const std::optional<double>& rate) {
    row.missedPixels = beyond ? beyond : missed;
    if (missed && beyond) row.withinSnapping = *missed - *beyond;
    if (!rate) return;
    const double lost = beyond && missed && *missed > 0 ? double(*beyond) / double(*missed) : 1.0;
    row.missedPpm = kMillion * *rate * lost;
}

ResultRow resultRow(const SweepRow& measured, const StrategyRequest& strategy) {
    ResultRow row = emptyRow(strategy, promiseOf(measured.words("promise")));
    row.speedup = measured.estimate("ratio_to_same_sides");
    row.baseline = measured.words("same_sides_baseline").value_or("");
    row.headroomShare = measured.estimate("headroom_share");
    row.speedupOverFrontFaces = measured.estimate("ratio_to_backface");
    row.speedupOverTriangles = measured.estimate("ratio_to_all");
    row.fpsOverall = measured.number("fps_overall");
    row.fpsMin = measured.number("fps_min");
    row.fpsMax = measured.number("fps_max");
    row.cullShare = measured.number("cull_share");
    if (const std::optional<double> culled = measured.number("culled_fraction")) row.submittedShare = 1.0 - *culled;
    countLoss(row, measured.count("missed_pixels"), measured.count("missed_beyond_snapping"),
              measured.number("missed_pixel_rate"));
    if (row.missedPixels != uint64_t{0}) row.worstPose = measured.count("worst_pose");
    return row;
}

QString speed(const std::optional<RatioEstimate>& estimate) {
    if (!estimate) return {};
    if (!estimate->hasInterval) return QStringLiteral("×%1").arg(ratioWithTwoDigits(estimate->ratio));
    return QStringLiteral("×%1 [%2, %3]")
        .arg(ratioWithTwoDigits(estimate->ratio), ratioWithTwoDigits(estimate->ci95[0]), ratioWithTwoDigits(estimate->ci95[1]));
}

QString shareText(const std::optional<RatioEstimate>& share) {
    if (!share) return {};
    const auto whole = [](double value) { return QLocale().toString(100.0 * value, 'f', 0); };
    if (!share->hasInterval) return QStringLiteral("%1 %").arg(whole(share->ratio));
    return QStringLiteral("%1 % [%2, %3]").arg(whole(share->ratio), whole(share->ci95[0]), whole(share->ci95[1]));
}

QString percent(const std::optional<double>& share) { return share ? percentText(*share) + QStringLiteral(" %") : QString(); }

}  // namespace

std::vector<ResultRow> resultRows(const ResultTable& table) {
    std::vector<ResultRow> rows;
    std::set<std::string> known;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const SweepRow measured(table, i);
        const StrategyRequest strategy = measured.strategy();
        const std::string text = strategyText(strategy);
        if (!known.insert(text).second) continue;
        rows.push_back(resultRow(measured, strategy));
        rows.back().promiseBroken = std::ranges::find(table.brokenPromises, text) != table.brokenPromises.end();
    }
    return rows;
}

std::vector<ResultRow> resultRows(const MeasureResult& result) {
    const Experiment experiment = sweepExperiment({});
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, experiment.settings.front(), result);
    return resultRows(table);
}

std::vector<ResultRow> liveRows(const std::vector<LiveFigures>& views) {
    std::vector<ResultRow> rows;
    for (const LiveFigures& view : views) {
        ResultRow row = emptyRow(view.strategy, view.promise);
        row.name = view.view + QStringLiteral(" · ") + row.name;
        const ViewMetrics& figures = view.figures;
        if (figures.state == ViewMetrics::State::Ready && figures.frameMilliseconds > 0.0) {
            row.speedup = figures.speedup;
            row.baseline = figures.baseline;
            row.speedupOverFrontFaces = figures.speedupOverFrontFaces;
            row.fpsOverall = 1000.0 / figures.frameMilliseconds;
            row.cullShare = figures.cullMilliseconds / figures.frameMilliseconds;
            row.submittedShare = figures.submittedShare();
            countLoss(row, figures.accuracy.missedPixels, figures.missedBeyondSnapping, figures.accuracy.missedPixelRate());
            row.promiseBroken = view.promise != Promise::Approximate && figures.lostPixels() > 0;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

void ResultTableModel::setRows(std::vector<ResultRow> rows) {
    // Partial results arrive ten times a second: an update of existing rows keeps the selection and the scroll position.
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    m_rows = std::move(rows);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

QString ResultTableModel::title(int column) {
    switch (column) {
        case Name:
            return tr("Strategy");
        case Speedup:
            return tr("Speed, same\nsides [95 %]");
        case Headroom:
            return tr("Of the headroom\n[95 %]");
        case SpeedupOverTriangles:
            return tr("Speed against\n%1 [95 %]", "a strategy").arg(baselineWord(BaselineRole::Triangles));
        case Fps:
            return tr("fps");
        case FpsRange:
            return tr("fps\nleast – most");
        case CullShare:
            return tr("Culling of\nthe frame");
        case Submitted:
            return tr("Submitted\ntriangles");
        case Missed:
            return tr("Missed\npixels");
        case Snapped:
            return tr("Within\nsnapping");
        case MissedPpm:
            return tr("Missed per\nmillion");
        case Worst:
            return tr("Worst\nview");
        default:
            return {};
    }
}

QString ResultTableModel::explanation(int column) {
    switch (column) {
        case Name:
            return tr("The strategy, and its parameters where they are not at their defaults");
        case Speedup:
            return tr(
                "Total time of the baseline that draws the same sides over the views divided by this strategy's, with its "
                "95 % interval");
        case Headroom:
            return tr(
                "Share of the time saved that any culling could save: what is saved where exactly the visible triangles are "
                "drawn, known "
                "beforehand. Both against the baseline that draws the same sides");
        case SpeedupOverTriangles:
            return tr("Total time of %1 over the views divided by this strategy's, with its 95 % interval", "a strategy")
                .arg(baselineWord(BaselineRole::Triangles));
        case Fps:
            return tr("Views divided by the time of all of them; a frame is cull + draw");
        case FpsRange:
            return tr("In the slowest and in the fastest view");
        case CullShare:
            return tr("Share of the frame's time that goes into deciding what to draw");
        case Submitted:
            return tr("Share of the scene's triangles given to OpenGL, mean over the views");
        case Missed:
            return tr("Pixels of all views in which the truth has a surface and the strategy a farther one or none");
        case Snapped:
            return tr(
                "Pixels that differ only because the raster snaps vertices to 1/256 pixel, which is no loss; counted where the "
                "truth draws other sides than the strategy, or the strategy makes surfaces or the picture itself");
        case MissedPpm:
            return tr("Missed pixels in a million pixels in which the truth has a surface");
        case Worst:
            return tr("The pose with the most missed pixels; double-click to fly there");
        default:
            return {};
    }
}

QString ResultTableModel::rowExplanation(const ResultRow& row, int column) {
    if (column == Name) {
        QString text = QStringLiteral("%1: %2, %3").arg(row.id, promiseWord(row.promise), promiseSentence(row.promise));
        if (row.promiseBroken) text += QLatin1Char('\n') + tr("It lost pixels: the promise is broken.");
        return text;
    }
    if (column == Speedup && row.speedup && !row.baseline.empty()) {
        QString text = explanation(column) + QLatin1Char('\n') +
                       tr("The baseline: %1", "a strategy").arg(QString::fromStdString(row.baseline));
        if (row.speedupOverFrontFaces)
            text += QLatin1Char('\n') + tr("Against %1: %2", "a strategy; a ratio of times")
                                            .arg(baselineWord(BaselineRole::FrontFaces), speed(row.speedupOverFrontFaces));
        return text;
    }
    return explanation(column);
}

QString ResultTableModel::value(const ResultRow& row, int column) {
    switch (column) {
        case Name:
            return row.name;
        case Speedup:
            return speed(row.speedup);
        case Headroom:
            return shareText(row.headroomShare);
        case SpeedupOverTriangles:
            return speed(row.speedupOverTriangles);
        case Fps:
            return row.fpsOverall ? ratioText(*row.fpsOverall) : QString();
        case FpsRange:
            return row.fpsMin && row.fpsMax ? ratioText(*row.fpsMin) + QStringLiteral(" – ") + ratioText(*row.fpsMax) : QString();
        case CullShare:
            return percent(row.cullShare);
        case Submitted:
            return percent(row.submittedShare);
        case Missed:
            return row.missedPixels ? countText(*row.missedPixels) : QString();
        case Snapped:
            return row.withinSnapping ? countText(*row.withinSnapping) : QString();
        case MissedPpm:
            return row.missedPpm ? ppmText(*row.missedPpm) : QString();
        case Worst:
            return row.worstPose ? QString::number(*row.worstPose) : QString();
        default:
            return {};
    }
}

QVariant ResultTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    const ResultRow& row = m_rows[size_t(index.row())];
    switch (role) {
        case Qt::DisplayRole: {
            const QString text = value(row, index.column());
            return text.isEmpty() ? QStringLiteral("–") : text;
        }
        case Qt::ToolTipRole:
            return rowExplanation(row, index.column());
        case Qt::TextAlignmentRole:
            return int((index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        case kPoseRole:
            return row.worstPose ? QVariant(int(*row.worstPose)) : QVariant();
        default:
            return {};
    }
}

QVariant ResultTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) return {};
    if (role == Qt::DisplayRole) return title(section);
    if (role == Qt::ToolTipRole) return explanation(section);
    if (role == Qt::TextAlignmentRole) return int((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    return {};
}

void ResultTableModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

}  // namespace cullscope::ui
