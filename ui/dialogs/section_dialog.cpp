#include "ui/dialogs/section_dialog.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QRadioButton>
#include <QSignalBlocker>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr int kSteps = 1000;  // of the slider
constexpr std::array kSectionAxes{Section::Axis::X, Section::Axis::Y, Section::Axis::Z, Section::Axis::View};

}  // namespace

SectionDialog::SectionDialog(Session& session, QWidget* parent)
    : QDialog(parent, Qt::Tool),
      m_session(session),
      m_cuts(new QCheckBox(this)),
      m_axes(new QButtonGroup(this)),
      m_axisLabel(new QLabel(this)),
      m_placeLabel(new QLabel(this)),
      m_note(new QLabel(this)),
      m_place(new QSlider(Qt::Horizontal, this)),
      m_flipped(new QCheckBox(this)) {
    auto* rows = new QGridLayout(this);
    rows->addWidget(m_cuts, 0, 0, 1, 2);
    auto* axes = new QHBoxLayout;
    for (const Section::Axis axis : kSectionAxes) {
        auto* button = new QRadioButton(this);
        m_axes->addButton(button, int(axis));
        axes->addWidget(button);
    }
    axes->addStretch();
    rows->addWidget(m_axisLabel, 1, 0);
    rows->addLayout(axes, 1, 1);
    m_place->setRange(0, kSteps);
    m_place->setPageStep(kSteps / 20);
    m_place->setMinimumWidth(240);
    m_placeLabel->setBuddy(m_place);
    rows->addWidget(m_placeLabel, 2, 0);
    rows->addWidget(m_place, 2, 1);
    rows->addWidget(m_flipped, 3, 1);
    m_note->setWordWrap(true);
    rows->addWidget(m_note, 4, 0, 1, 2);
    connect(m_cuts, &QCheckBox::toggled, this, &SectionDialog::apply);
    connect(m_axes, &QButtonGroup::idClicked, this, &SectionDialog::apply);
    connect(m_place, &QSlider::valueChanged, this, &SectionDialog::apply);
    connect(m_flipped, &QCheckBox::toggled, this, &SectionDialog::apply);
    connect(&session, &Session::sectionChanged, this, &SectionDialog::follow);
    follow();
    retranslate();
}

void SectionDialog::begin() {
    if (m_session.opened() && !m_session.section()) m_session.setSection(m_last);
    follow();
    show();
    raise();
    activateWindow();
}

void SectionDialog::follow() {
    const std::optional<Section>& section = m_session.section();
    if (section) m_last = *section;
    const std::array<QSignalBlocker, 3> quiet{QSignalBlocker(m_cuts), QSignalBlocker(m_place), QSignalBlocker(m_flipped)};
    m_cuts->setChecked(section.has_value());
    m_axes->button(int(m_last.axis))->setChecked(true);
    m_place->setValue(int(std::lround(m_last.share * kSteps)));
    m_flipped->setChecked(m_last.flipped);
    for (QAbstractButton* button : m_axes->buttons()) button->setEnabled(section.has_value());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_axisLabel, m_placeLabel, m_place, m_flipped})
        widget->setEnabled(section.has_value());
}

void SectionDialog::apply() {
    m_last.axis = Section::Axis(m_axes->checkedId());
    // A share from elsewhere is kept until the slider moves.
    if (m_place->value() != int(std::lround(m_last.share * kSteps))) m_last.share = double(m_place->value()) / kSteps;
    m_last.flipped = m_flipped->isChecked();
    m_session.setSection(m_cuts->isChecked() && m_session.opened() ? std::optional(m_last) : std::nullopt);
    follow();
}

void SectionDialog::retranslate() {
    setWindowTitle(tr("Clipping plane"));
    m_cuts->setText(tr("&Cut the pictures of all views"));
    m_axisLabel->setText(tr("Across"));
    for (const auto& [axis, name] : {std::pair{Section::Axis::X, QStringLiteral("&x")},
                                     {Section::Axis::Y, QStringLiteral("&y")},
                                     {Section::Axis::Z, QStringLiteral("&z")},
                                     {Section::Axis::View, tr("the &view")}})
        m_axes->button(int(axis))->setText(name);
    m_placeLabel->setText(tr("&Place"));
    m_place->setAccessibleName(tr("Place of the clipping plane"));
    m_flipped->setText(tr("Keep the &other side"));
    m_note->setText(tr("Culling and all figures stay those of the whole scene."));
}

void SectionDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QDialog::changeEvent(event);
}

}  // namespace cullscope::ui
