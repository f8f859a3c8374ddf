#include "ui/window/main_window.h"

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QScrollArea>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/generate_dialog.h"
#include "ui/dialogs/help_window.h"
#include "ui/dialogs/keys_dialog.h"
#include "ui/look/tinted_icon.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kNarrowestDock = 320;
constexpr int kLegendMargin = 9;  // as that of the panels above it
constexpr int kScenePage = 1;
constexpr const char* kLanguageSetting = "language";
constexpr const char* kAppearanceSetting = "appearance";

/// The local file of a drag; empty if there are several or none.
QString draggedFile(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

}  // namespace

MainWindow::MainWindow(Session& session, Language& language, Appearance& appearance, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_language(language),
      m_appearance(appearance),
      m_actions(new WindowActions(this)),
      m_toolBar(new QToolBar(this)) {
    m_actions->fill(*menuBar());
    m_toolBar->setObjectName(QStringLiteral("toolbar"));
    m_toolBar->setMovable(false);
    m_toolBar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_toolBar->setIconSize({20, 20});
    m_actions->fill(*m_toolBar);
    if (auto* button = qobject_cast<QToolButton*>(m_toolBar->widgetForAction(m_actions->generate->menuAction())))
        button->setPopupMode(QToolButton::InstantPopup);
    addToolBar(m_toolBar);
    fixBarHeights();
    setAcceptDrops(true);
    m_reader = new SnapshotReader(m_session, this);
    makeCentre();
    makeSide();
    makeDocks();
    makeStatusBar();
    m_panels = new PlacedPanels(m_session, *m_views, *m_reader, *m_experiments, this);
    m_document = new DocumentCommands(m_session, *m_views, *m_actions, this);
    m_viewCommands = new ViewCommands(m_session, *m_views, *m_actions, m_document->screenshots(), this);
    m_paths = new PathCommands(m_session, *m_actions, *m_experiments, this);
    m_pathBar = new PathBar(m_paths->desk(), centralWidget());
    m_middle->addWidget(m_pathBar);
    connect(m_pathBar, &PathBar::saveRequested, m_paths, &PathCommands::save);
    m_papers = new PaperCommands(m_session, *m_actions, *m_experiments, m_document->undo(), this);
    connect(m_papers, &PaperCommands::sceneWanted, &m_document->opener(), &SessionOpener::open);
    m_lessons = new LessonCommands(m_session, *m_views, *m_actions, *m_document, m_language, this);
    m_lessons->handout().setStructure(*m_structure, *m_reader);
    m_lessonBar = new LessonBar(m_lessons->player(), m_language, m_stack->parentWidget());
    m_middle->insertWidget(0, m_lessonBar);
    m_presenter = new PresenterPage(m_lessons->player(), m_language, m_stack);
    m_stack->addWidget(m_presenter);
    m_memory = std::make_unique<WindowMemory>(*this);
    wireCommands();
    wireSession();
    wireLegend();
    retranslate();
    showState();
    arrange();
}

MainWindow::~MainWindow() {
    m_session.endFrames();
    // A dock that hides with the window asks for a legend, which makes no widgets in a window that goes.
    m_dock->disconnect(this);
    // The lecture window returns the borrowed view to the grid, so it is destroyed while the grid exists.
    delete m_lecture;
}

void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    auto* row = new QHBoxLayout(centre);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    m_side = new SidePanel(centre);
    m_stack = new QStackedWidget(centre);
    m_empty = new EmptyState(m_session, m_actions->generate, m_stack);
    m_views = new ViewGrid(m_session, m_stack);
    m_stack->addWidget(m_empty);
    m_stack->addWidget(m_views);
    m_rightRail = new QWidget(centre);
    m_rightRail->setFixedWidth(SidePanel::kRailWidth);
    auto* rail = new QVBoxLayout(m_rightRail);
    rail->setContentsMargins(2, 4, 2, 4);
    rail->addStretch(1);
    row->addWidget(m_side);
    m_steps = new StepCommands(m_session, *m_actions, this);
    m_stepBar = new StepBar(m_session, m_steps->stepper(), centre);
    m_middle = new QVBoxLayout;
    m_middle->setSpacing(0);
    m_middle->addWidget(m_stack, 1);
    m_middle->addWidget(m_colours = new LegendStrip(m_session, centre));
    m_middle->addWidget(m_stepBar);
    m_questionBar = new QuestionBar(m_session, m_steps->questions(), centre);
    m_middle->addWidget(m_questionBar);
    row->addLayout(m_middle, 1);
    row->addWidget(m_rightRail);
    setCentralWidget(centre);
}

