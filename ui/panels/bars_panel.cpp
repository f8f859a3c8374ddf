#include "ui/panels/bars_panel.h"

#include <QEvent>

#include "ui/panels/shown_strategy.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr QSize kBarsFileSize{720, 320};

}  // namespace

BarsPanel::BarsPanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QScrollArea(parent),
      m_session(session),
      m_reader(reader),
      m_plot(new BarsPlot(this)),
      m_pictures(new PictureMenu(session, *m_plot, kBarsFileSize)) {
    setWidget(m_plot);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    connect(&reader, &SnapshotReader::changed, this, &BarsPanel::refresh);
    followShownStrategy(session, this, [this] { refresh(); });
    refresh();
}

void BarsPanel::refresh() {
    const SnapshotReadingPointer& reading = m_reader.reading();
    const bool known =
        m_session.scene() && reading && reading->failure.empty() && reading->strategy->id() == shownStrategy(m_session).id;
    m_plot->setEmptySentence(emptySentence());
    m_plot->setBars(known ? reading->bars : std::vector<Bars>());
}

QString BarsPanel::emptySentence() const {
    if (!m_session.scene()) return tr("There is no scene: nothing was counted yet.");
    const SnapshotReadingPointer& reading = m_reader.reading();
    if (reading && !reading->failure.empty()) return translated(reading->failure);
    return tr("The strategy's decisions are being read…");
}

void BarsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QScrollArea::changeEvent(event);
}

}  // namespace cullscope::ui
