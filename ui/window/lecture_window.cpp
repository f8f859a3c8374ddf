#include "ui/window/lecture_window.h"

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

// Lengths for a screen of 1280 × 720; larger screens scale them.
constexpr QSize kDesign{1280, 720};
constexpr int kTitle = 48;
constexpr int kPictureWidth = 800;
constexpr int kStructureHeight = 300;
constexpr int kFoot = 64;
constexpr int kButton = 44;
constexpr int kSmallestLetters = 20;
constexpr int kTitleLetters = 28;
constexpr int kNumberLetters = 26;
constexpr int kPageMargin = 16;

void setLetters(QWidget& widget, int pixels, bool bold = false) {
    QFont font = widget.font();
    font.setPixelSize(pixels);
    font.setBold(bold);
    widget.setFont(font);
}

}  // namespace

LectureWindow::LectureWindow(Session& session, ViewGrid& views, QWidget* structure, QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_session(session),
      m_views(views),
      m_title(new QLabel(this)),
      m_explanation(new QLabel(this)),
      m_structure(structure),
      m_foot(new QWidget(this)),
      m_back(new QPushButton(m_foot)),
      m_next(new QPushButton(m_foot)) {
    setPalette(Appearance::palette(false));
    setAutoFillBackground(true);
    setMinimumSize(640, 360);
    m_structure->setParent(this);
    m_structure->show();
    m_explanation->setWordWrap(true);
    m_explanation->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    makeFoot();
    const auto mine = [this](int) { refresh(); };
    connect(&session, &Session::metricsChanged, this, mine);
    connect(&session, &Session::strategyChosen, this, mine);
    connect(&session, &Session::setupChanged, this, mine);
    connect(&session, &Session::sceneChanged, this, &LectureWindow::refresh);
    connect(&session, &Session::questionChanged, this, &LectureWindow::refresh);
}

LectureWindow::~LectureWindow() { giveBack(); }

void LectureWindow::makeFoot() {
    auto* row = new QHBoxLayout(m_foot);
    row->setSpacing(kPageMargin);
    for (QLabel*& number : m_numbers) {
        number = new QLabel(m_foot);
        row->addWidget(number, 1);
    }
    m_software = new QLabel(m_foot);
    m_software->setMargin(6);
    m_software->setAutoFillBackground(true);
    m_software->setBackgroundRole(QPalette::ToolTipBase);
    m_software->setForegroundRole(QPalette::ToolTipText);
    row->addWidget(m_software);
    for (QPushButton* button : {m_back, m_next}) {
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
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
    showView(m_session.activeView());
    setFocus();
}

void LectureWindow::giveBack() {
    if (!m_pane) return;
    m_pane->picture().removeEventFilter(this);
    m_views.take(std::exchange(m_pane, nullptr));
}

void LectureWindow::showView(int view) {
    giveBack();
    m_session.setActiveView(view);
    m_pane = m_views.lend(view);
    m_pane->setParent(this);
    m_pane->picture().installEventFilter(this);
    m_pane->show();
    refresh();
    arrange();
}

void LectureWindow::setStepper(Stepper* stepper) {
    m_stepper = stepper;
    connect(stepper, &Stepper::changed, this, &LectureWindow::refresh);
}

void LectureWindow::step(int way) {
    if (m_stepper && m_stepper->active()) return way > 0 ? m_stepper->forward() : m_stepper->back();
    const std::vector<int> shown = m_session.shownViews();
    const auto place = std::find(shown.begin(), shown.end(), shownView());
    if (place == shown.end()) return;
    const auto count = int(shown.size());
    showView(shown[size_t((int(place - shown.begin()) + way + count) % count)]);
}

void LectureWindow::setBlank(bool blank) {
    m_blank = blank;
    for (QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) child->setVisible(!blank);
    update();
}

int LectureWindow::scaled(int length) const {
    const double scale = std::min(double(width()) / kDesign.width(), double(height()) / kDesign.height());
    return int(length * scale);
}

void LectureWindow::arrange() {
    const int title = scaled(kTitle), foot = scaled(kFoot),
              picture = std::max(1, width() - scaled(kDesign.width() - kPictureWidth));
    const int middle = height() - title - foot;
    setLetters(*m_title, scaled(kTitleLetters), true);
    setLetters(*m_explanation, scaled(kSmallestLetters));
    setLetters(*m_structure, scaled(kSmallestLetters));
    setLetters(*m_software, scaled(kSmallestLetters));
    for (QLabel* number : m_numbers) setLetters(*number, scaled(kNumberLetters), true);
    for (QPushButton* button : {m_back, m_next}) {
        setLetters(*button, scaled(kSmallestLetters));
        button->setMinimumSize(scaled(3 * kButton), scaled(kButton));
    }
    m_title->setGeometry(scaled(kPageMargin), 0, width() - 2 * scaled(kPageMargin), title);
    if (m_pane) m_pane->setGeometry(0, title, picture, middle);
    const int margin = scaled(kPageMargin), side = picture + margin, room = width() - side - margin;
    m_structure->setGeometry(side, title + margin, room, scaled(kStructureHeight) - margin);
    m_explanation->setGeometry(side, title + scaled(kStructureHeight) + margin, room, middle - scaled(kStructureHeight) - margin);
    m_foot->setGeometry(0, height() - foot, width(), foot);
}

void LectureWindow::refresh() {
    if (!m_pane) return;
    const int view = m_pane->view();
    const StrategyInfo& info = findStrategy(m_session.slot(m_session.culledBy(view)).id()).info;
    const QString scene = m_session.opened() ? QString::fromStdString(m_session.opened()->scene->name()) : QString();
    m_title->setText(tr("%1 – %2", "strategy, scene").arg(m_pane->header().firstLine(), scene));
    const bool stepped = m_stepper && m_stepper->place() && m_session.stepOf(view) != nullptr;
    const std::optional<Prediction>& question = m_session.question();
    m_explanation->setText(question  ? QuestionBar::askedText(*question) + QStringLiteral("\n\n") + QuestionBar::words(m_session)
                           : stepped ? m_stepper->sentence()
                                     : translated(info.description));
    const ViewMetrics& figures = m_session.figures(view);
    const bool ready = figures.state == ViewMetrics::State::Ready && !question;
    const QString none = QStringLiteral("…");
    m_numbers[0]->setText(tr("Speed: %1").arg(ready && figures.speedup ? speedText(*figures.speedup) : none));
    m_numbers[1]->setText(tr("Submitted: %1").arg(ready ? percentText(figures.submittedShare()) + QStringLiteral(" %") : none));
    m_numbers[2]->setText(tr("Missed: %1").arg(ready ? countText(figures.accuracy.missedPixels) : none));
    m_back->setText(tr("◀ Back"));
    m_next->setText(tr("Next ▶"));
    const bool several = m_session.shownViews().size() > 1 || stepped;
    m_back->setEnabled(several);
    m_next->setEnabled(several);
    m_software->setText(tr("Software OpenGL"));
    m_software->setVisible(m_session.gpu() && m_session.gpu()->info().software && !m_blank);
    setWindowTitle(tr("Lecture – Cullscope"));
}

bool LectureWindow::eventFilter(QObject* watched, QEvent* event) {
    // While the user turns the picture it has the focus; the keys of the clicker must work nevertheless.
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Escape || key == Qt::Key_B) {
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
        case Qt::Key_Escape:
        case Qt::Key_F5:
            close();
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

void LectureWindow::closeEvent(QCloseEvent* event) {
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
