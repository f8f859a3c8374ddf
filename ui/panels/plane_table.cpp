#include "ui/panels/plane_table.h"

#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>

#include "core/frame/cause.h"
#include "ui/look/plane_swatch.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kPlaneRowHeight = 20;
constexpr int kPositionRole = Qt::UserRole;   ///< position of the distance, −1 to 1
constexpr int kBoundRole = Qt::UserRole + 1;  ///< position of −bound

/// The position of a distance, −1 to 1, on a logarithmic scale of multiples of the bound; the largest distance is at 1.
double position(double distance, double bound, double largest) {
    if (!(largest > 0.0)) return 0.0;
    const double unit = bound > 0.0 ? bound : largest;
    return std::copysign(std::log1p(std::abs(distance) / unit) / std::log1p(largest / unit), distance);
}

/// Paints the bar from 0 to the distance, and the line at −bound.
class BarDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const QRectF place = QRectF(option.rect).adjusted(4, 4, -4, -4);
        const auto x = [&](double at) { return place.center().x() + 0.5 * place.width() * at; };
        const double zero = x(0.0), end = x(index.data(kPositionRole).toDouble());
        const QRectF bar(std::min(zero, end), place.top(), std::max(1.0, std::abs(end - zero)), place.height());
        const bool tested = option.state & QStyle::State_Enabled;
        const QColor text = option.palette.color(tested ? QPalette::Active : QPalette::Disabled, QPalette::Text);
        const QColor inside = tested ? option.palette.color(QPalette::Active, QPalette::Highlight) : text;
        painter->save();
        painter->fillRect(bar, end < zero ? QBrush(text, Qt::BDiagPattern) : QBrush(inside));
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
    setIconSize({12, 12});
    setShowGrid(false);
    setSelectionMode(QAbstractItemView::NoSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setMinimumSectionSize(kPlaneRowHeight);
    verticalHeader()->setDefaultSectionSize(kPlaneRowHeight);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(Bar, QHeaderView::Stretch);
    horizontalHeader()->setSectionsClickable(false);
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this](int section, int /*before*/, int width) {
        if (section == Bar) fitBarHeading(width);
    });
    retranslate();
}

std::vector<PlaneTable::Row> PlaneTable::rowsOf(const std::vector<WhyStep>& steps, const std::vector<PlaneDistance>& own) {
    std::vector<Row> rows;
    for (const WhyStep& step : steps) {
        if (!step.plane || !step.distance || step.ofGroup) continue;
        const Row row{{*step.plane, *step.distance, step.bound.value_or(0.0), step.containment}, translated(step.sentence)};
        // Of several bounds that were tested against a plane, such as a sphere and a box, the tightest says where the object
        // lies.
        const auto known = std::ranges::find(rows, *step.plane, [](const Row& other) { return other.test.plane; });
        if (known == rows.end())
            rows.push_back(row);
        else if (row.test.distance + row.test.bound < known->test.distance + known->test.bound)
            *known = row;
    }
    for (const PlaneDistance& one : own) {
        const auto ofPlane = [&](const Row& row) { return row.test.plane == one.plane; };
        if (std::none_of(rows.begin(), rows.end(), ofPlane))
            rows.push_back({one, tr("The strategy did not test this plane for this object; it is worked out here."), false});
    }
    return rows;
}

void PlaneTable::setSteps(const std::vector<WhyStep>& steps, const std::vector<PlaneDistance>& own) {
    m_rows = rowsOf(steps, own);
    double largest = 0.0;
    for (const Row& row : m_rows) largest = std::max(largest, std::abs(row.test.distance));
    setRowCount(int(m_rows.size()));
    for (size_t i = 0; i < m_rows.size(); ++i) fillRow(int(i), m_rows[i], largest);
    fitRows();
}

/// A lecture's letters are higher than a row of the window.
void PlaneTable::fitRows() {
    const int high = std::max(kPlaneRowHeight, fontMetrics().height());
    verticalHeader()->setDefaultSectionSize(high);
    setFixedHeight(horizontalHeader()->sizeHint().height() + rowCount() * high + 2);
}

/// The bars are as wide as the other columns leave them: there is no place for half a heading, and its tip says it too.
void PlaneTable::fitBarHeading(int width) {
    QTableWidgetItem* heading = horizontalHeaderItem(Bar);
    if (!heading) return;
    const QString whole = tr("Outside | inside");
    const int margin = 2 * style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, horizontalHeader());
    const bool fits = horizontalHeader()->fontMetrics().horizontalAdvance(whole) + margin <= width;
    if (const QString text = fits ? whole : QString(); heading->text() != text) heading->setText(text);
}

void PlaneTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitRows();
}

bool PlaneTable::showsUntested() const {
    return std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) { return !row.tested; });
}

void PlaneTable::fillRow(int number, const Row& row, double largest) {
    const QStringList texts{translated(planeName(row.test.plane)), numberText(row.test.distance), numberText(row.test.bound),
                            QString()};
    for (int column = 0; column < ColumnCount; ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setToolTip(row.sentence);
        if (!row.tested) item->setFlags(Qt::NoItemFlags);
        if (column == Plane) item->setIcon(planeIcon(row.test.plane));
        if (column == Distance || column == Bound) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (column == Bar) {
            item->setData(Qt::AccessibleTextRole, row.sentence);
            item->setData(kPositionRole, position(row.test.distance, row.test.bound, largest));
            item->setData(kBoundRole, position(-row.test.bound, row.test.bound, largest));
        }
        setItem(number, column, item);
    }
}

void PlaneTable::retranslate() {
    setHorizontalHeaderLabels({tr("Plane"), tr("Distance"), tr("Bound"), tr("Outside | inside")});
    horizontalHeaderItem(Bar)->setToolTip(
        tr("The distance in multiples of the bound, logarithmically; outside begins at the dashed line."));
    horizontalHeaderItem(Bar)->setData(Qt::AccessibleTextRole, tr("Outside | inside"));
    fitBarHeading(columnWidth(Bar));
    setAccessibleName(tr("Plane tests"));
}

}  // namespace cullscope::ui
