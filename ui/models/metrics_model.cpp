#include "ui/models/metrics_model.h"

#include "core/measure/accuracy.h"
#include "ui/models/metrics_words.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

void MetricsModel::setColumns(std::vector<Column> columns) {
    beginResetModel();
    m_columns = std::move(columns);
    endResetModel();
}

void MetricsModel::setFigures(int view, const ViewMetrics& figures) {
    for (size_t column = 0; column < m_columns.size(); ++column) {
        if (m_columns[column].view != view) continue;
        m_columns[column].figures = figures;
        emit dataChanged(index(0, int(column)), index(RowCount - 1, int(column)), {Qt::DisplayRole});
    }
}

QString MetricsModel::title(int row) {
    switch (row) {
        case Speedup:
            return tr("Speed, same sides drawn");
        case Interval:
            return tr("– 95 % interval");
        case Most:
            return tr("Any culling, at most");
        case Share:
            return tr("Of the headroom");
        case Frame:
            return tr("Frame");
        case Fps:
            return tr("Frames per second");
        case Cull:
            return tr("Culling");
        case Submitted:
            return tr("Submitted triangles");
        case Visible:
            return tr("Visible triangles");
        case InVain:
            return tr("Submitted in vain");
        case Missed:
            return tr("Missed pixels");
        case Snapped:
            return tr("– within snapping");
        case Hole:
            return tr("Largest hole");
        case Covered:
            return tr("Covered pixels");
        default:
            return {};
    }
}

QString MetricsModel::explanation(int row) {
    switch (row) {
        case Speedup:
            return tr(
                "Frame time of the baseline that draws the same sides divided by this strategy's, measured in turns at the same "
                "camera");
        case Interval:
            return tr(
                "95 % interval of the speed, by bootstrap over the repeated frames of this measurement. Another start of the "
                "program can differ by more");
        case Most:
            return tr(
                "Speed of drawing exactly the visible triangles, known beforehand, against drawing all with the same sides: "
                "what any culling could gain here at most");
        case Share:
            return tr(
                "Share of the time saved that any culling could save, each against the baseline that draws the same sides. Below "
                "0: slower than that baseline");
        case Frame:
            return tr(
                "Culling and drawing into the view's own picture until OpenGL has finished; the window itself is not counted");
        case Fps:
            return tr("1 / (cull + draw)");
        case Cull:
            return tr("Time in which the strategy decides what to draw");
        case Submitted:
            return tr("Triangles of the scene of which anything is drawn, each counted once");
        case Visible:
            return tr("Triangles that truly show in at least one pixel");
        case InVain:
            return tr("Submitted triangles that show in no pixel");
        case Missed:
            return tr(
                "Pixels in which the truth has a surface and this picture a farther one or none; without those within snapping");
        case Snapped:
            return tr(
                "Pixels that differ only because the raster snaps vertices to 1/256 pixel, which is no loss; counted where the "
                "truth draws other sides than the strategy, or the strategy makes surfaces or the picture itself");
        case Hole:
            return tr("Pixels of the largest connected group of missed pixels");
        case Covered:
            return tr("Pixels in which the truth has a surface");
        default:
            return {};
    }
}

QString MetricsModel::explanation(const ViewMetrics& figures, int row) {
    const bool ready = figures.state == ViewMetrics::State::Ready;
    if (row == Submitted && ready && figures.submitted.fragments > 0)
        return fragmentsSentence(figures.submitted) + QLatin1Char('\n') + explanation(row);
    if ((row == Most || row == Share) && ready && figures.headroom)
        return headroomSentence(*figures.headroom) + QLatin1Char('\n') + explanation(row);
    if (row != Speedup || !ready || !figures.speedup) return explanation(row);
    return speedSentence(figures) + QLatin1Char('\n') + explanation(row);
}

QString MetricsModel::value(const ViewMetrics& figures, int row) {
    if (figures.state == ViewMetrics::State::Stale) return QStringLiteral("…");
    if (figures.state != ViewMetrics::State::Ready) return QStringLiteral("–");
    const Accuracy& accuracy = figures.accuracy;
    const QString pending = figures.timed ? QStringLiteral("–") : QStringLiteral("…");
    switch (row) {
        case Speedup:
            return figures.speedup ? speedText(*figures.speedup) : pending;
        case Interval:
            if (!figures.speedup) return pending;
            return figures.speedup->hasInterval ? intervalText(*figures.speedup) : QStringLiteral("–");
        case Most:
            // Drawing everything is ×1. Where drawing the visible triangles alone is less, there is nothing to gain.
            if (figures.headroom && figures.headroom->most.ratio < 1.0) return tr("nothing");
            return figures.headroom ? speedText(figures.headroom->most) : pending;
        case Share:
            return figures.headroom && figures.headroom->share ? headroomText({figures.headroom->share->ratio, {}, false})
                                                               : pending;
        case Frame:
            return figures.timed ? millisecondsText(figures.frameMilliseconds) : QStringLiteral("…");
        case Fps:
            return figures.frameMilliseconds > 0.0 ? ratioText(1000.0 / figures.frameMilliseconds) : QStringLiteral("…");
        case Cull:
            return figures.timed ? millisecondsText(figures.cullMilliseconds) : QStringLiteral("…");
        case Submitted:
            return countText(figures.submitted.triangles);
        case Visible:
            return countText(accuracy.visibleTriangles);
        case InVain:
            return countText(accuracy.needlesslyDrawnTriangles);
        case Missed:
            return countText(figures.lostPixels());
        case Snapped:
            return figures.missedBeyondSnapping ? countText(accuracy.missedPixels - figures.lostPixels()) : QStringLiteral("–");
        case Hole:
            return countText(accuracy.largestHolePixels);
        case Covered:
            return countText(accuracy.coveredPixels);
        default:
            return {};
    }
}

QVariant MetricsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    switch (role) {
        case Qt::DisplayRole:
            return value(m_columns[size_t(index.column())].figures, index.row());
        case Qt::ToolTipRole:
            return explanation(m_columns[size_t(index.column())].figures, index.row());
        case Qt::TextAlignmentRole:
            return int(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

QVariant MetricsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (section < 0) return {};
    if (orientation == Qt::Vertical) {
        if (section >= RowCount) return {};
        if (role == Qt::DisplayRole) return title(section);
        if (role == Qt::ToolTipRole) return explanation(section);
        return {};
    }
    if (section >= int(m_columns.size())) return {};
    if (role == Qt::DisplayRole) return viewLetter(m_columns[size_t(section)].view);
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

void MetricsModel::retranslate() {
    emit headerDataChanged(Qt::Vertical, 0, RowCount - 1);
    if (!m_columns.empty()) emit dataChanged(index(0, 0), index(RowCount - 1, int(m_columns.size()) - 1));
}

}  // namespace cullscope::ui
