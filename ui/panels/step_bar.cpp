#include "ui/panels/step_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <limits>

#include "core/visibility/registry.h"
#include "ui/look/tinted_icon.h"
#include "ui/look/wheel_guard.h"
#include "ui/text/terms.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kButtonSize = 28;
constexpr int kIconSize = 18;
constexpr std::array kIcons{"step-first", "step-back", "step-play", "step-forward", "step-last"};
enum Button { First, Back, Play, Forward, Last };

}  // namespace

StepBar::StepBar(Session& session, Stepper& stepper, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_stepper(stepper),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_place(new QLabel(this)),
      m_speedName(new QLabel(this)),
      m_speed(new QDoubleSpinBox(this)),
      m_breakpointsButton(new QToolButton(this)),
      m_breakpoints(new QMenu(this)),
      m_close(new QToolButton(this)),
      m_sentence(new QLabel(this)) {
    layOut();
    connect(m_buttons[First], &QToolButton::clicked, this, [this] { m_stepper.jump(0); });
    connect(m_buttons[Back], &QToolButton::clicked, &stepper, &Stepper::back);
    connect(m_buttons[Play], &QToolButton::clicked, this, [this] { m_stepper.play(!m_stepper.playing()); });
    connect(m_buttons[Forward], &QToolButton::clicked, &stepper, &Stepper::forward);
    connect(m_buttons[Last], &QToolButton::clicked, &stepper, &Stepper::toEnd);
    connect(m_slider, &QSlider::valueChanged, this, [this](int step) { m_stepper.jump(size_t(step)); });
    connect(m_speed, &QDoubleSpinBox::valueChanged, &stepper, &Stepper::setSpeed);
    connect(m_close, &QToolButton::clicked, &stepper, &Stepper::stop);
    connect(m_breakpoints, &QMenu::aboutToShow, this, &StepBar::fillBreakpoints);
    connect(&stepper, &Stepper::changed, this, &StepBar::refresh);
    retranslate();
}

void StepBar::layOut() {
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i] = new QToolButton(this);
        m_buttons[i]->setIcon(tintedIcon(QLatin1String(kIcons[i])));
        m_buttons[i]->setIconSize({kIconSize, kIconSize});
        m_buttons[i]->setFixedSize(kButtonSize, kButtonSize);
        m_buttons[i]->setAutoRaise(true);
        row->addWidget(m_buttons[i]);
    }
    m_speed->setRange(0.1, Stepper::kMostSpeed);
    m_speed->setDecimals(1);
    m_speed->setValue(m_stepper.speed());
    m_speed->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    leaveWheelUnlessFocused(*m_speed);
    m_speedName->setBuddy(m_speed);
    m_breakpointsButton->setMenu(m_breakpoints);
    m_breakpointsButton->setPopupMode(QToolButton::InstantPopup);
    m_close->setAutoRaise(true);
    m_close->setText(QStringLiteral("✕"));
    m_close->setFixedSize(kButtonSize, kButtonSize);
    row->addWidget(m_slider, 1);
    row->addWidget(m_place);
    row->addSpacing(8);
    row->addWidget(m_speedName);
    row->addWidget(m_speed);
    row->addWidget(m_breakpointsButton);
    row->addWidget(m_close);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // Two lines, so that the views keep their size from step to step.
    m_sentence->setFixedHeight(2 * lineHeight(m_sentence->fontMetrics()) + 2);
    m_sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(2);
    layout->addLayout(row);
    layout->addWidget(m_sentence);
}

QString StepBar::placeText() const {
    const FrameStepper* place = m_stepper.place();
    if (!place) return {};
    const QString text = tr("%1 of %2", "a step, number of steps").arg(countText(place->step()), countText(place->count()));
    QStringList coarser;
    switch (place->steps().grain()) {
        case StepGrain::Entry:
            break;
        case StepGrain::Subject:
            coarser << tr("by subject");
            break;
        case StepGrain::Object:
            coarser << tr("by object");
            break;
        case StepGrain::Commands:
            coarser << tr("by command");
            break;
        case StepGrain::Share:
            coarser << tr("in equal parts");
    }
    // The tool tip has the others.
    if (!place->log().coarser.empty()) coarser << translated(place->log().coarser.front());
    return coarser.isEmpty() ? text : tr("%1 (%2)", "place, size of the steps").arg(text, coarser.join(QStringLiteral("; ")));
}

