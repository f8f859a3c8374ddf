#include "ui/panels/flow_chart_panel.h"

#include <QEvent>

#include "ui/panels/shown_strategy.h"

namespace cullscope::ui {

namespace {

constexpr QSize kChartFileSize{720, 640};

}  // namespace

FlowChartPanel::FlowChartPanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QScrollArea(parent),
      m_session(session),
      m_reader(reader),
      m_plot(new FlowChartPlot(this)),
      m_pictures(new PictureMenu(session, *m_plot, kChartFileSize)) {
    setWidget(m_plot);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    connect(&reader, &SnapshotReader::changed, this, &FlowChartPanel::refresh);
    followShownStrategy(session, this, [this] { refresh(); });
    connect(&session, &Session::pickChanged, this, &FlowChartPanel::refresh);
    refresh();
}

uint8_t FlowChartPanel::currentLine() const {
    const SnapshotReadingPointer& reading = m_reader.reading();
    if (!m_session.scene() || !reading || !reading->failure.empty() || !reading->listing ||
        reading->strategy->id() != shownStrategy(m_session).id)
        return 0;
    const bool picked = !reading->upTo && reading->pickedListing && reading->triangle == m_reader.pickedTriangle();
    return picked ? reading->pickedListing->current : reading->listing->current;
}

void FlowChartPanel::refresh() {
    const Show* listing = shownStrategy(m_session).first(Show::Kind::Listing);
    m_plot->setEmptySentence(tr("This strategy has no flow chart."));
    m_plot->setChart(listing != nullptr ? listing->chart : FlowChart(), currentLine());
    showLit();
}

void FlowChartPanel::showLit() {
    const QRect lit = m_plot->litPlace();
    if (!lit.isEmpty()) ensureVisible(lit.center().x(), lit.center().y(), 0, viewport()->height() / 2);
}

void FlowChartPanel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    showLit();
}

void FlowChartPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QScrollArea::changeEvent(event);
}

}  // namespace cullscope::ui
