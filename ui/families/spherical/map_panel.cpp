#include "ui/families/spherical/map_panel.h"

#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/families/spherical/map_words.h"
#include "ui/look/wheel_guard.h"
#include "ui/session/object_pick.h"

namespace cullscope::ui {

namespace {

constexpr QSize kFileSize{960, 560};
constexpr std::array kColourings{spherical::MapColouring::Entries, spherical::MapColouring::Radius,
                                 spherical::MapColouring::State, spherical::MapColouring::Level, spherical::MapColouring::Kernel};
/// The number of colourings that every map has; they come first in kColourings.
constexpr size_t kUsualColourings = 3;

/// The order in which repeated clicks on a cell pick its triangles.
std::vector<uint32_t> pickOrder(const SphericalMaps& maps, uint32_t cell) {
    const std::span<const uint32_t> owned = maps.centroids(cell), touching = maps.triangles(cell);
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
      m_pictures(new PictureMenu(session, *m_map, kFileSize)) {
    layOut();
    connect(m_colouring, &QComboBox::activated, this,
            [this] { m_map->setColouring(spherical::MapColouring(m_colouring->currentData().toInt())); });
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
    for (size_t i = 0; i < kUsualColourings; ++i) m_colouring->addItem(QString(), int(kColourings[i]));
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
    // The last map stays until a newer one was read, which avoids flicker.
    showMap(shownMap(m_session, m_reader));
}

void MapPanel::showMap(const ShownMap& shown) {
    if (!shown.empty()) offerColourings(shown);
    m_map->setContents({shown, shown.empty() ? nullptr : truth(), pickedTriangle(shown), sectorOf(shown)});
    m_choices->setVisible(!shown.empty());
    m_map->setVisible(!shown.empty());
    m_sentence->setVisible(shown.empty());
    // The Tab key cannot leave a panel whose focus proxy is hidden.
    setFocusProxy(shown.empty() ? nullptr : m_map);
    showSentence();
}

void MapPanel::offerColourings(const ShownMap& shown) {
    for (const spherical::MapColouring colouring : kColourings) {
        const int index = m_colouring->findData(int(colouring));
        const bool has = hasColouring(shown.map(), colouring);
        if (has && index < 0) m_colouring->addItem(colouringWords(colouring), int(colouring));
        if (!has && index >= 0) m_colouring->removeItem(index);
    }
    if (!hasColouring(shown.map(), m_map->colouring())) m_map->setColouring(spherical::MapColouring::Entries);
    m_colouring->setCurrentIndex(m_colouring->findData(int(m_map->colouring())));
}

void MapPanel::showSentence() {
    const QString words = absenceWords(absence(m_session, m_reader));
    m_sentence->setText(words.isEmpty() ? tr("This strategy has no index map.") : words);
    m_sentence->setToolTip(tr("Strategies that look up what is visible by direction show their map here."));
}

std::shared_ptr<const TriangleStates> MapPanel::truth() const {
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    const bool known = figures.state == ViewMetrics::State::Ready && figures.states && figures.subject.buffers &&
                       figures.subject.buffers->scenePointer() == m_session.scene();
    return known && m_reader.fresh() && figures.states->againstTruth ? figures.states : nullptr;
}

std::optional<uint32_t> MapPanel::pickedTriangle(const ShownMap& shown) const {
    const std::optional<Pick>& pick = m_session.pick();
    if (shown.empty() || !pick || m_session.objectOf(shown.decision().instance) != pick->object) return std::nullopt;
    return uint32_t(pick->triangle - m_session.opened()->scene->firstTriangle(pick->object));
}

std::optional<uint32_t> MapPanel::sectorOf(const ShownMap& shown) const {
    const bool has = m_sector && !shown.empty() && shown.decision().bands && *m_sector < shown.decision().bands->sectors;
    return has ? m_sector : std::nullopt;
}

void MapPanel::setSector(const std::optional<uint32_t>& sector) {
    m_sector = sector;
    showMap(ShownMap(m_map->contents().shown));
}

void MapPanel::pickIn(uint32_t cell) {
    const ShownMap& shown = m_map->contents().shown;
    if (shown.empty() || shown.scene != m_session.scene()) return;
    const std::vector<uint32_t> order = pickOrder(shown.maps(), cell);
    if (order.empty()) return;
    const std::optional<uint32_t> picked = pickedTriangle(shown);
    const auto before = picked ? std::find(order.begin(), order.end(), *picked) : order.end();
    const bool wraps = before == order.end() || before + 1 == order.end();
    const uint32_t object = m_session.objectOf(shown.decision().instance);
    m_session.setPick(pickOfTriangle(m_session, object, wraps ? order.front() : *(before + 1)));
}

void MapPanel::retranslate() {
    m_colouringLabel->setText(tr("&Colours of the map:"));
    for (int i = 0; i < m_colouring->count(); ++i)
        m_colouring->setItemText(i, colouringWords(spherical::MapColouring(m_colouring->itemData(i).toInt())));
    showSentence();
}

void MapPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
