#include "ui/window/view_commands.h"

#include <QClipboard>
#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/session/cullbench_command.h"
#include "ui/session/named_views.h"
#include "ui/session/object_pick.h"
#include "ui/window/placed_panels.h"
#include "ui/window/size_options.h"

namespace cullscope::ui {

namespace {

constexpr const char* kAxesSetting = "axes";
constexpr int kWidestName = 240;  // pixels, of an object in a menu
constexpr const char* kSizeSetting = "picture_size";

}  // namespace

ViewCommands::ViewCommands(Session& session, ViewGrid& views, WindowActions& actions, ScreenshotTaker& screenshots,
                           QWidget* window)
    : QObject(window), m_session(session), m_views(views), m_actions(actions), m_window(window), m_screenshots(screenshots) {
    wire();
    connect(&session, &Session::activeViewChanged, this, &ViewCommands::refresh);
    connect(&session, &Session::sceneChanged, this, &ViewCommands::refresh);
    connect(&session, &Session::setupChanged, this, &ViewCommands::refresh);
    connect(&session, &Session::viewCountChanged, this, &ViewCommands::refresh);
    connect(&session, &Session::metricsChanged, this, &ViewCommands::refresh);
    connect(m_actions.pictureSize, &QMenu::aboutToShow, this, &ViewCommands::fillSizes);
    fillSizes();
    connect(&views, &ViewGrid::menuRequested, this, &ViewCommands::showMenuOf);
    refresh();
}

void ViewCommands::edit(const std::function<void(ViewSetup&)>& change) {
    ViewSetup setup = m_session.setup(m_session.activeView());
    change(setup);
    m_session.setSetup(m_session.activeView(), setup);
}

void ViewCommands::wire() {
    connect(m_actions.freeze, &QAction::triggered, this, [this](bool on) { m_session.setFrozen(m_session.activeView(), on); });
    connect(m_actions.watch, &QAction::triggered, this, &ViewCommands::watch);
    connect(&m_actions, &WindowActions::namedViewChosen, this,
            [this](int index) { lookFrom(m_session, namedViews()[size_t(index)]); });
    connect(m_actions.clippingPlane, &QAction::triggered, this, [this] {
        if (m_clippingPlane == nullptr) m_clippingPlane = new SectionDialog(m_session, m_window);
        m_clippingPlane->begin();
    });
    connect(m_actions.projection, &QActionGroup::triggered, this, [this](const QAction* action) {
        setProjection(m_session, action == m_actions.parallel ? ProjectionKind::Parallel : ProjectionKind::Perspective);
    });
    connect(&m_session, &Session::cameraChanged, this, &ViewCommands::refreshProjection);
    for (const auto& [show, action] : m_actions.shows)
        connect(action, &QAction::triggered, this,
                [this, show = show](bool on) { edit([&](ViewSetup& setup) { setup.look.showWithAll(*show, on); }); });
    connect(m_actions.truth, &QAction::triggered, this,
            [this](bool on) { edit([on](ViewSetup& setup) { setup.wipe.mode = on ? Wipe::Mode::Truth : Wipe::Mode::None; }); });
    connect(m_actions.loss, &QAction::triggered, this,
            [this](bool on) { edit([on](ViewSetup& setup) { setup.wipe.mode = on ? Wipe::Mode::Loss : Wipe::Mode::None; }); });
    connect(m_actions.nextLoss, &QAction::triggered, this,
            [this] { m_views.pane(m_session.activeView()).picture().goToNextLoss(); });
    const auto showAxes = [this](bool on) {
        for (int view = 0; view < Session::kMostViews; ++view) m_views.pane(view).picture().setAxes(on);
    };
    m_actions.axes->setChecked(m_settings.value(QLatin1String(kAxesSetting), true).toBool());
    showAxes(m_actions.axes->isChecked());
    connect(m_actions.axes, &QAction::triggered, this, [this, showAxes](bool on) {
        showAxes(on);
        m_settings.setValue(QLatin1String(kAxesSetting), on);
    });
    connect(m_actions.loupe, &QAction::triggered, this, [this](bool on) {
        for (int view = 0; view < Session::kMostViews; ++view) m_views.pane(view).picture().setLoupe(on);
    });
}

std::optional<int> ViewCommands::watcher() const {
    const int culling = m_session.culledBy(m_session.activeView());
    for (const int view : m_session.shownViews())
        if (view != culling && m_session.culledBy(view) == culling) return view;
    return std::nullopt;
}

void ViewCommands::watch(bool on) {
    const int culling = m_session.culledBy(m_session.activeView());
    if (const std::optional<int> view = watcher(); view && !on) {
        ViewSetup setup = m_session.setup(*view);
        setup.role = Role::Linked;
        setup.look = {};
        m_session.setSetup(*view, setup);
    } else if (!view && on) {
        if (m_session.viewCount() < 2) m_session.setViewCount(2);
        const std::vector<int> shown = m_session.shownViews();
        const auto place = std::find(shown.begin(), shown.end(), culling);
        const int other = place == shown.end() || place + 1 == shown.end() ? shown.front() : *(place + 1);
        if (other == culling) return;
        m_session.observe(other, culling);
        ViewSetup setup = m_session.setup(other);
        setup.look.watch();
        m_session.setSetup(other, setup);
    }
    refresh();
}

void ViewCommands::refreshProjection() {
    const bool parallel =
        m_session.opened() != nullptr && m_session.viewingCamera(m_session.activeView()).projection == ProjectionKind::Parallel;
    (parallel ? m_actions.parallel : m_actions.perspective)->setChecked(true);
    m_actions.offerProjection(parallel ? *m_actions.perspective : *m_actions.parallel);
}

void ViewCommands::refresh() {
    const int view = m_session.activeView();
    const ViewSetup& setup = m_session.setup(view);
    const bool scene = m_session.opened() != nullptr;
    const bool model = scene && setup.look.inPlace();
    m_actions.setPictureUsable(scene, model);
    for (QAction* action : {m_actions.clippingPlane, m_actions.perspective, m_actions.parallel, m_actions.lookFrom->menuAction()})
        action->setEnabled(scene);
    refreshProjection();
    m_actions.freeze->setChecked(setup.role == Role::Frozen);
    m_actions.watch->setChecked(scene && watcher().has_value());
    for (const auto& [show, action] : m_actions.shows) action->setChecked(setup.look.has(*show));
    m_actions.truth->setChecked(setup.wipe.mode == Wipe::Mode::Truth);
    m_actions.loss->setChecked(setup.wipe.mode == Wipe::Mode::Loss);
    m_actions.nextLoss->setEnabled(scene && !model && setup.role == Role::Linked && !m_session.figures(view).holes.empty());
}

void ViewCommands::copyPicture(int view, bool overlays) {
    const QImage picture = m_screenshots.clipboardImage(view, overlays);
    if (!picture.isNull()) QGuiApplication::clipboard()->setImage(picture);
}

void ViewCommands::fillSizes() {
    m_actions.pictureSize->clear();
    const int view = m_session.activeView();
    addSizeOptions(*m_actions.pictureSize, m_session.setup(view).size, m_session.renderSize(view), [this](const auto& size) {
        setSizeOfAll(size);
        m_settings.setValue(QLatin1String(kSizeSetting), pictureSizeText(size));
    });
}

void ViewCommands::setSizeOfAll(const std::optional<Viewport>& size) {
    std::vector<int> all(Session::kMostViews);
    std::iota(all.begin(), all.end(), 0);
    m_session.setPictureSize(all, size);
}

void ViewCommands::restoreSize() {
    if (const auto kept = pictureSizeFromText(m_settings.value(QLatin1String(kSizeSetting)).toString())) setSizeOfAll(*kept);
}

void ViewCommands::fillMenu(QMenu& menu, int view) {
    ViewPane& pane = m_views.pane(view);
    ViewMenu filler(m_session, pane, m_actions, menu);
    filler.addStrategies();
    filler.addCameras();
    filler.addLook();
    filler.addComparisons();
    filler.addSizes();
    filler.addUploads();
    filler.addPanels(PlacedPanels::known(), PlacedPanels::knownBelow());
    menu.addSeparator();
    menu.addAction(m_actions.screenshot);
    menu.addAction(tr("Copy the picture"), this, [this, view] { copyPicture(view, true); });
    menu.addAction(tr("Copy the picture without what lies over it"), this, [this, view] { copyPicture(view, false); });
    menu.addAction(tr("Copy the cullbench command"), this,
                   [&pane] { QGuiApplication::clipboard()->setText(cullbenchCommand(pane.picture().subject())); });
    menu.addSeparator();
    menu.addActions({m_actions.nextLoss, m_actions.loupe});
    menu.addSeparator();
    menu.addActions({m_actions.home, m_actions.frame});
}

void ViewCommands::addObject(QMenu& menu, uint32_t object) {
    QString name = QString::fromStdString(m_session.opened()->scene->instances()[object].name);
    // An ampersand in a menu marks a key, and a tab begins a shortcut.
    name.replace(QLatin1Char('&'), QStringLiteral("&&")).replace(QLatin1Char('\t'), QLatin1Char(' '));
    const QString shortName = menu.fontMetrics().elidedText(name, Qt::ElideMiddle, kWidestName);
    QMenu* of = menu.addMenu(tr("Object %1", "its name").arg(shortName));
    of->addAction(tr("Why"), this, [this, object] {
        pickLoss(m_session, object);
        emit m_session.pickedInPicture(m_session.activeView());
    });
    of->addAction(tr("Frame"), this, [this, object] { frameObject(m_session, object); });
    of->addSeparator();
    of->addAction(tr("Hide"), this, [this, object] { setObjectsHidden(m_session, {object}, true); });
    of->addAction(tr("Isolate"), this, [this, object] { isolateObjects(m_session, {object}); });
}

void ViewCommands::addObjects(QMenu& menu, int view, const QPoint& position) {
    const SceneView& picture = m_views.pane(view).picture();
    const Vec2 pixel = picture.pixelAt(picture.mapFromGlobal(position));
    const auto object = m_session.objectAt(view, int(std::floor(pixel.x)), int(std::floor(pixel.y)));
    if (object) addObject(menu, *object);
    const bool hidden = std::ranges::count(m_session.hidden(), true) > 0;
    if (hidden) menu.addAction(tr("Show all hidden objects"), this, [this] { showAllObjects(m_session); });
    if (object || hidden) menu.addSeparator();
}

void ViewCommands::showMenuOf(int view, const QPoint& position) {
    if (!m_session.opened()) return;
    // When the menu closes, keys go to the view whose menu it was.
    m_views.pane(view).picture().setFocus();
    m_session.setActiveView(view);
    QMenu menu(m_window);
    addObjects(menu, view, position);
    fillMenu(menu, view);
    menu.exec(position);
}

}  // namespace cullscope::ui
