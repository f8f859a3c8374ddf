#include "ui/panels/map_panel.h"

#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "core/visibility/registry.h"
#include "ui/look/wheel_guard.h"
#include "ui/session/object_pick.h"
#include "ui/session/shown_reading.h"
#include "ui/text/terms.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr QSize kMapFileSize{960, 560};
/// The order in which repeated clicks on a cell pick its triangles.
std::vector<uint32_t> pickOrder(const CellMapSource& source, uint32_t cell) {
    const std::span<const uint32_t> owned = source.owned(cell), touching = source.touching(cell);
    std::vector<uint32_t> order(owned.rbegin(), owned.rend());
    for (size_t i = touching.size(); i-- > 0;)
        if (std::find(owned.begin(), owned.end(), touching[i]) == owned.end()) order.push_back(touching[i]);
    return order;
}

}  // namespace

MapPanel::MapPanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reader(reader),
      m_sentence(new QLabel(this)),
      m_choices(new QWidget(this)),
      m_colouringLabel(new QLabel(m_choices)),
      m_colouring(new QComboBox(m_choices)),
      m_map(new MapWidget(this)),
      m_pictures(new PictureMenu(session, *m_map, kMapFileSize)) {
    layOut();
    connect(m_colouring, &QComboBox::activated, this,
            [this] { setColouring(m_colouring->currentData().toString().toStdString()); });
    connect(m_map, &MapWidget::cellChosen, this, &MapPanel::pickIn);
    followReading(session, reader, this, [this] { refresh(); });
    followAbsence(session, this, [this] { showSentence(); });
    connect(&session, &Session::metricsChanged, this, &MapPanel::refresh);
    retranslate();
    refresh();
}

void MapPanel::layOut() {
    m_sentence->setForegroundRole(QPalette::PlaceholderText);
    m_sentence->setWordWrap(true);
    m_colouringLabel->setBuddy(m_colouring);
    leaveWheelUnlessFocused(*m_colouring);
    m_colouring->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_map->setBackgroundRole(QPalette::Base);
    auto* choices = new QHBoxLayout(m_choices);
    choices->setContentsMargins(4, 0, 0, 2);
    choices->addWidget(m_colouringLabel);
    choices->addWidget(m_colouring);
    choices->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_sentence);
    layout->addWidget(m_choices);
    layout->addWidget(m_map);
}

void MapPanel::refresh() {
    const SnapshotReadingPointer reading = shownReading(m_session, m_reader);
    // What a step has in hand is shown with its map: the reading of the step follows.
    if (reading && !m_map->empty() && m_session.stepOf(m_reader.view()) && !m_reader.fresh()) return;
    showMap(reading && reading->map ? ShownMap{m_session.scene(), reading->map} : ShownMap{});
}

void MapPanel::showMap(const ShownMap& shown) {
    m_map->setContents({shown, shown.empty() ? nullptr : truth(), pickedTriangle(shown), partOf(shown), inHand(shown)});
    if (!shown.empty()) offerColourings(*shown.map);
    m_choices->setVisible(!shown.empty() && !m_brief);
    m_map->setVisible(!shown.empty());
    m_sentence->setVisible(shown.empty());
    // The Tab key cannot leave a panel whose focus proxy is hidden.
    setFocusProxy(shown.empty() ? nullptr : m_map);
    showSentence();
    emit shownChanged();
}

void MapPanel::offerColourings(const CellMap& map) {
    for (int i = m_colouring->count(); i-- > 0;)
        if (!map.colouring(m_colouring->itemData(i).toString().toStdString())) m_colouring->removeItem(i);
    for (size_t i = 0; i < map.colourings.size(); ++i) {
        const QString id = QString::fromStdString(map.colourings[i].id);
        if (m_colouring->findData(id) < 0) m_colouring->insertItem(int(i), QString(), id);
        m_colouring->setItemText(m_colouring->findData(id), translated(map.colourings[i].name));
    }
    // What the user chose is given up where the map has it not.
    m_map->setColouring(m_map->colouring());
    m_colouring->setCurrentIndex(m_colouring->findData(QString::fromStdString(m_map->colouring())));
}

