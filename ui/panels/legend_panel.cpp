#include "ui/panels/legend_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>
#include <set>

#include "ui/look/meaning_colour.h"
#include "ui/look/promise_marker.h"
#include "ui/look/verdict_swatch.h"
#include "ui/models/metrics_words.h"
#include "ui/panels/shown_strategy.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kMovesUntilLook = 10;
constexpr int kStateRows = 4;
constexpr std::array kPromises{Promise::Exact, Promise::Conservative, Promise::Approximate};

/// The marker shape of a promise, as in the view headers.
class Marker : public QWidget {
public:
    Marker(Promise promise, QWidget* parent) : QWidget(parent), m_promise(promise) { setFixedSize(14, 14); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        drawPromiseMarker(painter, QRectF(1.5, 1.5, 11, 11), m_promise, palette().color(QPalette::WindowText));
    }

private:
    Promise m_promise;
};

/// The frame of a box in the colour that lines of a show have in pictures.
class MeaningSwatch : public QWidget {
public:
    MeaningSwatch(ShowMeaning meaning, QWidget* parent) : QWidget(parent), m_meaning(std::move(meaning)) { setFixedSize(14, 14); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(QPen(meaningColour(m_meaning, palette()), 2.0));
        painter.drawRect(QRectF(2, 2, 10, 10));
    }

private:
    ShowMeaning m_meaning;
};

/// A count of at most four digits, which keeps the column narrow.
QString shortCount(uint64_t count) {
    if (count < 10'000) return countText(count);
    const bool millions = count >= 1'000'000;
    const double value = double(count) / (millions ? 1e6 : 1e3);
    return QLocale().toString(value, 'f', value < 10.0 ? 1 : 0) + (millions ? QStringLiteral(" M") : QStringLiteral(" k"));
}

}  // namespace

LegendPanel::LegendPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_figures(new QLabel(this)),
      m_planes(new PlaneLegend(this)),
      m_next(new QLabel(this)) {
    m_heading = new QLabel(this);
    m_states = makeStates();
    m_next->setTextFormat(Qt::RichText);  // sentences of this panel alone, one with a link
    m_next->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_next, &QLabel::linkActivated, this, [this] {
        advance(Progress::Turn);
        emit lessonRequested();
    });
    m_figures->setWordWrap(true);
    m_next->setWordWrap(true);
    m_next->setMargin(6);
    m_next->setAutoFillBackground(true);
    m_next->setBackgroundRole(QPalette::ToolTipBase);
    m_next->setForegroundRole(QPalette::ToolTipText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 2, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(m_heading);
    layout->addWidget(m_states);
    layout->addWidget(makeMeanings());
    layout->addWidget(m_planes);
    layout->addWidget(makePromises());
    layout->addWidget(m_figures);
    layout->addWidget(m_next);
    layout->addStretch();
    wire();
    refresh();
}

