#include "ui/panels/plane_table.h"

#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>
#include <cmath>

#include "core/visibility/trace.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kRowHeight = 20;
constexpr int kPositionRole = Qt::UserRole;   ///< of the distance, −1 to 1
constexpr int kBoundRole = Qt::UserRole + 1;  ///< of −bound

/// Where a distance lies on a scale of multiples of the bound on which the largest is at 1.
double position(double distance, double bound, double largest) {
    if (!(largest > 0.0)) return 0.0;
    const double unit = bound > 0.0 ? bound : largest;
    return std::copysign(std::log1p(std::abs(distance) / unit) / std::log1p(largest / unit), distance);
}

/// The bar from 0 to the distance, and the line at −bound.
class BarDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const QRectF place = QRectF(option.rect).adjusted(4, 4, -4, -4);
        const auto x = [&](double at) { return place.center().x() + 0.5 * place.width() * at; };
        const double zero = x(0.0), end = x(index.data(kPositionRole).toDouble());
        const QRectF bar(std::min(zero, end), place.top(), std::max(1.0, std::abs(end - zero)), place.height());
        const QColor text = option.palette.color(QPalette::Text);
        painter->save();
        painter->fillRect(bar, end < zero ? QBrush(text, Qt::BDiagPattern) : QBrush(option.palette.color(QPalette::Highlight)));
        painter->setPen(QPen(option.palette.color(QPalette::PlaceholderText), 1));
        painter->drawLine(QPointF(zero, place.top() - 4), QPointF(zero, place.bottom() + 4));
        painter->setPen(QPen(text, 1, Qt::DashLine));
        const double bound = x(index.data(kBoundRole).toDouble());
        painter->drawLine(QPointF(bound, place.top() - 4), QPointF(bound, place.bottom() + 4));
        painter->restore();
    }
};

QString numberText(double value) { return QLocale().toString(value, 'g', 4); }

}  // namespace

PlaneTable::PlaneTable(QWidget* parent) : QTableWidget(0, ColumnCount, parent) {
    setItemDelegateForColumn(Bar, new BarDelegate(this));
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setSelectionMode(QAbstractItemView::NoSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setMinimumSectionSize(kRowHeight);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(Bar, QHeaderView::Stretch);
    horizontalHeader()->setSectionsClickable(false);
    retranslate();
}

void PlaneTable::setSteps(const std::vector<WhyStep>& steps) {
    double largest = 0.0;
    setRowCount(0);
    for (const WhyStep& step : steps)
        if (step.plane && step.distance) {
            insertRow(rowCount());
            fillRow(rowCount() - 1, step);
            largest = std::max(largest, std::abs(*step.distance));
        }
    int row = 0;
    for (const WhyStep& step : steps)
        if (step.plane && step.distance) {
            const double bound = step.bound.value_or(0.0);
            item(row, Bar)->setData(kPositionRole, position(*step.distance, bound, largest));
            item(row++, Bar)->setData(kBoundRole, position(-bound, bound, largest));
        }
    setFixedHeight(horizontalHeader()->sizeHint().height() + rowCount() * kRowHeight + 2);
}

void PlaneTable::fillRow(int row, const WhyStep& step) {
    const QString sentence = translated(step.sentence);
    const QStringList texts{translated(planeName(*step.plane)), numberText(*step.distance),
                            step.bound ? numberText(*step.bound) : QString(), QString()};
    for (int column = 0; column < ColumnCount; ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setToolTip(sentence);
        if (column == Distance || column == Bound) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (column == Bar) item->setData(Qt::AccessibleTextRole, sentence);
        setItem(row, column, item);
    }
}

void PlaneTable::retranslate() {
    setHorizontalHeaderLabels({tr("Plane"), tr("Distance"), tr("Bound"), tr("Outside | inside")});
    horizontalHeaderItem(Bar)->setToolTip(
        tr("The distance in multiples of the bound, logarithmically; outside begins at the dashed line."));
    setAccessibleName(tr("Plane tests"));
}

}  // namespace cullscope::ui
