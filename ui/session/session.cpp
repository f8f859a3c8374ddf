#include "ui/session/session.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/error.h"
#include "core/scene/camera_path.h"
#include "core/scene/hidden.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

constexpr int kRestBeforeMeasuring = 200;  // ms
constexpr std::array kFirstStrategies{"all", "backface"};

SceneLoader::Opener openerFor(const Session::Options& options) {
    if (options.opener) return options.opener;
    return [source = options.sceneSource](const std::string& specification, const Progress& progress) {
        return openScene(specification, source, progress);
    };
}

/// The first views differ; the further ones go through the list, so that eight views compare eight strategies where there are.
const RegisteredStrategy& firstStrategy(size_t view) {
    if (view < kFirstStrategies.size()) return findStrategy(kFirstStrategies[view]);
    return strategies()[view % strategies().size()];
}

}  // namespace

Session::Session(Options options, QObject* parent)
    : QObject(parent), m_sceneSource(options.sceneSource), m_loader(openerFor(options)) {
    if (options.graphics) {
        m_gpu = std::make_unique<GpuThread>();
        m_upload = std::make_unique<SceneUpload>(*m_gpu, options.uploader);
        makeGraphics();
    }
    for (int view = 0; view < kMostViews; ++view) makeView(view);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestBeforeMeasuring);
    connect(&m_rest, &QTimer::timeout, this, [this] { measure(false); });
    connect(&m_loader, &SceneLoader::loaded, this, &Session::show);
    connect(&m_loader, &SceneLoader::failed, this, [this](const Message& message) { raise(Severity::Error, message); });
    connect(&m_loader, &SceneLoader::cancelled, this, [this] {
        raise(Severity::Information,
              {QT_TRANSLATE_NOOP("core", "Opening %1 was cancelled."), {m_loader.specification().toStdString()}});
    });
}

Session::~Session() {
    m_loader.blockSignals(true);
    m_loader.cancel();
    m_picks.invalidate();
    if (m_meter) m_meter->cancel();
    for (ViewState& view : m_views) view.figures = {};
    // What runs on the GPU thread, or is still on its way from it, must go while it lives.
    m_pictures = nullptr;
    m_meter = nullptr;
    m_upload = nullptr;
    if (m_gpu) m_gpu->run([] {});
    QCoreApplication::removePostedEvents(this);
}

void Session::makeGraphics() {
    m_meter = std::make_unique<FigureMeter>(*m_gpu);
    m_pictures = std::make_unique<PictureMaker>(*m_gpu, kMostViews, [this](int view) { return viewRequest(view); });
    connect(m_upload.get(), &SceneUpload::changed, this, [this] {
        emit buffersChanged();
        update();
    });
    connect(m_upload.get(), &SceneUpload::failed, this, [this](const Message& message) { raise(Severity::Error, message); });
    connect(m_meter.get(), &FigureMeter::measured, this, [this](int view, const Figures& figures) {
        if (figures.timed || figures.state == Figures::State::Failed)
            std::erase_if(m_underWay, [view](const FigureMeter::Subject& subject) { return subject.view == view; });
        setFigures(view, figures);
        update();  // verdicts against the truth may be on show
    });
    connect(m_pictures.get(), &PictureMaker::pictureMade, this, [this](int view) {
        m_views[size_t(view)].complained = false;
        emit pictureChanged(view);
    });
    connect(m_pictures.get(), &PictureMaker::failed, this, [this](int view, const Message& message) {
        emit pictureChanged(view);
        if (!std::exchange(m_views[size_t(view)].complained, true)) raise(Severity::Error, message);
    });
}

void Session::makeView(int view) {
    ViewState& state = m_views[size_t(view)];
    const StrategyInfo& info = firstStrategy(size_t(view)).info;
    state.slot = std::make_unique<StrategySlot>(info.id, ParameterSet(info.parameters));
    connect(state.slot.get(), &StrategySlot::chosen, this, [this, view] {
        emit strategyChosen(view);
        update();
    });
    connect(state.slot.get(), &StrategySlot::builtChanged, this, [this, view] {
        emit strategyBuilt(view);
        update();
    });
    connect(state.slot.get(), &StrategySlot::failed, this, [this, view](const Message& message) {
        Figures figures;
        figures.state = Figures::State::Failed;
        figures.failure = message;
        setFigures(view, figures);
        raise(Severity::Error, message);
    });
}

// ---- Scene

void Session::show(const OpenedScenePointer& opened) {
    m_opened = opened;
    m_hidden.assign(opened->scene->instances().size(), false);
    m_chosenNear.reset();
    m_camera = Camera{};
    m_pick.reset();
    if (m_pictures) m_pictures->forget();
    for (int view = 0; view < kMostViews; ++view)
        if (setup(view).role == Role::Frozen) m_views[size_t(view)].setup.role = Role::Linked;
    showScene(opened->scene);
    goHome();
    emit sceneChanged();
    emit hiddenChanged();
    emit buffersChanged();
    emit pickChanged();
    for (int view = 0; view < kMostViews; ++view) emit setupChanged(view);
}

