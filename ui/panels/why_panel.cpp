#include "ui/panels/why_panel.h"

#include <QEvent>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

QLabel* wrappingLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

void makeBold(QLabel& label) {
    QFont font = label.font();
    font.setBold(true);
    label.setFont(font);
}

}  // namespace

WhyPanel::WhyPanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QScrollArea(parent),
      m_session(session),
      m_reader(reader),
      m_empty(wrappingLabel(this)),
      m_content(new QWidget(this)),
      m_heading(wrappingLabel(m_content)),
      m_swatch(new VerdictSwatch(TriangleState::Visible, m_content)),
      m_state(wrappingLabel(m_content)),
      m_verdict(wrappingLabel(m_content)),
      m_planes(new PlaneTable(m_content)),
      m_untested(wrappingLabel(m_content)),
      m_steps(wrappingLabel(m_content)) {
    layOut();
    connect(&reader, &SnapshotReader::changed, this, &WhyPanel::refresh);
    connect(&session, &Session::pickChanged, this, &WhyPanel::refresh);
    connect(&session, &Session::hiddenChanged, this, &WhyPanel::refresh);
    connect(&session, &Session::metricsChanged, this, &WhyPanel::refresh);
    connect(&session, &Session::activeViewChanged, this, &WhyPanel::showState);
    refresh();
}

void WhyPanel::layOut() {
    makeBold(*m_state);
    auto* state = new QHBoxLayout;
    state->addWidget(m_swatch);
    state->addWidget(m_state, 1);
    auto* content = new QVBoxLayout(m_content);
    content->setContentsMargins(0, 0, 0, 0);
    content->addLayout(state);
    content->addWidget(m_heading);
    content->addWidget(m_verdict);
    content->addWidget(m_planes);
    content->addWidget(m_untested);
    content->addWidget(m_steps);
    auto* all = new QWidget(this);
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_empty);
    layout->addWidget(m_content);
    layout->addStretch(1);
    setWidget(all);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QString WhyPanel::emptySentence() const {
    if (!m_session.pick()) return tr("Click on something in a picture to see why it was drawn or left out.");
    return tr("The picked object is hidden by you. Show it again to see why the strategy draws it or leaves it out.");
}

void WhyPanel::refresh() {
    setAccessibleName(tr("Why the picked triangle was drawn or left out"));
    const std::optional<uint64_t> triangle = m_reader.pickedTriangle();
    m_empty->setText(emptySentence());
    m_empty->setVisible(!triangle);
    m_content->setVisible(triangle.has_value());
    if (!triangle) return;
    m_heading->setText(heading());
    const QStringList sentences = this->sentences();
    const bool known = !sentences.isEmpty();
    m_verdict->setText(known ? sentences.back() : missingSentence());
    showPlanes(known);
    QStringList lines;
    for (const QString& sentence : sentences)
        lines << tr("%1. %2", "number of a step, its sentence").arg(lines.size() + 1).arg(sentence);
    m_steps->setText(lines.join(QLatin1Char('\n')));
    m_content->setEnabled(m_reader.fresh() || !known);
    showState();
}

QString WhyPanel::missingSentence() const {
    const SnapshotReadingPointer& reading = m_reader.reading();
    if (reading && !reading->failure.empty()) return translated(reading->failure);
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    if (figures.state == ViewMetrics::State::Failed) return translated(figures.failure);
    return tr("The strategy's decisions are being read…");
}

void WhyPanel::showPlanes(bool known) {
    const SnapshotReadingPointer& reading = m_reader.reading();
    // Where planes alone decide, those that were not tested are listed, too. Other strategies test other things, or no planes.
    const bool all = known && reading->strategy->info().first(Show::Kind::Planes) != nullptr && !reading->snapshot->nodes.empty();
    m_planes->setSteps(known ? reading->why : std::vector<WhyStep>(), all ? reading->planes : std::vector<PlaneDistance>());
    m_planes->setVisible(m_planes->rowCount() > 0);
    m_untested->setText(tr("In grey: not tested by the strategy for this object alone; worked out here from its own box."));
    m_untested->setVisible(m_planes->showsUntested());
}

