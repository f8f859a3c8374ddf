#include "ui/panels/curve_panel.h"

#include <QEvent>
#include <QVBoxLayout>

#include "ui/look/wheel_guard.h"
#include "ui/text/terms.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr QSize kCurveFileSize{960, 420};

}  // namespace

CurvePanel::CurvePanel(Session& session, SnapshotReader& reader, Show show, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reader(reader),
      m_show(std::move(show)),
      m_choices(new QWidget(this)),
      m_name(new QLabel(m_choices)),
      m_part(new QSpinBox(m_choices)),
      m_words(new QLabel(m_choices)),
      m_plot(new CurvePlot(this)),
      m_pictures(new PictureMenu(session, *m_plot, kCurveFileSize)) {
    m_name->setBuddy(m_part);
    m_part->setWrapping(true);
    leaveWheelUnlessFocused(*m_part);
    auto* choices = new QHBoxLayout(m_choices);
    choices->setContentsMargins(8, 4, 8, 0);
    choices->addWidget(m_name);
    choices->addWidget(m_part);
    // All of the rest: a label asks for the width of the letters that it had, and a lecture gives it others.
    choices->addWidget(m_words, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_choices);
    layout->addWidget(m_plot, 1);
    connect(m_part, &QSpinBox::valueChanged, this, &CurvePanel::choose);
    retranslate();
    followReading(session, reader, this, [this] { refresh(); });
    followAbsence(session, this, [this] { showAbsence(); });
    refresh();
}

void CurvePanel::refresh() {
    showAbsence();
    const SnapshotReadingPointer reading = shownReading(m_session, m_reader);
    if (!reading || !reading->frame) return show(nullptr);
    // A step that has its place on the curve shows the whole frame's up to there: the rest of it is decided later.
    const ShownStep* step = m_session.stepOf(m_session.activeView());
    const ViewFramePointer frame = step && step->shape.onCurve ? step->frame : reading->frame;
    show([this, frame, picked = pickedInstance(m_session)](const std::optional<uint32_t>& part) {
        std::optional<Curve> curve = frame->request.strategy->curve(m_show.id, frame->log, picked, part);
        const std::optional<SubjectPlace::OnCurve> place = inHand();
        return curve && place ? curveUpTo(std::move(*curve), place->to) : curve;
    });
}

std::vector<TriangleState> CurvePanel::states() const {
    std::vector<TriangleState> states;
    if (m_plot->empty()) return states;
    for (const CurveArea& area : m_plot->curve()->areas)
        if (!area.boxes.empty()) states.push_back(area.state);
    return states;
}

int CurvePanel::neededHeight(int width) const {
    const int choices = m_choices->isHidden() ? 0 : m_choices->sizeHint().height();
    return choices + (m_plot->empty() ? m_plot->minimumHeight() : m_plot->neededHeight(width));
}

void CurvePanel::show(Curves curves) {
    m_curves = std::move(curves);
    showCurve();
}

void CurvePanel::choose(int part) {
    m_chosen = uint32_t(part);
    showCurve();
}

std::optional<SubjectPlace::OnCurve> CurvePanel::inHand() const {
    const ShownStep* step = m_session.stepOf(m_session.activeView());
    return step ? step->shape.onCurve : std::nullopt;
}

void CurvePanel::showCurve() {
    const std::optional<SubjectPlace::OnCurve> place = inHand();
    std::optional<Curve> curve = m_curves ? m_curves(place ? place->part : m_chosen) : std::nullopt;
    m_plot->setInHand(place && curve && !curve->empty() ? std::optional(Vec2(place->from, place->to)) : std::nullopt);
    // The user's choice is kept while an object without parts is shown, and dropped where there is no such part any more.
    const std::optional<CurveParts> parts = curve && !curve->empty() ? curve->parts : std::nullopt;
    if (parts && m_chosen && *m_chosen > parts->count) m_chosen.reset();
    m_plot->setCurve(std::move(curve));
    if (parts) {
        const QSignalBlocker quiet(m_part);
        m_part->setRange(0, int(parts->count));
        m_part->setValue(int(parts->shown));
    }
    m_choices->setVisible(parts.has_value());
    retranslate();
    emit partChanged();
}

std::optional<uint32_t> CurvePanel::shownPart() const {
    if (m_plot->empty() || !m_plot->curve()->parts || m_plot->curve()->parts->shown == 0) return std::nullopt;
    return m_plot->curve()->parts->shown;
}

void CurvePanel::showAbsence() {
    const SnapshotReadingPointer& reading = m_reader.reading();
    const QString words = absenceWords(absence(m_session, m_reader));
    m_plot->setAbsence(words.isEmpty() && reading ? translated(reading->failure) : words);
}

void CurvePanel::retranslate() {
    m_plot->setName(translated(m_show.title));
    if (!m_plot->curve() || !m_plot->curve()->parts) return;
    const CurveParts& parts = *m_plot->curve()->parts;
    m_name->setText(translated(parts.name));
    m_part->setSpecialValueText(translated(parts.all));
    m_part->setToolTip(translated(parts.help));
    m_words->setText(translated(parts.words));
}

void CurvePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
