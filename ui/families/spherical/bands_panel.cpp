#include "ui/families/spherical/bands_panel.h"

#include <QEvent>
#include <QVBoxLayout>
#include <numbers>

#include "ui/families/spherical/map_words.h"
#include "ui/look/wheel_guard.h"

namespace cullscope::ui {

namespace {

constexpr QSize kFileSize{960, 420};

}  // namespace

BandsPanel::BandsPanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reader(reader),
      m_choices(new QWidget(this)),
      m_sectorLabel(new QLabel(m_choices)),
      m_sector(new QSpinBox(m_choices)),
      m_angles(new QLabel(m_choices)),
      m_plot(new BandsPlot(this)),
      m_pictures(new PictureMenu(session, *m_plot, kFileSize)) {
    m_sectorLabel->setBuddy(m_sector);
    m_sector->setWrapping(true);
    leaveWheelUnlessFocused(*m_sector);
    auto* choices = new QHBoxLayout(m_choices);
    choices->setContentsMargins(8, 4, 8, 0);
    choices->addWidget(m_sectorLabel);
    choices->addWidget(m_sector);
    choices->addWidget(m_angles);
    choices->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_choices);
    layout->addWidget(m_plot, 1);
    connect(m_sector, &QSpinBox::valueChanged, this, &BandsPanel::chooseSector);
    followShownMap(session, reader, this, [this] { refresh(); });
    followMapAbsence(session, this, [this] { m_plot->setAbsence(mapAbsence(m_session, m_reader)); });
    retranslate();
    refresh();
}

void BandsPanel::refresh() {
    m_plot->setAbsence(mapAbsence(m_session, m_reader));
    showMap(shownMap(m_session, m_reader));
}

void BandsPanel::showMap(const ShownMap& shown) {
    m_plot->setShown(shown);
    const uint32_t sectors = m_plot->empty() ? 0 : shown.decision().bands->sectors;
    m_sectorWidth = sectors > 0 ? 2.0 * std::numbers::pi / sectors : 0.0;
    // Keeps the user's choice while an object without bands is shown.
    if (sectors > 0) {
        const QSignalBlocker quiet(m_sector);
        m_chosen = m_chosen && uint32_t(m_sector->value()) <= sectors;
        m_sector->setRange(0, int(sectors));
        if (!m_chosen) m_sector->setValue(int(farthestCutSector(*shown.decision().bands)) + 1);
    }
    m_choices->setVisible(sectors > 0);
    takeSector();
}

void BandsPanel::chooseSector() {
    m_chosen = true;
    takeSector();
}

void BandsPanel::takeSector() {
    const int value = m_sector->value();
    m_plot->setSector(value > 0 ? std::optional(uint32_t(value - 1)) : std::nullopt);
    showAngles();
    emit sectorChanged();
}

void BandsPanel::showAngles() {
    const int value = m_sector->value();
    m_angles->setText(value > 0 ? tr("β %1 to %2", "angles about the axis")
                                      .arg(degreesText((value - 1) * m_sectorWidth), degreesText(value * m_sectorWidth))
                                : QString());
}

void BandsPanel::retranslate() {
    m_sectorLabel->setText(tr("Se&ctor:"));
    m_sector->setSpecialValueText(tr("all"));
    m_sector->setToolTip(
        tr("Sectors divide the bands by the angle β about the axis to the eye; each one is tested by itself. Until you choose "
           "one, it is the one that is drawn farthest."));
    showAngles();
}

void BandsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
