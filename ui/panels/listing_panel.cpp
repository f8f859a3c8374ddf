#include "ui/panels/listing_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QPaintEvent>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/panels/shown_strategy.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

ListingView::ListingView(ListingModel& model, QWidget* parent) : QTableView(parent), m_model(model) {
    setModel(&model);
    connect(&model, &ListingModel::dataChanged, this, &ListingView::showCurrent);
}

int ListingView::wholeHeight() const {
    const int lines = verticalHeader()->length() + 2 * frameWidth();
    return lines + (horizontalHeader()->isHidden() ? 0 : horizontalHeader()->sizeHint().height());
}

void ListingView::showCurrent() {
    if (m_model.currentRow() < 0) return;
    const QModelIndex current = m_model.index(m_model.currentRow(), ListingModel::Mark);
    scrollTo(current, PositionAtCenter);
    if (!m_follows || !isVisible()) return;
    // In a low window the lines reach below what its panels' place shows.
    const QRect line = visualRect(current);
    for (QWidget* place = parentWidget(); place != nullptr; place = place->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(place); area != nullptr && area->widget()->isAncestorOf(this))
            area->ensureVisible(0, viewport()->mapTo(area->widget(), line.center()).y(), 0, line.height());
}

void ListingView::showCurrentLater() { QMetaObject::invokeMethod(this, &ListingView::showCurrent, Qt::QueuedConnection); }

void ListingView::follow(bool follows) {
    if (follows && !std::exchange(m_follows, follows)) showCurrentLater();
    m_follows = follows;
}

void ListingView::showEvent(QShowEvent* event) {
    QTableView::showEvent(event);
    showCurrentLater();
}

QRect ListingView::wholeLines() const {
    const int high = viewport()->height();
    int begin = high, end = 0;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const int top = rowViewportPosition(row), below = top + rowHeight(row);
        if (top >= 0) begin = std::min(begin, top);
        if (below <= high) end = std::max(end, below);
    }
    return {0, begin, viewport()->width(), std::max(0, end - begin)};
}

void ListingView::paintEvent(QPaintEvent* event) {
    QPaintEvent whole(event->region() & wholeLines());
    QTableView::paintEvent(&whole);
}

void ListingView::updateGeometries() {
    QTableView::updateGeometries();
    // Lines of another font are higher. Queued: to scroll may lay the lines out.
    const QSize laidOut(verticalHeader()->length(), viewport()->height());
    if (laidOut == std::exchange(m_laidOut, laidOut)) return;
    showCurrentLater();
}

ListingPanel::ListingPanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reader(reader),
      m_model(new ListingModel(this)),
      m_summary(new QLabel(this)),
      m_view(new ListingView(*m_model, this)) {
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setMargin(8);
    setUpView();
    setFocusProxy(m_view);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_summary);
    layout->addWidget(m_view, 1);
    connect(&reader, &SnapshotReader::changed, this, &ListingPanel::refresh);
    followShownStrategy(session, this, [this] { refresh(); });
    connect(&session, &Session::pickChanged, this, &ListingPanel::refresh);
    connect(&session, &Session::hiddenChanged, this, &ListingPanel::refresh);
    refresh();
}

void ListingPanel::setUpView() {
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setShowGrid(false);
    m_view->setSelectionMode(QAbstractItemView::NoSelection);
    m_view->setTabKeyNavigation(false);
    m_view->setWordWrap(true);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setMinimumSectionSize(0);
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    QHeaderView* header = m_view->horizontalHeader();
    header->setSectionsClickable(false);
    header->setHighlightSections(false);
    header->setMinimumSectionSize(0);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(ListingModel::Text, QHeaderView::Stretch);
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

SnapshotReadingPointer ListingPanel::reading() const {
    const SnapshotReadingPointer& reading = m_reader.reading();
    const bool known = reading && reading->failure.empty() && reading->listing && m_show != nullptr &&
                       reading->strategy->id() == shownStrategy(m_session).id;
    return known ? reading : nullptr;
}

QString ListingPanel::summary() const {
    if (!m_session.scene()) return tr("There is no scene: nothing was decided yet.");
    if (const SnapshotReadingPointer& newest = m_reader.reading(); newest && !newest->failure.empty())
        return translated(newest->failure);
    const SnapshotReadingPointer reading = this->reading();
    if (!reading) return tr("The strategy's decisions are being read…");
    const std::optional<uint64_t> triangle = m_reader.pickedTriangle();
    if (reading->upTo && reading->listing->current == 0) return tr("No decision has fallen yet. Step on with Page Down.");
    if (reading->upTo)
        return tr("Decisions up to this step that fell at these lines: %1. The last one fell at line %2.")
            .arg(countText(reading->listing->total()))
            .arg(reading->listing->current);
    if (!triangle || reading->triangle != triangle || !reading->pickedListing)
        return tr("Decisions of this frame that fell at these lines: %1.").arg(countText(reading->listing->total()));
    const QString object = QString::fromStdString(m_session.opened()->scene->instances()[m_session.pick()->object].name);
    const QString number = countText(m_session.pick()->triangle);
    if (reading->pickedListing->current == 0)
        return tr("%1, triangle %2: no decision about it fell at a line.", "name of an object").arg(object, number);
    return tr("%1, triangle %2: what became of it was decided at line %3.", "name of an object")
        .arg(object, number)
        .arg(reading->pickedListing->current);
}

void ListingPanel::refresh() {
    const Show* show = shownStrategy(m_session).first(Show::Kind::Listing);
    if (show != std::exchange(m_show, show)) m_model->setLines(show == nullptr ? std::vector<ListingLine>() : show->lines);
    const SnapshotReadingPointer reading = this->reading();
    const bool picked = reading && !reading->upTo && reading->pickedListing && reading->triangle == m_reader.pickedTriangle();
    m_model->setState(reading ? reading->listing : std::nullopt, !reading        ? std::nullopt
                                                                 : picked        ? reading->pickedListing
                                                                 : reading->upTo ? reading->listing
                                                                                 : std::nullopt);
    m_summary->setText(summary());
    m_view->follow(reading && reading->upTo);
    m_view->setAccessibleName(tr("Lines of the strategy"));
    m_view->setAccessibleDescription(m_summary->text());
}

void ListingPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
