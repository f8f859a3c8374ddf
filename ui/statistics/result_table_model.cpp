#include "ui/statistics/result_table_model.h"

#include <QLocale>
#include <algorithm>
#include <array>

#include "core/experiments/trade_plot.h"
#include "core/measure/field_figures.h"
#include "ui/statistics/run_figures.h"
#include "ui/text/terms.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// Of the columns from FirstFigure on.
const std::vector<const TradeFigure*>& shownFigures() {
    static const std::vector<const TradeFigure*> kShown = [] {
        std::vector<const TradeFigure*> shown;
        for (const FieldFigure& figure : fieldFigures())
            if (std::string_view(figure.key) != kUsualUp) shown.push_back(&tradeFigure(figure.key));
        return shown;
    }();
    return kShown;
}

/// None of a column before those of the figures.
const TradeFigure* figureOf(int column) {
    const int number = column - ResultTableModel::FirstFigure;
    return number >= 0 && size_t(number) < shownFigures().size() ? shownFigures()[size_t(number)] : nullptr;
}

QString speed(const std::optional<RatioEstimate>& estimate) {
    if (!estimate) return {};
    if (!estimate->hasInterval) return QStringLiteral("×%1").arg(ratioWithTwoDigits(estimate->ratio));
    return QStringLiteral("×%1 [%2, %3]")
        .arg(ratioWithTwoDigits(estimate->ratio), ratioWithTwoDigits(estimate->ci95[0]), ratioWithTwoDigits(estimate->ci95[1]));
}

/// "0.31 [0.2, 0.4]", in the figure's unit.
QString figureText(const ResultRow& row, const TradeFigure& figure) {
    const auto found = row.figures.find(figure.key);
    if (found == row.figures.end()) return {};
    const auto words = [&](double value) { return significantText(figure.scale * value); };
    const RatioEstimate& estimate = found->second;
    if (!estimate.hasInterval) return words(estimate.ratio);
    return QStringLiteral("%1 [%2, %3]").arg(words(estimate.ratio), words(estimate.ci95[0]), words(estimate.ci95[1]));
}

/// With a capital, and broken at the space nearest to its middle, as far as it has one.
QString asHeader(QString title) {
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    qsizetype best = -1;
    for (qsizetype i = 0; i < title.size(); ++i)
        if (title[i].isSpace() && (best < 0 || std::abs(2 * i - title.size()) < std::abs(2 * best - title.size()))) best = i;
    if (best >= 0) title[best] = QLatin1Char('\n');
    return title;
}

QString percent(const std::optional<double>& share) { return share ? percentText(*share) + QStringLiteral(" %") : QString(); }

}  // namespace

void ResultTableModel::setRows(std::vector<ResultRow> rows) {
    // Partial results arrive ten times a second: an update of existing rows keeps the selection and the scroll position.
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    m_rows = std::move(rows);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columns() - 1));
}

int ResultTableModel::columns() { return FirstFigure + int(shownFigures().size()); }

QString ResultTableModel::id(int column) {
    static constexpr std::array<const char*, FirstFigure> kIds{"strategy", "speed",     "headroom",   "speed-against-all",
                                                               "fps",      "fps-range", "cull-share", "submitted",
                                                               "missed",   "snapped",   "missed-ppm", "worst-view"};
    if (const TradeFigure* const figure = figureOf(column)) return QString::fromStdString(figure->key);
    return QString::fromLatin1(kIds[size_t(column)]);
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
            const TradeFigure* const figure = figureOf(column);
            return figure != nullptr ? asHeader(translated(figure->title)) : QString();
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
            const TradeFigure* const figure = figureOf(column);
            return figure != nullptr ? translated(figure->meaning) : QString();
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

QString ResultTableModel::missedRateText(const ResultRow& row) {
    if (!row.missedPpm) return {};
    if (*row.missedPpm > 0.0 || row.views == 0) return significantText(*row.missedPpm);
    return translated(noLossIn(row.views));
}

QString ResultTableModel::value(const ResultRow& row, int column) {
    switch (column) {
        case Name:
            return row.name;
        case Speedup:
            return speed(row.speedup);
        case Headroom:
            return row.headroomShare ? headroomText(*row.headroomShare) : QString();
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
            return missedRateText(row);
        case Worst:
            return row.worstPose ? QString::number(*row.worstPose) : QString();
        default:
            const TradeFigure* const figure = figureOf(column);
            return figure != nullptr ? figureText(row, *figure) : QString();
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
    if (orientation != Qt::Horizontal || section < 0 || section >= columns()) return {};
    if (role == Qt::DisplayRole) return title(section);
    if (role == Qt::ToolTipRole) return explanation(section);
    if (role == Qt::TextAlignmentRole) return int((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    return {};
}

void ResultTableModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columns() - 1);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columns() - 1));
}

}  // namespace cullscope::ui