void WhyPanel::showState() {
    const std::optional<TriangleState> state = m_reader.pickedState();
    m_swatch->setVisible(state.has_value());
    if (state) m_swatch->setState(*state);
    const QString decided = this->decided();
    m_state->setText(decided.isEmpty() ? stateText()
                     : !state
                         ? tr("%1 %2", "two sentences").arg(stateText(), decided)
                         : tr("%1. %2", "state of a triangle, the sentence that says what decided").arg(stateText(), decided));
}

QString WhyPanel::stateText() const {
    const std::optional<TriangleState> state = m_reader.pickedState();
    if (!state) return tr("Whether it is visible is not known yet.");
    const bool stepped = m_session.stepOf(m_session.activeView()) != nullptr;
    if (withinSnapping()) return tr("Left out, within the raster's snapping");
    const QString words =
        stepped && state == TriangleState::Visible ? tr("drawn, or decided to be drawn") : translated(triangleStateName(*state));
    return words.left(1).toUpper() + words.mid(1);
}

bool WhyPanel::withinSnapping() const {
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    const std::optional<uint64_t> triangle = m_reader.pickedTriangle();
    // A state is known of the whole frame's figures, and of no step.
    if (!triangle || !m_reader.pickedState() || m_session.stepOf(m_session.activeView()) != nullptr) return false;
    return figures.states && std::ranges::binary_search(figures.states->withinSnapping, *triangle);
}

QString WhyPanel::decided() const {
    const SnapshotReadingPointer& reading = m_reader.reading();
    const std::optional<uint64_t> triangle = m_reader.pickedTriangle();
    if (!reading || !triangle || reading->triangle != triangle) return {};
    const WhyStep* step = decidingStep(reading->why);
    return step ? translated(step->sentence) : QString();
}

QString WhyPanel::heading() const {
    const std::optional<Pick>& pick = m_session.pick();
    if (!pick) return {};
    const QString object = QString::fromStdString(m_session.opened()->scene->instances()[pick->object].name);
    const QString named = tr("%1, triangle %2", "name of an object").arg(object, countText(pick->triangle));
    if (!m_session.pointBefore()) return named;
    const Vec3 way = pick->point - *m_session.pointBefore();
    const auto number = [](double value) { return QLocale().toString(value, 'g', 4); };
    return named + QLatin1Char('\n') +
           tr("%1 from the point picked before (x %2, y %3, z %4)", "a length, and its components along the axes")
               .arg(number(glm::length(way)), number(way.x), number(way.y), number(way.z));
}

QString WhyPanel::outcome() const {
    if (m_session.stepOf(m_session.activeView()) != nullptr) return {};
    const std::optional<TriangleState> state = m_reader.pickedState();
    if (state == TriangleState::Visible) return tr("It shows in the picture.");
    if (state == TriangleState::InVain)
        return tr("It was drawn in vain: other triangles lie before all of it, or it covers no pixel's middle.");
    if (withinSnapping())
        return tr(
            "The truth shows it where the raster's rounding of corners to 1/256 pixel explains the difference: no pixel is "
            "lost.");
    if (state == TriangleState::WronglyCulled) return tr("It was wrongly left out: the truth shows it.");
    return {};
}

QStringList WhyPanel::sentences() const {
    const SnapshotReadingPointer& reading = m_reader.reading();
    const std::optional<uint64_t> triangle = m_reader.pickedTriangle();
    QStringList sentences;
    if (!reading || !triangle || reading->triangle != triangle) return sentences;
    for (const WhyStep& step : reading->why) sentences << translated(step.sentence);
    if (const QString outcome = this->outcome(); !outcome.isEmpty()) sentences << outcome;
    return sentences;
}

void WhyPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_planes->retranslate();
        refresh();
    }
    QScrollArea::changeEvent(event);
}

}  // namespace cullscope::ui