QWidget* LegendPanel::makeStates() {
    auto* states = new QWidget(this);
    m_grid = new QGridLayout(states);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(6);
    m_grid->setVerticalSpacing(2);
    for (size_t state = 0; state < kTriangleStateCount; ++state) {
        m_swatches[state] = new VerdictSwatch(TriangleState(state), states);
        m_words[state] = new QLabel(states);
        m_counts[state] = new QLabel(states);
        m_counts[state]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    placeStates(kStateRows);
    m_grid->setColumnMinimumWidth(3, 6);
    m_grid->setColumnStretch(1, 1);
    m_grid->setColumnStretch(5, 1);
    return states;
}

void LegendPanel::placeStates(int rows) {
    for (int state = 0; state < int(kTriangleStateCount); ++state) {
        const int row = state % rows;
        const int column = 4 * (state / rows);
        m_grid->addWidget(m_swatches[size_t(state)], row, column);
        m_grid->addWidget(m_words[size_t(state)], row, column + 1);
        m_grid->addWidget(m_counts[size_t(state)], row, column + 2);
    }
}

QWidget* LegendPanel::makeMeanings() {
    m_meanings = new QWidget(this);
    auto* rows = new QVBoxLayout(m_meanings);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    m_meanings->hide();
    return m_meanings;
}

void LegendPanel::showMeanings() {
    const std::vector<ShowMeaning> meanings =
        m_session.opened() ? meaningsIn(m_session, m_session.shownViews()) : std::vector<ShowMeaning>();
    // Every picture asks: the rows change with their words alone.
    QStringList words;
    for (const ShowMeaning& meaning : meanings) words << translated(meaning.words);
    if (words == m_meaningWords) return;
    m_meaningWords = words;
    for (QWidget* former : m_meanings->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) delete former;
    for (const ShowMeaning& meaning : meanings) {
        auto* row = new QWidget(m_meanings);
        auto* cells = new QHBoxLayout(row);
        cells->setContentsMargins(0, 0, 0, 0);
        cells->setSpacing(6);
        cells->addWidget(new MeaningSwatch(meaning, row));
        cells->addWidget(new QLabel(translated(meaning.words), row), 1);
        m_meanings->layout()->addWidget(row);
    }
    m_meanings->setVisible(!meanings.empty());
}

QWidget* LegendPanel::makePromises() {
    auto* promises = new QWidget(this);
    auto* row = new QHBoxLayout(promises);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (const Promise promise : kPromises) {
        auto* label = new QLabel(promises);
        row->addWidget(new Marker(promise, promises));
        row->addWidget(label);
        row->addSpacing(10);
        m_promises << label;
    }
    row->addStretch();
    return promises;
}

void LegendPanel::wire() {
    for (const auto signal : {&Session::sceneChanged, &Session::viewCountChanged, &Session::activeViewChanged})
        connect(&m_session, signal, this, &LegendPanel::refresh);
    connect(&m_session, &Session::setupChanged, this, &LegendPanel::refresh);
    connect(&m_session, &Session::cameraChanged, this, [this] {
        // A single object is drawn or culled as a whole: zooming in on it does not demonstrate culling.
        const bool oneObject = m_session.opened() && m_session.opened()->scene->instances().size() < 2;
        if (++m_cameraMoves == kMovesUntilLook) advance(oneObject ? Progress::Pick : Progress::Look);
    });
    connect(&m_session, &Session::metricsChanged, this, [this](int view) {
        showCounts();
        const ViewMetrics& figures = m_session.figures(view);
        const bool culled = figures.state == ViewMetrics::State::Ready && figures.submitted.triangles < figures.sceneTriangles;
        if (culled && m_progress == Progress::Look) advance(Progress::Pick);
    });
    // strategyBuilt too: a refused strategy has no picture, so pictureChanged is not emitted.
    connect(&m_session, &Session::strategyBuilt, this, &LegendPanel::showCounts);
    for (const auto signal : {&Session::pictureChanged, &Session::strategyBuilt}) {
        connect(&m_session, signal, this, &LegendPanel::showPlanes);
        connect(&m_session, signal, this, &LegendPanel::showMeanings);
        connect(&m_session, signal, this, &LegendPanel::showUndecided);
    }
    // The lecture's window keeps its legend while a question is open, and counts would answer it.
    connect(&m_session, &Session::questionChanged, this, &LegendPanel::showCounts);
    connect(&m_session, &Session::pickChanged, this, [this] {
        if (m_session.pick()) advance(Progress::Choose);
    });
    connect(&m_session, &Session::strategyChosen, this, [this] { advance(Progress::Done); });
}

void LegendPanel::advance(Progress to) {
    if (to <= m_progress) return;
    m_progress = to;
    refresh();
}

void LegendPanel::startAnew() {
    m_progress = Progress::Lesson;
    m_cameraMoves = 0;
    refresh();
}

QString LegendPanel::turnAction() const {
    for (const int view : m_session.shownViews())
        if (const int observed = m_session.culledBy(view); observed != view && m_session.shown(observed))
            return tr("Next: drag in view %1 and watch in view %2 what is left out.").arg(viewLetter(observed), viewLetter(view));
    return tr("Next: drag in a picture to turn the scene.");
}

QString LegendPanel::nextAction() const {
    if (!m_session.opened()) return tr("Next: open a mesh file, or generate a scene.");
    switch (m_progress) {
        case Progress::Lesson:
            return tr("Next: begin with %1lesson 1%2, or drag in a picture to turn the scene.", "a link in the text")
                .arg(QStringLiteral("<a href=\"lesson\">"), QStringLiteral("</a>"));
        case Progress::Turn:
            return turnAction();
        case Progress::Look:
            return tr("Next: turn the wheel over the scene to zoom in until part of it lies outside the picture.");
        case Progress::Pick:
            return tr("Next: click on something in a picture to see why it was drawn or left out.");
        case Progress::Choose:
            return tr("Next: choose another strategy in the view's menu and compare the figures over the pictures.");
        case Progress::Done:
            return tr("Next: press H to see all keys, or open a model of your own.");
    }
    return {};
}

void LegendPanel::showToAudience() {
    m_figures->hide();
    m_next->hide();
    placeStates(int(kTriangleStateCount));
    m_planes->setRows(int(kFrustumPlaneCount) + 2);
    m_grid->setColumnMinimumWidth(3, 0);
    m_grid->setColumnStretch(5, 0);
}

QString LegendPanel::figuresWords() const {
    const QString words = tr("Over each picture: speed, same sides drawn · triangles submitted · pixels missed");
    std::set<Facing> rules;
    std::vector<NamedMetrics> views;
    QStringList times;
    for (const int view : m_session.measuredViews()) {
        const BuiltStrategyPointer& strategy = m_session.slot(view).built();
        if (!strategy) continue;
        rules.insert(strategy->facing());
        const ViewMetrics& figures = m_session.figures(view);
        const bool known = figures.state == ViewMetrics::State::Ready && figures.timed;
        views.push_back({viewLetter(view), &figures});
        times << viewLetter(view) + QLatin1Char(' ') +
                     (known ? millisecondsText(figures.frameMilliseconds) : QStringLiteral("…"));
    }
    if (views.size() < 2 || m_session.question()) return words;
    QStringList lines{words};
    if (rules.size() > 1) lines << tr("These views draw other sides, so their × have other baselines.");
    const QString fastest = fastestSentence(views);
    // Views of other cameras are not compared, and before all are timed there is nothing to say.
    lines << (fastest.isEmpty() ? tr("A frame takes: %1").arg(times.join(QStringLiteral(" · "))) : fastest);
    return lines.join(QLatin1Char('\n'));
}

void LegendPanel::refresh() {
    for (int i = 0; i < m_promises.size(); ++i) {
        const Promise promise = kPromises[size_t(i)];
        m_promises[i]->setText(promiseWord(promise));
        m_promises[i]->setToolTip(tr("%1: %2", "promise, its meaning").arg(promiseWord(promise), promiseSentence(promise)));
    }
    // Shown for every colouring: the budget bars under the pictures always have these colours.
    m_states->setVisible(m_session.opened() != nullptr);
    m_heading->setVisible(m_session.opened() != nullptr);
    m_heading->setText(tr("Triangles of view %1:").arg(viewLetter(m_session.culledBy(m_session.activeView()))));
    m_states->setAccessibleName(tr("What the colours mean"));
    m_next->setText(nextAction());
    m_planes->retranslate();
    showPlanes();
    showMeanings();
    showUndecided();
    showCounts();
}

void LegendPanel::showPlanes() {
    const int view = m_session.activeView();
    const ViewLook& look = m_session.setup(view).look;
    const ViewPicturePointer shown = m_session.picture(view);
    const bool known = shown && shown->request.look.has(Show::Kind::Planes);
    // A strategy that tests no boxes has no boxes to colour.
    const bool boxless = known && shown->planes == PlaneCounts{};
    m_planes->setVisible(m_session.opened() && look.has(Show::Kind::Planes) && !look.inPlace() && !boxless);
    m_planes->setCounts(known ? std::optional(shown->planes) : std::nullopt);
}

/// A view that shows the first entries of a frame has triangles that are not decided yet; any other has none.
void LegendPanel::showUndecided() {
    constexpr auto kUndecided = size_t(TriangleState::Undecided);
    const ViewPicturePointer shown = m_session.picture(m_session.activeView());
    const bool part = shown && shown->request.upTo;
    for (QWidget* widget :
         {m_swatches[kUndecided], static_cast<QWidget*>(m_words[kUndecided]), static_cast<QWidget*>(m_counts[kUndecided])})
        widget->setVisible(part);
}

void LegendPanel::showCounts() {
    m_figures->setText(figuresWords());
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    const bool counted = figures.state == ViewMetrics::State::Ready && figures.states && !m_session.question();
    const bool unmeasured = figures.state == ViewMetrics::State::OnRequest || figures.state == ViewMetrics::State::Failed;
    const QString none = unmeasured ? QStringLiteral("–") : QStringLiteral("…");
    for (size_t state = 0; state < kTriangleStateCount; ++state) {
        // What is drawn may be hidden: without the truth it is not known to be visible.
        const bool drawn = unmeasured && TriangleState(state) == TriangleState::Visible;
        const QString word = drawn ? tr("drawn, visible or not") : translated(triangleStateName(TriangleState(state)));
        // The counts are those of the whole frame, in which nothing is left undecided.
        const bool decided = TriangleState(state) != TriangleState::Undecided, known = counted && decided;
        const uint64_t count = known ? figures.states->counts[state] : 0;
        m_words[state]->setText(word);
        m_counts[state]->setText(known ? shortCount(count) : decided ? none : QString());
        const QString full =
            known ? tr("%1: %2 triangles in the active view", "a state of triangles").arg(word, countText(count)) : word;
        m_words[state]->setToolTip(full);
        m_counts[state]->setToolTip(full);
        m_counts[state]->setAccessibleName(full);
    }
}

void LegendPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