void Session::showScene(const ScenePointer& scene) {
    m_scene = scene;
    m_objects.clear();
    for (uint32_t object = 0; object < m_hidden.size(); ++object)
        if (!m_hidden[object]) m_objects.push_back(object);
    if (m_upload) m_upload->setScene(scene);
    for (ViewState& view : m_views) view.slot->setScene(scene);
}

void Session::setHidden(const std::vector<bool>& hidden) {
    if (!m_opened || hidden == m_hidden || hidden.size() != m_hidden.size()) return;
    m_hidden = hidden;
    showScene(withoutInstances(m_opened->scene, hidden));
    emit hiddenChanged();
    emit buffersChanged();
    update();
}

std::optional<uint32_t> Session::instanceOf(uint32_t object) const {
    const auto place = std::lower_bound(m_objects.begin(), m_objects.end(), object);
    if (place == m_objects.end() || *place != object) return std::nullopt;
    return uint32_t(place - m_objects.begin());
}

const SceneBuffersPointer& Session::buffers(Upload upload) const {
    static const SceneBuffersPointer none;
    return m_upload ? m_upload->buffers(upload) : none;
}

const Message& Session::uploadFailure() const {
    static const Message none;
    return m_upload ? m_upload->failure() : none;
}

// ---- Cameras

double Session::aspect(int view) const {
    const Viewport size = renderSize(view);
    return size.width > 0 && size.height > 0 ? double(size.width) / size.height : 4.0 / 3.0;
}

void Session::setCamera(const Camera& camera) {
    if (!m_opened) return;
    const Camera complete = withClipPlanes(camera, m_opened->scene->boundingSphere(), m_chosenNear);
    m_atHome = false;
    if (complete == m_camera) return;
    m_camera = complete;
    emit cameraChanged();
    update();
}

void Session::setUpAxis(UpAxis up) {
    if (up == m_up) return;
    m_up = up;
    goHome();
    emit cameraChanged();
}

void Session::goHome() {
    m_chosenNear.reset();
    if (!m_opened) return;
    // The view whose shape decides is a linked one: an observer has a camera of its own.
    int view = culledBy(m_activeView);
    if (setup(view).role != Role::Linked) view = m_activeView;
    setCamera(homeCamera(*m_opened->scene, m_up, aspect(view)));
    m_atHome = true;
    placeObservers();
}

void Session::placeObservers() {
    for (int view = 0; view < kMostViews; ++view)
        if (setup(view).role == Role::Observer) observe(view, setup(view).observed);
}

void Session::frameScene() {
    if (m_scene) frame(m_scene->boundingSphere());
}

void Session::frame(const Sphere& sphere) {
    if (m_opened) setViewingCamera(m_activeView, framed(viewingCamera(m_activeView), m_up, sphere, aspect(m_activeView)));
}

void Session::setChosenNear(const std::optional<double>& distance) {
    m_chosenNear = distance;
    setCamera(m_camera);
}

Camera Session::withClipPlanesFor(int view, const Camera& camera) const {
    Sphere scene = m_opened->scene->boundingSphere();
    if (setup(view).role == Role::Linked) return withClipPlanes(camera, scene, m_chosenNear);
    // The culling camera's frustum is to be seen too.
    scene.radius = std::max(scene.radius, glm::length(cullingCamera(view).eye - scene.centre));
    return withClipPlanes(camera, scene, std::nullopt);
}

void Session::setLinked(int view) {
    ViewSetup changed = setup(view);
    changed.role = Role::Linked;
    changeSetup(view, changed);
}

void Session::observe(int view, int observed) {
    observed = culledBy(observed);
    if (observed == view) return;
    ViewSetup changed = setup(view);
    changed.role = Role::Observer;
    changed.observed = observed;
    if (m_opened)
        changed.viewing = observerCamera(cullingCamera(observed), m_opened->scene->boundingSphere(), m_up, aspect(view));
    changeSetup(view, changed);
    if (m_opened) setViewingCamera(view, changed.viewing);
}

void Session::setFrozen(int view, bool frozen) {
    if (!m_opened || frozen == (setup(view).role == Role::Frozen)) return;
    ViewSetup changed = setup(view);
    changed.culling = cullingCamera(view);
    changed.viewing = viewingCamera(view);
    changed.role = frozen ? Role::Frozen : Role::Linked;
    changeSetup(view, changed);
}

int Session::culledBy(int view) const { return setup(view).role == Role::Observer ? setup(view).observed : view; }