QString StepBar::placeTip() const {
    const FrameStepper& place = *m_stepper.place();
    QStringList lines{place.steps().grain() == StepGrain::Entry
                          ? tr("Each step is one decision or command of the frame.")
                          : tr("This frame has %1 decisions and commands: each step takes several of them.")
                                .arg(countText(place.log().entries()))};
    if (!place.log().coarser.empty()) lines << tr("The method itself records this frame coarser:");
    for (const Message& words : place.log().coarser) lines << QStringLiteral("• ") + translated(words);
    return lines.join(QLatin1Char('\n'));
}

void StepBar::refresh() {
    setVisible(m_stepper.active());
    const FrameStepper* place = m_stepper.place();
    for (QWidget* part : std::initializer_list<QWidget*>{m_slider, m_breakpointsButton}) part->setEnabled(place != nullptr);
    for (size_t i = 0; i < m_buttons.size(); ++i)
        m_buttons[i]->setEnabled(place && (i == Play || (i < Play ? place->step() > 0 : place->step() < place->count())));
    const bool playing = m_stepper.playing();
    m_buttons[Play]->setIcon(tintedIcon(playing ? QStringLiteral("step-pause") : QStringLiteral("step-play")));
    m_buttons[Play]->setToolTip(playing ? tr("Pause") : tr("Play from here"));
    m_buttons[Play]->setAccessibleName(m_buttons[Play]->toolTip());
    m_place->setText(placeText());
    m_sentence->setText(!m_stepper.failure().empty() ? translated(m_stepper.failure())
                        : place                      ? m_stepper.sentence()
                                                     : tr("The strategy's decisions are being read…"));
    const size_t breakpoints = m_stepper.breakpoints().size();
    m_breakpointsButton->setText(breakpoints == 0 ? tr("Breakpoints") : tr("Breakpoints: %1").arg(breakpoints));
    if (!place) return;
    m_place->setToolTip(placeTip());
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, int(std::min<size_t>(place->count(), std::numeric_limits<int>::max())));
    m_slider->setPageStep(std::max(1, m_slider->maximum() / 20));
    m_slider->setValue(int(place->step()));
}

void StepBar::fillBreakpoints() {
    m_breakpoints->clear();
    const FrameStepper* place = m_stepper.place();
    if (!place || !m_session.step()) return;
    const Show* listing = m_session.step()->frame->request.strategy->info().first(Show::Kind::Listing);
    const std::vector<ListingLine> lines = listing ? listing->lines : std::vector<ListingLine>();
    EntryKind::Trait trait = EntryKind::Trait::Outcome;
    for (const auto& [kind, count] : countKinds(place->log())) {
        if (std::exchange(trait, kind.trait) != kind.trait) m_breakpoints->addSeparator();
        QAction* action = m_breakpoints->addAction(
            tr("%1 (%2)", "kind of decision, how many").arg(translated(kindWords(kind, lines)), countText(count)));
        action->setCheckable(true);
        action->setChecked(m_stepper.breakpoints().contains(kind));
        connect(action, &QAction::toggled, this, [this, kind = kind](bool on) {
            std::set<EntryKind> kinds = m_stepper.breakpoints();
            on ? void(kinds.insert(kind)) : void(kinds.erase(kind));
            m_stepper.setBreakpoints(kinds);
        });
    }
}

void StepBar::retranslate() {
    const std::array words{tr("To the start (Shift+Page Up)"), tr("One step back (Page Up)"), QString(),
                           tr("One step on (Page Down)"), tr("To the end (Shift+Page Down)")};
    for (size_t i = 0; i < words.size(); ++i) {
        if (i == Play) continue;
        m_buttons[i]->setToolTip(words[i]);
        m_buttons[i]->setAccessibleName(words[i]);
    }
    m_slider->setAccessibleName(tr("Step"));
    m_speedName->setText(tr("Steps a second:"));
    m_breakpointsButton->setToolTip(
        tr("Playing stops at decisions of these kinds; Ctrl+Page Down and Ctrl+Page Up go to the next and the last one"));
    m_close->setToolTip(tr("Show the whole frame again (F8)"));
    m_close->setAccessibleName(m_close->toolTip());
    refresh();
}

void StepBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
