#include "ui/panels/path_bar.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "ui/look/tinted_icon.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kPathButton = 28;
constexpr int kPathIcon = 18;
constexpr int kPathNameWidth = 140;
constexpr std::array kStepIcons{"step-back", "step-play", "step-forward"};

}  // namespace

PathBar::PathBar(PathDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_desk(desk),
      m_chip(new QLabel(this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_place(new QLabel(this)),
      m_name(new QLineEdit(this)) {
    layOut();
    connect(m_slider, &QSlider::valueChanged, &desk, &PathDesk::go);
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (m_name->isModified()) m_desk.rename(m_name->text());
        m_name->setModified(false);
    });
    connect(&desk, &PathDesk::changed, this, &PathBar::refresh);
    retranslate();
}

void PathBar::layOut() {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    m_chip->setAutoFillBackground(true);
    m_chip->setBackgroundRole(QPalette::ToolTipBase);
    m_chip->setForegroundRole(QPalette::ToolTipText);
    m_chip->setMargin(4);
    row->addWidget(m_chip);
    for (int i = 0; i < ButtonCount; ++i) {
        m_buttons[size_t(i)] = new QToolButton(this);
        m_buttons[size_t(i)]->setAutoRaise(true);
        connect(m_buttons[size_t(i)], &QToolButton::clicked, this, [this, i] { press(Button(i)); });
    }
    for (size_t i = 0; i < kStepIcons.size(); ++i) {
        m_buttons[i]->setIcon(tintedIcon(QLatin1String(kStepIcons[i])));
        m_buttons[i]->setIconSize({kPathIcon, kPathIcon});
        m_buttons[i]->setFixedSize(kPathButton, kPathButton);
        row->addWidget(m_buttons[i]);
    }
    m_buttons[Close]->setText(QStringLiteral("✕"));
    m_buttons[Close]->setFixedSize(kPathButton, kPathButton);
    m_name->setFixedWidth(kPathNameWidth);
    row->addWidget(m_slider, 1);
    row->addWidget(m_place);
    row->addSpacing(8);
    row->addWidget(m_name);
    for (const Button button : {Begin, End, Smooth, Save, Close}) row->addWidget(m_buttons[button]);
}

void PathBar::press(Button button) {
    switch (button) {
        case Back:
            return m_desk.step(-1);
        case Play:
            return m_desk.player().playing() ? m_desk.player().pause() : m_desk.play();
        case Forward:
            return m_desk.step(1);
        case Begin:
            return m_desk.beginHere();
        case End:
            return m_desk.endHere();
        case Smooth:
            return m_desk.smooth();
        case Save:
            emit saveRequested();
            return;
        case Close:
            // The recorded path stays in the bar, for what is done with it.
            return m_desk.recorder().recording() ? m_desk.recorder().stop() : m_desk.stop();
        case ButtonCount:
            return;
    }
}

void PathBar::refresh() {
    const bool recording = m_desk.recorder().recording(), making = !m_desk.making().isEmpty();
    const CameraPlayer& player = m_desk.player();
    setVisible(recording || making || player.active());
    if (recording)
        m_chip->setText(tr("● recording, poses: %1").arg(countText(m_desk.path().poses.size())));
    else if (making)
        m_chip->setText(tr("%1 is being made…", "a camera path").arg(m_desk.making()));
    m_chip->setVisible(recording || making);
    const int poses = int(m_desk.path().poses.size());
    const bool steps = player.active() && !recording && !making;
    for (const Button button : {Back, Play, Forward, Begin, End, Smooth, Save}) m_buttons[button]->setVisible(steps);
    for (QWidget* part : std::initializer_list<QWidget*>{m_slider, m_place, m_name}) part->setVisible(steps);
    m_buttons[Back]->setEnabled(player.pose() > 0);
    m_buttons[Forward]->setEnabled(player.pose() + 1 < poses);
    m_buttons[Begin]->setEnabled(player.pose() > 0);
    m_buttons[End]->setEnabled(player.pose() + 1 < poses);
    m_buttons[Smooth]->setEnabled(poses > 2);
    m_buttons[Play]->setIcon(tintedIcon(player.playing() ? QStringLiteral("step-pause") : QStringLiteral("step-play")));
    m_buttons[Play]->setToolTip(player.playing() ? tr("Pause (Space)") : tr("Play from here (Space)"));
    m_buttons[Play]->setAccessibleName(m_buttons[Play]->toolTip());
    m_buttons[Close]->setToolTip(recording ? tr("End the recording") : making ? tr("Cancel") : tr("Leave the path (Esc)"));
    m_buttons[Close]->setAccessibleName(m_buttons[Close]->toolTip());
    m_place->setText(
        tr("%1 of %2", "a pose, number of poses").arg(countText(uint64_t(player.pose()) + 1), countText(uint64_t(poses))));
    const QString name = QString::fromStdString(m_desk.path().name);
    // A path that lies in a file has the file's whole name.
    if (!m_name->hasFocus()) m_name->setText(QFileInfo(name).isAbsolute() ? QFileInfo(name).completeBaseName() : name);
    m_name->setToolTip(name);
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, std::max(0, poses - 1));
    m_slider->setPageStep(std::max(1, poses / 10));
    m_slider->setValue(player.pose());
}

void PathBar::retranslate() {
    const auto say = [this](Button button, const QString& text, const QString& tip) {
        if (button >= Begin && button <= Save) m_buttons[button]->setText(text);
        m_buttons[button]->setToolTip(tip);
        m_buttons[button]->setAccessibleName(text);
    };
    say(Back, tr("One pose back"), tr("One pose back (Alt+Left)"));
    say(Forward, tr("One pose on"), tr("One pose on (Alt+Right)"));
    say(Begin, tr("Begin here"), tr("Leave out the poses before this one"));
    say(End, tr("End here"), tr("Leave out the poses after this one"));
    say(Smooth, tr("Smooth"), tr("Take the jerks of the hand out: each pose becomes the mean of itself and its neighbours"));
    say(Save, tr("Save…"), tr("Save the path as a file"));
    m_slider->setAccessibleName(tr("Pose"));
    m_name->setAccessibleName(tr("Name of the path"));
    m_name->setPlaceholderText(tr("name of the path"));
    refresh();
}

void PathBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