const Camera& Session::cullingCamera(int view) const {
    const ViewSetup& culling = setup(culledBy(view));
    return culling.role == Role::Frozen ? culling.culling : m_camera;
}

const Camera& Session::viewingCamera(int view) const { return setup(view).role == Role::Linked ? m_camera : setup(view).viewing; }

void Session::setViewingCamera(int view, const Camera& camera) {
    if (setup(view).role == Role::Linked) {
        setCamera(camera);
        return;
    }
    if (!m_opened) return;
    const Camera complete = withClipPlanesFor(view, camera);
    if (complete == setup(view).viewing) return;
    m_views[size_t(view)].setup.viewing = complete;
    emit cameraChanged();
    update();
}

// ---- Views

std::vector<int> Session::shownViews() const {
    std::vector<int> views;
    for (int view = 0; view < kMostViews; ++view)
        if (shown(view)) views.push_back(view);
    return views;
}

void Session::setViewCount(int count) {
    if (count == m_viewCount || std::find(kViewCounts.begin(), kViewCounts.end(), count) == kViewCounts.end()) return;
    m_viewCount = count;
    if (count > 1 && m_activeView >= count) setActiveView(0);
    emit viewCountChanged();
    update();
}

void Session::setActiveView(int view) {
    if (view < 0 || view >= kMostViews || view == m_activeView) return;
    m_activeView = view;
    emit activeViewChanged();
    update();
}

void Session::setSetup(int view, const ViewSetup& setup) {
    ViewSetup changed = setup;
    if (changed.role == Role::Observer) changed.observed = culledBy(changed.observed);
    if (changed.role == Role::Observer && changed.observed == view) changed.role = Role::Linked;
    changeSetup(view, changed);
}

void Session::changeSetup(int view, const ViewSetup& setup) {
    ViewState& state = m_views[size_t(view)];
    if (setup == state.setup) return;
    const bool otherCamera = setup.role != state.setup.role || !(setup.viewing == state.setup.viewing);
    state.setup = setup;
    if (setup.role == Role::Observer)
        // Who watched this one goes on to what it watches now.
        for (int other = 0; other < kMostViews; ++other)
            if (this->setup(other).role == Role::Observer && this->setup(other).observed == view) {
                m_views[size_t(other)].setup.observed = setup.observed;
                if (other == setup.observed) m_views[size_t(other)].setup.role = Role::Linked;
                emit setupChanged(other);
            }
    if (m_upload) m_upload->want(setup.upload);
    emit setupChanged(view);
    if (otherCamera) emit cameraChanged();
    update();
}

// ---- Pictures

void Session::setViewport(int view, const Viewport& size) {
    ViewState& state = m_views[size_t(view)];
    if (state.viewport == size) return;
    state.viewport = size;
    // Until the camera is moved, the scene goes on filling a window that changes its size.
    if (m_atHome && view == m_activeView && !state.setup.size) {
        goHome();
        emit camerasFollowedWindow();
    }
    update();
}

void Session::setDrawStyle(const DrawStyle& style) {
    if (style == m_style) return;
    m_style = style;
    update();
}

std::optional<ViewRequest> Session::viewRequest(int view) const {
    const Viewport size = renderSize(view);
    if (!shown(view) || !setup(view).panel.empty() || size.width < 1 || size.height < 1) return std::nullopt;
    const int culling = culledBy(view);
    const std::optional<FigureSubject> subject = this->subject(culling);
    if (!subject) return std::nullopt;
    ViewRequest request;
    request.buffers = buffers(setup(view).upload);
    request.strategy = subject->strategy;
    request.culling = subject->culling;
    request.cullingSize = subject->size;
    request.viewing = viewingCamera(view);
    request.size = size;
    request.look = setup(view).look;
    request.style = m_style;
    const Figures& known = figures(view);
    if (request.look.colouring == Colouring::Verdicts && known.states && known.subject == *subject) request.states = known.states;
    const Wipe& wipe = setup(view).wipe;
    request.wipe = wipe.mode;
    if (wipe.mode == Wipe::Mode::OtherView || wipe.mode == Wipe::Mode::Difference)
        request.other = slot(culledBy(wipe.other)).built();
    return request.complete() ? std::optional(request) : std::nullopt;
}

void Session::update() {
    if (m_pictures) m_pictures->update(m_activeView);
    updateFigures();
}

// ---- Figures

std::vector<int> Session::measuredViews() const {
    std::vector<int> views;
    for (const int view : shownViews())
        if (setup(view).panel.empty()) views.push_back(culledBy(view));
    std::sort(views.begin(), views.end());
    views.erase(std::unique(views.begin(), views.end()), views.end());
    return views;
}

