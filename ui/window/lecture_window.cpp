#include "ui/window/lecture_window.h"

#include <QAction>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QScreen>
#include <algorithm>

#include "core/visibility/registry.h"
#include "ui/look/appearance.h"
#include "ui/panels/question_bar.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// So long without a pick the panels do not tell of one any more.
constexpr int kNothingPicked = 500;  // ms
/// Keys that mean something else here than in the main window.
constexpr std::array kOwnKeys{Qt::Key_B, Qt::Key_Period, Qt::Key_R, Qt::Key_P, Qt::Key_Escape};

bool isOwnKey(int key) { return std::ranges::find(kOwnKeys, key) != kOwnKeys.end(); }

bool hasOwnKey(const QAction& action) {
    return std::ranges::any_of(action.shortcuts(), [](const QKeySequence& keys) {
        return keys.count() == 1 && keys[0].keyboardModifiers() == Qt::NoModifier && isOwnKey(keys[0].key());
    });
}

}  // namespace

LectureWindow::LectureWindow(Session& session, ViewGrid& views, StructurePanel* structure, QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_session(session),
      m_views(views),
      m_title(new QLabel(this)),
      m_place(new QLabel(this)),
      m_sentence(new QLabel(this)),
      m_stepSentence(new QLabel(this)),
      m_structure(structure),
      m_legend(new LegendStrip(session, this)),
      m_foot(new QWidget(this)),
      m_back(new QPushButton(m_foot)),
      m_next(new QPushButton(m_foot)),
      m_spot(new PointerSpot(this)) {
    setPalette(Appearance::palette(false));
    setAutoFillBackground(true);
    setMinimumSize(640, 360);
    m_structure->setParent(this);
    m_structure->showToAudience();
    for (QLabel* words : {m_sentence, m_stepSentence}) {
        words->setWordWrap(true);
        words->setTextFormat(Qt::PlainText);
        words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    }
    m_place->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (parent)
        for (QAction* action : parent->actions())
            if (!hasOwnKey(*action)) addAction(action);
    makeFoot();
    follow();
}

LectureWindow::~LectureWindow() {
    disconnect(&m_session, nullptr, this, nullptr);
    giveBack();
}

void LectureWindow::follow() {
    const auto mine = [this](int) { refresh(); };
    connect(&m_session, &Session::metricsChanged, this, mine);
    connect(&m_session, &Session::strategyChosen, this, mine);
    // Queued: panes that are borrowed or go back take other sizes, from which such changes follow.
    connect(
        &m_session, &Session::setupChanged, this, [this](int) { borrow(); }, Qt::QueuedConnection);
    for (const auto signal : {&Session::sceneChanged, &Session::viewCountChanged})
        connect(&m_session, signal, this, &LectureWindow::borrow, Qt::QueuedConnection);
    for (const auto signal : {&Session::activeViewChanged, &Session::questionChanged})
        connect(&m_session, signal, this, &LectureWindow::refresh);
    connect(&m_session, &Session::pickedInPicture, m_structure, [this] {
        m_structure->showWhy();
        m_asked = true;
        arrange();
    });
    // While the next loss is being looked for there is no pick for a moment.
    m_nothingPicked.setSingleShot(true);
    m_nothingPicked.setInterval(kNothingPicked);
    connect(&m_session, &Session::pickChanged, this,
            [this] { m_asked && !m_session.pick() ? m_nothingPicked.start() : m_nothingPicked.stop(); });
    connect(&m_nothingPicked, &QTimer::timeout, this, [this] {
        m_asked = false;
        arrange();
    });
    connect(m_structure, &StructurePanel::needsChanged, this, &LectureWindow::fit, Qt::QueuedConnection);
    connect(&m_structure->map(), &MapPanel::shownChanged, this, &LectureWindow::fit, Qt::QueuedConnection);
}

void LectureWindow::makeFoot() {
    auto* row = new QHBoxLayout(m_foot);
    row->setContentsMargins(kPageMargin, 0, kPageMargin, 0);
    row->setSpacing(kPageMargin);
    for (QLabel*& number : m_numbers) {
        number = new QLabel(m_foot);
        row->addWidget(number);
    }
    m_ask = new QPushButton(m_foot);
    m_ask->setFlat(true);
    row->addWidget(m_ask);
    row->addStretch(1);
    m_software = new QLabel(m_foot);
    m_software->setMargin(6);
    m_software->setAutoFillBackground(true);
    m_software->setBackgroundRole(QPalette::ToolTipBase);
    m_software->setForegroundRole(QPalette::ToolTipText);
    row->addWidget(m_software);
    for (QPushButton* button : {m_ask, m_back, m_next}) button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(m_back);
    row->addWidget(m_next);
    connect(m_ask, &QPushButton::clicked, this, [this] { reveal(true); });
    connect(m_back, &QPushButton::clicked, this, [this] { step(-1); });
    connect(m_next, &QPushButton::clicked, this, [this] { step(1); });
}

void LectureWindow::begin() {
    const QList<QScreen*> screens = QGuiApplication::screens();
    QScreen* own = parentWidget() ? parentWidget()->screen() : screens.front();
    const auto second = std::find_if(screens.begin(), screens.end(), [own](QScreen* screen) { return screen != own; });
    setScreen(second != screens.end() ? *second : own);
    setGeometry((second != screens.end() ? *second : own)->geometry());
    showFullScreen();
    raise();
    activateWindow();
    borrow();
    setFocus();
}

std::vector<int> LectureWindow::views() const {
    std::vector<int> views;
    for (const ViewPane* pane : m_panes) views.push_back(pane->view());
    return views;
}

std::vector<int> LectureWindow::wantedViews() const {
    std::vector<int> shown = m_session.shownViews();
    if (!m_alone) return shown;
    return {m_session.activeView()};
}

void LectureWindow::borrow() {
    if (!isVisible()) return;  // it was closed meanwhile
    const std::vector<int> wanted = wantedViews();
    if (wanted != views()) {
        giveBack();
        for (const int view : wanted) {
            ViewPane* pane = m_views.lend(view);
            pane->setParent(this);
            pane->picture().installEventFilter(this);
            m_panes.push_back(pane);
        }
    }
    for (const ViewPane* pane : m_panes)
        if (const auto* map = qobject_cast<const MapPanel*>(pane->strip()))
            connect(map, &MapPanel::shownChanged, this, &LectureWindow::fit,
                    Qt::ConnectionType(Qt::QueuedConnection | Qt::UniqueConnection));
    for (ViewPane* pane : m_panes) pane->setVisible(!m_blank);
    m_spot->raise();
    refresh();
}

void LectureWindow::giveBack() {
    for (ViewPane* pane : std::exchange(m_panes, {})) {
        pane->picture().removeEventFilter(this);
        m_views.take(pane);
    }
}

void LectureWindow::setStepper(Stepper* stepper) {
    m_stepper = stepper;
    connect(stepper, &Stepper::changed, this, &LectureWindow::refresh);
}

void LectureWindow::setLessons(LessonPlayer* lessons, const Language* language) {
    m_lessons = lessons;
    m_language = language;
    connect(lessons, &LessonPlayer::changed, this, [this] {
        m_alone = m_asked = false;
        reveal(false);
    });
    connect(lessons, &LessonPlayer::shown, this, [this](const LessonStep& step) {
        if (!step.state.structurePanel.map.empty()) m_structure->map().setColouring(step.state.structurePanel.map);
        if (!step.state.structurePanel.page.empty()) m_structure->showPage(step.state.structurePanel.page);
        borrow();
    });
}

bool LectureWindow::stepped() const { return m_stepper && m_stepper->active(); }

void LectureWindow::step(int way) {
    if (inLesson()) return way > 0 ? m_lessons->forward() : m_lessons->back();
    if (stepped()) return way > 0 ? m_stepper->forward() : m_stepper->back();
    const std::vector<int> shown = m_session.shownViews();
    const auto place = std::find(shown.begin(), shown.end(), m_session.activeView());
    if (place == shown.end() || shown.size() < 2) return;
    // After all views together each one alone, in their order; then all together again.
    if (!m_alone) return setAlone(true, way > 0 ? shown.front() : shown.back());
    if (*place == (way > 0 ? shown.back() : shown.front())) return setAlone(false, shown.front());
    setAlone(true, *(place + way));
}

void LectureWindow::setAlone(bool alone, int view) {
    m_alone = alone;
    m_asked = false;
    m_session.setActiveView(view);
    reveal(false);
    borrow();
}

void LectureWindow::reveal(bool revealed) {
    m_revealed = revealed;
    refresh();
}

void LectureWindow::setBlank(bool blank) {
    m_blank = blank;
    m_spot->setOn(false);
    for (QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (child != m_spot) child->setVisible(!blank);
    update();
    if (!blank) refresh();
}

QString LectureWindow::titleText() const {
    if (inLesson()) return QString::fromStdString(textIn(m_lessons->lesson().title, m_language->current().toStdString()));
    const QString scene = m_session.opened() ? QString::fromStdString(m_session.opened()->scene->name()) : QString();
    return tr("%1 – %2", "strategy, scene").arg(m_views.pane(m_session.activeView()).header().firstLine(), scene);
}

QString LectureWindow::sentenceText() const {
    if (const std::optional<Prediction>& question = m_session.question())
        return QuestionBar::askedText(*question) + QLatin1Char('\n') + QuestionBar::words(m_session);
    if (inLesson()) return QString::fromStdString(textIn(m_lessons->current().sentence, m_language->current().toStdString()));
    return translated(findStrategy(m_session.slot(m_session.culledBy(m_session.activeView())).id()).info.description);
}

void LectureWindow::refresh() {
    if (m_panes.empty()) return;
    m_title->setText(titleText());
    m_sentence->setText(sentenceText());
    m_place->setText(
        inLesson() ? tr("%1 of %2", "a step of a lesson, number of steps").arg(m_lessons->step() + 1).arg(m_lessons->count())
                   : QString());
    m_stepSentence->setText(stepped() && m_stepper->place() ? m_stepper->sentence() : QString());
    showFigures();
    m_back->setText(tr("◀ Back"));
    m_next->setText(tr("Next ▶"));
    const bool several = m_session.shownViews().size() > 1 || stepped();
    m_back->setEnabled(inLesson() ? m_lessons->step() > 0 : several);
    m_next->setEnabled(inLesson() ? m_lessons->step() + 1 < m_lessons->count() : several);
    m_software->setText(tr("Software OpenGL"));
    m_software->setVisible(m_session.gpu() && m_session.gpu()->info().software && m_revealed && !m_blank);
    setWindowTitle(tr("Lecture – Cullscope"));
    arrange();
}

void LectureWindow::showFigures() {
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    const bool ready = figures.state == ViewMetrics::State::Ready && !m_session.question();
    // A dash where no figure is under way.
    const bool due = figures.state == ViewMetrics::State::Stale || (ready && !figures.timed);
    const QString none = due ? QStringLiteral("…") : QStringLiteral("–");
    m_numbers[0]->setText(tr("Speed: %1").arg(ready && figures.speedup ? speedText(*figures.speedup) : none));
    m_numbers[1]->setText(tr("Submitted: %1").arg(ready ? percentText(figures.submittedShare()) + QStringLiteral(" %") : none));
    m_numbers[2]->setText(tr("Missed: %1").arg(ready ? countText(figures.lostPixels()) : none));
    for (QLabel* number : m_numbers) number->setVisible(m_revealed && !m_blank);
    m_ask->setText(tr("How fast, and what is lost? (R)"));
    m_ask->setVisible(!m_revealed && !m_blank);
}

bool LectureWindow::eventFilter(QObject* watched, QEvent* event) {
    // While the user turns the picture it has the focus; the keys of the clicker must work nevertheless.
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool page = key->key() == Qt::Key_PageUp || key->key() == Qt::Key_PageDown;
        if (page || (isOwnKey(key->key()) && key->modifiers() == Qt::NoModifier)) {
            keyPressEvent(static_cast<QKeyEvent*>(event));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void LectureWindow::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_PageDown:
            step(1);
            break;
        case Qt::Key_PageUp:
            step(-1);
            break;
        case Qt::Key_B:
        case Qt::Key_Period:
            setBlank(!m_blank);
            break;
        case Qt::Key_R:
            reveal(!m_revealed);
            break;
        case Qt::Key_P:
            m_spot->setOn(!m_spot->on() && !m_blank);
            break;
        case Qt::Key_Escape:
            close();
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

void LectureWindow::closeEvent(QCloseEvent* event) {
    m_spot->setOn(false);
    // Panes that go back take other sizes, and changes that follow from that are no reason to borrow them again.
    disconnect(&m_session, nullptr, this, nullptr);
    giveBack();
    emit left();
    QWidget::closeEvent(event);
}

void LectureWindow::paintEvent(QPaintEvent*) {
    if (m_blank) QPainter(this).fillRect(rect(), Qt::black);
}

void LectureWindow::resizeEvent(QResizeEvent*) { arrange(); }

void LectureWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