void MapPanel::setBrief() {
    m_brief = true;
    m_choices->hide();
    m_map->setBrief();
}

void MapPanel::setColouring(const std::string& id) {
    const int choice = m_colouring->findData(QString::fromStdString(id));
    if (choice >= 0) m_colouring->setCurrentIndex(choice);
    m_map->setColouring(id);
    emit shownChanged();
}

/// Why a settled view has no map: its strategy never has one, or this frame has none, as before the step that makes it.
QString MapPanel::noMapSentence() const {
    if (const Show* own = shownStrategy(m_session).first(Show::Kind::DirectionMap)) {
        const QString map = translated(own->title);
        return m_session.stepOf(m_reader.view()) ? tr("Up to this step there is no %1.").arg(map)
                                                 : tr("This frame has no %1.").arg(map);
    }
    QStringList maps;
    for (const Show* show : declaredShows(Show::Kind::DirectionMap)) maps << translated(show->title);
    return tr("This strategy has no %1.").arg(maps.join(QStringLiteral(", ")));
}

void MapPanel::showSentence() {
    const QString words = absenceWords(absence(m_session, m_reader));
    m_sentence->setText(words.isEmpty() ? noMapSentence() : words);
    m_sentence->setToolTip(tr("Strategies that look up what is visible by direction show their map here."));
}

std::shared_ptr<const TriangleStates> MapPanel::truth() const {
    const ViewMetrics& figures = m_session.figures(m_reader.view());
    const bool known = figures.state == ViewMetrics::State::Ready && figures.states && figures.subject.buffers &&
                       figures.subject.buffers->scenePointer() == m_session.scene();
    return known && m_reader.fresh() && !m_session.stepOf(m_reader.view()) && figures.states->againstTruth ? figures.states
                                                                                                           : nullptr;
}

std::optional<uint32_t> MapPanel::pickedTriangle(const ShownMap& shown) const {
    const ShownStep* step = m_session.stepOf(m_reader.view());
    if (!shown.empty() && step && step->shape.triangle && step->shape.object == shown.map->object)
        return uint32_t(*step->shape.triangle - m_session.scene()->firstTriangle(shown.map->object));
    const std::optional<Pick>& pick = m_session.pick();
    if (shown.empty() || !pick || m_session.objectOf(shown.map->object) != pick->object) return std::nullopt;
    return uint32_t(pick->triangle - m_session.opened()->scene->firstTriangle(pick->object));
}

std::vector<std::vector<Vec2>> MapPanel::inHand(const ShownMap& shown) const {
    const ShownStep* step = m_session.stepOf(m_reader.view());
    const bool has = !shown.empty() && step && step->shape.object == shown.map->object;
    return has ? step->shape.mapLines : std::vector<std::vector<Vec2>>();
}

std::optional<uint32_t> MapPanel::partOf(const ShownMap& shown) const {
    const bool has = m_part && !shown.empty() && *m_part > 0 && *m_part <= shown.map->parts;
    return has ? m_part : std::nullopt;
}

void MapPanel::setPart(const std::optional<uint32_t>& part) {
    m_part = part;
    showMap(ShownMap(m_map->contents().shown));
}

void MapPanel::pickIn(uint32_t cell) {
    const ShownMap& shown = m_map->contents().shown;
    if (shown.empty() || shown.scene != m_session.scene()) return;
    const std::vector<uint32_t> order = pickOrder(shown.source(), cell);
    if (order.empty()) return;
    const std::optional<uint32_t> picked = pickedTriangle(shown);
    const auto before = picked ? std::find(order.begin(), order.end(), *picked) : order.end();
    const bool wraps = before == order.end() || before + 1 == order.end();
    const uint32_t object = m_session.objectOf(shown.map->object);
    m_session.setPick(pickOfTriangle(m_session, object, wraps ? order.front() : *(before + 1)));
}

void MapPanel::retranslate() {
    m_colouringLabel->setText(tr("&Colours of the map:"));
    if (!m_map->empty()) offerColourings(*m_map->contents().shown.map);
    showSentence();
}

void MapPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