std::optional<FigureSubject> Session::subject(int view) const {
    const SceneBuffersPointer& uploaded = buffers(setup(view).upload);
    const BuiltStrategyPointer& built = slot(view).built();
    Viewport size = renderSize(view);
    // A view that is not shown has the size of the one that watches it.
    for (int other = 0; other < kMostViews && !shown(view); ++other)
        if (shown(other) && culledBy(other) == view) size = renderSize(other);
    if (!uploaded || !built || built->scene != uploaded->scenePointer() || size.width < 1 || size.height < 1) return std::nullopt;
    return FigureSubject{uploaded, built, cullingCamera(view), size};
}

Figures Session::figuresWithoutMeasuring() const {
    Figures figures;
    figures.state = m_opened ? Figures::State::Stale : Figures::State::Nothing;
    if (!uploadFailure().empty()) {
        figures.state = Figures::State::Failed;
        figures.failure = uploadFailure();
    }
    return figures;
}

bool Session::figuresStand(int view) const {
    const Figures& known = m_views[size_t(view)].figures;
    // What cannot be built has no figures, and that is said until it is chosen anew.
    if (known.state == Figures::State::Failed && !slot(view).built() && m_opened && uploadFailure().empty()) return true;
    if (known.state != Figures::State::Ready && known.state != Figures::State::Failed) return false;
    const std::optional<FigureSubject> now = subject(view);
    return now && !slot(view).building() && known.subject == *now;
}

void Session::updateFigures() {
    const bool overtaken = std::any_of(m_underWay.begin(), m_underWay.end(), [this](const FigureMeter::Subject& measured) {
        return subject(measured.view) != measured.what || slot(measured.view).building();
    });
    if (overtaken) {
        m_meter->cancel();
        m_underWay.clear();
    }
    const std::vector<int> measured = measuredViews();
    for (int view = 0; view < kMostViews; ++view) {
        if (figuresStand(view)) continue;
        const Figures next = figuresWithoutMeasuring();
        if (m_views[size_t(view)].figures.state != next.state) setFigures(view, next);
        const bool begun = std::any_of(m_underWay.begin(), m_underWay.end(),
                                       [view](const FigureMeter::Subject& subject) { return subject.view == view; });
        if (!begun && std::find(measured.begin(), measured.end(), view) != measured.end()) m_rest.start();
    }
}

void Session::setFigures(int view, const Figures& figures) {
    m_views[size_t(view)].figures = figures;
    emit figuresChanged(view);
}

void Session::requestFigures() { measure(true); }

void Session::setMeasuring(bool measuring) {
    m_measuring = measuring;
    if (!m_meter) return;
    m_meter->cancel();
    m_underWay.clear();
    if (measuring) m_rest.start();
}

void Session::measure(bool asked) {
    if (!m_meter || !m_opened || !m_measuring) return;
    const bool large = m_scene->triangleCount() > kOptionalAnalysisLimit;
    std::vector<FigureMeter::Subject> subjects;
    for (const int view : measuredViews()) {
        const std::optional<FigureSubject> now = subject(view);
        const Figures& known = m_views[size_t(view)].figures;
        if (!now || slot(view).building() || (known.timed && known.subject == *now)) continue;
        if (large && !asked) {
            Figures waiting;
            waiting.state = Figures::State::OnRequest;
            if (known.state != waiting.state) setFigures(view, waiting);
            continue;
        }
        if (known.state == Figures::State::OnRequest) setFigures(view, figuresWithoutMeasuring());
        subjects.push_back({view, *now});
    }
    if (subjects.empty()) return;
    m_underWay = subjects;
    m_meter->measure(std::move(subjects));
}

bool Session::figuresSettled() const {
    for (const int view : measuredViews()) {
        const Figures& known = figures(view);
        if (known.state == Figures::State::Stale || (known.state == Figures::State::Ready && !known.timed)) return false;
    }
    return true;
}

// ---- Picking

void Session::setPick(const std::optional<Pick>& pick) {
    m_picks.invalidate();
    if (pick == m_pick) return;
    m_pick = pick;
    emit pickChanged();
}

void Session::pickAt(int view, int x, int y) {
    const std::optional<ViewRequest> request = viewRequest(view);
    if (!request) return;
    const uint64_t job = m_picks.begin();
    m_pictures->pick(*request, x, y, [this, job, request = *request](const std::optional<ViewPictureDrawer::Picked>& picked) {
        // A scene that changed meanwhile numbers its triangles in another way.
        if (!m_picks.isCurrent(job) || m_scene != request.buffers->scenePointer()) return;
        if (!picked) return setPick(std::nullopt);
        const auto instance = uint32_t(m_scene->instanceOf(picked->triangle));
        const uint32_t object = objectOf(instance);
        const uint64_t within = picked->triangle - m_scene->firstTriangle(instance);
        setPick(Pick{object, m_opened->scene->firstTriangle(object) + within, picked->point});
    });
}

}  // namespace cullscope::ui