void MainWindow::makeSide() {
    auto* scroll = new QScrollArea(m_side);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_strategy = new StrategyPanel(m_session, scroll);
    scroll->setWidget(m_strategy);
    scroll->setFocusProxy(m_strategy);
    m_scene = new ScenePanel(m_session, m_side);
    m_scene->setReader(*m_reader);
    m_side->addPage(scroll, QStringLiteral("strategy"));
    m_side->addPage(m_scene, QStringLiteral("scene"));
}

void MainWindow::makeDocks() {
    m_dock = new QDockWidget(this);
    m_dock->setObjectName(QStringLiteral("inside"));
    m_dock->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    auto* inside = new QWidget(m_dock);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    // Scrolls, so that the contents of the dock never determine the size of the window.
    m_dockScroll = new QScrollArea(inside);
    m_dockScroll->setWidgetResizable(true);
    m_dockScroll->setFrameShape(QFrame::NoFrame);
    m_dockScroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_dockScroll->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget(m_dockScroll);
    auto* layout = new QVBoxLayout(content);
    m_structure = new StructurePanel(m_session, *m_reader, content);
    m_tabs = &m_structure->tabs();
    m_figures = new MetricsPanel(m_session, m_tabs);
    m_figures->setObjectName(QStringLiteral("figures"));
    m_tabs->insertTab(0, m_figures, QString());
    m_tabs->setCurrentIndex(0);
    m_answers = new QWidget(content);
    auto* answers = new QVBoxLayout(m_answers);
    answers->setContentsMargins(0, 0, 0, 0);
    answers->addWidget(m_structure, 1);
    layout->addWidget(m_answers, 1);
    layout->addWidget(m_questionTree = new QuestionTree(m_session, *m_reader, m_steps->questions(), content), 1);
    m_dockScroll->setWidget(content);
    m_dockScroll->setMinimumWidth(kNarrowestDock);
    column->addWidget(m_dockScroll, 1);
    // Below what scrolls: what the colours mean and what to do next are always in sight.
    m_legend = new LegendPanel(m_session, inside);
    m_legend->setContentsMargins(kLegendMargin, 0, kLegendMargin, kLegendMargin);
    column->addWidget(m_legend);
    m_dock->setWidget(inside);
    addDockWidget(Qt::RightDockWidgetArea, m_dock);
    m_experiments = new Experiments(m_session, this);
    m_statistics = new StatisticsDock(*m_experiments, this);
    addDockWidget(Qt::BottomDockWidgetArea, m_statistics);
    m_statistics->hide();
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_statistics->toggleViewAction()->setIcon(tintedIcon(QStringLiteral("statistics")));
    m_side->addAction(m_statistics->toggleViewAction());
    m_dock->toggleViewAction()->setIcon(tintedIcon(QStringLiteral("inside")));
    m_actions->panels->addActions({m_dock->toggleViewAction(), m_statistics->toggleViewAction()});
    addRailButton(m_dock->toggleViewAction());
    m_floatingDocks = new FloatingDocks(*this, *m_stack);
    m_floatingDocks->add(*m_dock, [](const QRect& views) { return views.adjusted(views.width() - kDockWidth, 0, 0, 0); });
    m_floatingDocks->add(*m_statistics, [](const QRect& views) { return views.adjusted(0, views.height() / 2, 0, 0); });
    connect(m_dock, &QDockWidget::visibilityChanged, this, &MainWindow::showRightRail);
}

void MainWindow::makeStatusBar() {
    m_loading = new LoadingStrip(m_session.loader(), this);
    m_gl = new QLabel(this);
    m_software = new QLabel(this);
    m_software->setAutoFillBackground(true);
    m_software->setBackgroundRole(QPalette::ToolTipBase);
    m_software->setForegroundRole(QPalette::ToolTipText);
    m_software->setMargin(3);
    statusBar()->addWidget(m_loading, 1);
    statusBar()->addPermanentWidget(m_software);
    statusBar()->addPermanentWidget(m_gl);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(0, 0, 6, 0);
    // Fixed height: the loading strip must not change the size of the views.
    statusBar()->setFixedHeight(m_loading->sizeHint().height() + 4);
    m_message = new MessageBar(*statusBar());
}

void MainWindow::wireCommands() {
    connect(m_actions->resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
    m_document->setArrangement([this] { return arrangement(); });
    m_document->opener().setWindowState([this](SessionState& state) {
        state.structurePanel = {m_structure->page(), m_structure->map().map().colouring()};
    });
    connect(&m_lessons->player(), &LessonPlayer::shown, this, [this](const LessonStep& step) {
        showPanels(step.state);
        // What the program itself set up is no progress of the user.
        if (!m_lessons->player().active()) m_legend->startAnew();
    });
    connect(&m_document->opener(), &SessionOpener::restored, this, [this](const SessionState& state) {
        showPanels(state);
        if (state.arrangement == kLectureArrangement) beginLecture();
    });
    connect(m_empty, &EmptyState::openRequested, m_document, &DocumentCommands::openByDialog);
    connect(m_actions->quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions, &WindowActions::generatorChosen, this, &MainWindow::generate);
    connect(m_actions->lecture, &QAction::triggered, this, &MainWindow::beginLecture);
    connect(m_actions->home, &QAction::triggered, &m_session, &Session::goHome);
    connect(m_actions->frame, &QAction::triggered, &m_session, &Session::frameScene);
    connect(m_actions->views, &QActionGroup::triggered, this,
            [this](const QAction* action) { m_session.setViewCount(action->data().toString().toInt()); });
    connect(m_actions->upAxis, &QActionGroup::triggered, this,
            [this](const QAction* action) { m_session.setUpAxis(action == m_actions->upZ ? UpAxis::Z : UpAxis::Y); });
    connect(m_actions, &WindowActions::languageChosen, this, [this](const QString& id) {
        m_language.use(id);
        m_settings.setValue(QLatin1String(kLanguageSetting), id);
    });
    connect(m_actions->appearance, &QActionGroup::triggered, this, [this](const QAction* action) {
        m_appearance.setMode(Appearance::fromId(action->data().toString()));
        m_settings.setValue(QLatin1String(kAppearanceSetting), action->data());
    });
    connect(m_actions->help, &QAction::triggered, this, &MainWindow::showHelp);
    connect(m_actions->keys, &QAction::triggered, this, [this] { KeysDialog(this).exec(); });
    connect(m_actions->about, &QAction::triggered, this,
            [this] { AboutDialog(m_session.gpu() ? m_session.gpu()->info() : GlInfo{}, this).exec(); });
}

void MainWindow::wireSession() {
    connect(&m_session, &Session::sceneChanged, this, [this] {
        m_message->hide();
        showState();
        m_views->pane(m_session.activeView()).picture().setFocus();
    });
    connect(&m_session, &Session::viewCountChanged, this, &MainWindow::showState);
    connect(&m_session, &Session::viewCountChanged, this, &MainWindow::arrange);
    connect(&m_session, &Session::cameraChanged, this,
            [this] { (m_session.upAxis() == UpAxis::Z ? m_actions->upZ : m_actions->upY)->setChecked(true); });
    connect(&m_session, &Session::pickedInPicture, m_structure, &StructurePanel::showWhy);
    // Among many views the panel is folded; a pick asks for what it says. The keyboard stays with the picture.
    connect(&m_session, &Session::pickedInPicture, m_dock, [this] {
        if (m_floatingDocks->floating() && !m_lecture) FloatingDocks::showBeside(*m_dock);
    });
    connect(m_actions->stepThrough, &QAction::triggered, m_structure,
            [this](bool on) { on ? m_structure->showSteps() : void(); });
    // What the panels show would answer an open question.
    connect(&m_session, &Session::questionChanged, this, [this] {
        m_answers->setVisible(!m_session.question());
        m_legend->setVisible(!m_session.question());
        m_statistics->widget()->setVisible(!m_session.question());
    });
    connect(m_legend, &LegendPanel::lessonRequested, this, [this] { m_lessons->player().begin(LessonPlayer::known().front()); });
    connect(&m_session, &Session::messageRaised, m_message, &MessageBar::show);
    connect(&m_session, &Session::fileSaved, m_message, &MessageBar::confirmSaved);
    connect(&m_language, &Language::changed, this, &MainWindow::showState);
}

void MainWindow::showState() {
    const OpenedScenePointer& opened = m_session.opened();
    m_stack->setCurrentWidget(m_lecture ? m_presenter : opened ? static_cast<QWidget*>(m_views) : m_empty);
    for (QAction* action : m_actions->views->actions())
        action->setChecked(action->data().toString().toInt() == m_session.viewCount());
    (m_session.upAxis() == UpAxis::Z ? m_actions->upZ : m_actions->upY)->setChecked(true);
    for (QAction* action : m_actions->languages->actions()) action->setChecked(action->data().toString() == m_language.current());
    for (QAction* action : m_actions->appearance->actions())
        action->setChecked(action->data().toString() == Appearance::id(m_appearance.mode()));
    m_actions->home->setEnabled(opened != nullptr);
    m_actions->frame->setEnabled(opened != nullptr);
    m_actions->lecture->setEnabled(opened != nullptr);
    const QString scene = opened ? QString::fromStdString(opened->scene->name()) : QString();
    setWindowTitle(scene.isEmpty() ? QStringLiteral("Cullscope") : tr("%1 – Cullscope").arg(scene));
}

void MainWindow::retranslate() {
    m_actions->retranslate();
    m_document->retranslate();
    m_lessons->retranslate();
    m_dock->setWindowTitle(tr("Inside"));
    m_dock->toggleViewAction()->setToolTip(tr("Inside: what the strategy decided, and why"));
    m_toolBar->setWindowTitle(tr("Toolbar"));
    m_tabs->tabBar()->setAccessibleName(tr("Inside"));
    m_tabs->setTabText(0, tr("Figures"));
    m_side->setPageTitle(kStrategyPage, tr("Strategy"));
    m_side->setPageTitle(kScenePage, tr("Scene"));
    const GlInfo gl = m_session.gpu() ? m_session.gpu()->info() : GlInfo{};
    m_software->setText(tr("Software OpenGL"));
    m_software->setToolTip(tr("The processor draws: times are not those of a graphics card."));
    m_software->setVisible(gl.software);
    m_gl->setText(QString::fromStdString(gl.renderer));
    m_gl->setToolTip(QString::fromStdString(gl.version));
    showState();
}

void MainWindow::generate(int generator) {
    const GeneratorInfo& info = sceneGenerators()[size_t(generator)];
    if (info.parameters.empty()) {
        m_document->opener().open(QString::fromStdString(info.id));
        return;
    }
    GenerateDialog dialog(info, this);
    if (dialog.exec() == QDialog::Accepted) m_document->opener().open(dialog.specification());
}

void MainWindow::showHelp() {
    auto* open = findChild<HelpWindow*>();
    if (!open) open = new HelpWindow(m_language, this);
    open->show();
    open->raise();
    open->activateWindow();
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QMainWindow::changeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString file = draggedFile(*event->mimeData());
    if (file.isEmpty()) return;
    event->acceptProposedAction();
    m_document->opener().open(file);
}

}  // namespace cullscope::ui
