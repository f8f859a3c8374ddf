#include "ui/session/session.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/scene/camera_path.h"
#include "core/scene/hidden.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

constexpr int kRestOfHand = 150;  // ms; shorter than the rest before measuring

SceneLoader::Opener openerFor(const Session::Options& options) {
    if (options.opener) return options.opener;
    return [source = options.sceneSource](const std::string& specification, const Progress& progress) {
        return openScene(specification, source, progress);
    };
}

/// The strategy of a view at the start. The first views have the baselines; the others take those that this machine
/// supports in turn, so that eight views compare eight strategies if there are that many.
const StrategyInfo& firstStrategy(size_t view, const Session& session) {
    if (const std::vector<const StrategyInfo*> first = baselines(); view < first.size()) return *first[view];
    std::vector<const StrategyInfo*> usable;
    for (const RegisteredStrategy& strategy : strategies())
        if (!session.unavailable(strategy.info)) usable.push_back(&strategy.info);
    return *usable[view % usable.size()];
}

}  // namespace

Session::Session(Options options, QObject* parent)
    : QObject(parent),
      m_sceneSource(options.sceneSource),
      m_waitForStep(options.waitForStep),
      m_rounds(options.rounds),
      m_loader(openerFor(options)) {
    if (options.graphics) {
        m_gpu = std::make_unique<GpuThread>(options.gpu);
        m_upload = std::make_unique<SceneUpload>(*m_gpu, options.uploader);
        makeGraphics();
    }
    for (int view = 0; view < kMostViews; ++view) {
        m_views[size_t(view)].setup.size = options.pictureSize;
        makeView(view);
    }
    wantStrategies();
    m_rest.setSingleShot(true);
    m_rest.setInterval(options.restBeforeMeasuring);
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
    // First, for whatever ends below waits for the GPU thread.
    endFrames();
    m_step.reset();
    for (ViewState& view : m_views) view.figures = {};
    // Finish work and deliveries of the GPU thread while that thread exists.
    m_pictures = nullptr;
    m_moving = nullptr;
    m_meter = nullptr;
    m_upload = nullptr;
    if (m_gpu) m_gpu->run([] {});
    QCoreApplication::removePostedEvents(this);
}

void Session::endFrames() {
    m_frames->stop();
    cancelFigures();
}

void Session::makeGraphics() {
    m_meter = std::make_unique<ViewMeter>(*m_gpu, m_frames, m_structures, m_rounds);
    m_pictures = std::make_unique<PictureMaker>(*m_gpu, kMostViews, m_frames, [this](int view) { return pictureWish(view); });
    m_moving = std::make_unique<MovingViews>(*m_gpu, kMostViews, kRestOfHand);
    connect(m_moving.get(), &MovingViews::changed, this, &Session::update);
    connect(m_upload.get(), &SceneUpload::changed, this, [this] {
        emit buffersChanged();
        update();
    });
    connect(m_upload.get(), &SceneUpload::renewed, this,
            [this](const SceneBuffersPointer& before, const SceneBuffersPointer& now) {
                // Complete metrics do not depend on the context; incomplete ones are measured again.
                for (ViewState& view : m_views)
                    if (view.figures.timed && view.figures.subject.buffers == before) view.figures.subject.buffers = now;
            });
    connect(m_gpu.get(), &GpuThread::contextLost, this,
            [this](bool replaced) { raise(replaced ? Severity::Warning : Severity::Error, lossMessage(replaced)); });
    connect(m_upload.get(), &SceneUpload::failed, this, [this](const Message& message) { raise(Severity::Error, message); });
    connect(m_meter.get(), &ViewMeter::measured, this, [this](int view, const ViewMetrics& figures) {
        if (figures.timed || figures.state == ViewMetrics::State::Failed)
            std::erase_if(m_underWay, [view](const ViewMeter::Subject& subject) { return subject.view == view; });
        setFigures(view, figures);
        update();  // verdicts against the truth may be on show
    });
    connect(m_pictures.get(), &PictureMaker::pictureMade, this, [this](int view) {
        m_views[size_t(view)].complained = false;
        m_moving->made(view, *m_pictures->picture(view));
        emit pictureChanged(view);
        goOnSettling();
    });
    connect(m_pictures.get(), &PictureMaker::failed, this, [this](int view, const Message& message) {
        emit pictureChanged(view);
        if (!std::exchange(m_views[size_t(view)].complained, true)) raise(Severity::Error, message);
        goOnSettling();
    });
}

void Session::makeView(int view) {
    ViewState& state = m_views[size_t(view)];
    const StrategyInfo& info = firstStrategy(size_t(view), *this);
    state.slot = std::make_unique<StrategySlot>(
        info.id, ParameterSet(info.parameters), [this](const StrategyInfo& chosen) { return unavailable(chosen); }, m_structures);
    connect(state.slot.get(), &StrategySlot::chosen, this, [this, view] {
        // A frame of the former strategy may take minutes.
        m_frames->interrupt(view);
        if (std::ranges::find(m_underWay, view, &ViewMeter::Subject::view) != m_underWay.end()) cancelFigures();
        emit strategyChosen(view);
        update();
    });
    connect(state.slot.get(), &StrategySlot::builtChanged, this, [this, view] {
        // A frame of the former strategy may have been waiting, or begun, since the new one was chosen.
        m_frames->want(view, slot(view).built());
        // A group of what was built before is none of what is built now.
        if (m_group && std::ranges::none_of(m_views, [this](const ViewState& each) {
                return each.slot && each.slot->built() == m_group->strategy;
            }))
            setGroup(std::nullopt);
        if (m_gpu) m_gpu->post([frames = m_frames, view, built = slot(view).built()] { frames->forget(view, built); });
        emit strategyBuilt(view);
        update();
    });
    connect(state.slot.get(), &StrategySlot::failed, this, [this, view](const Message& message) {
        ViewMetrics figures;
        figures.state = ViewMetrics::State::Failed;
        figures.failure = message;
        setFigures(view, figures);
        raise(Severity::Error, message);
    });
}

std::optional<Message> Session::unavailable(const StrategyInfo& info) const {
    return m_gpu ? cullscope::unavailable(info, m_gpu->info()) : std::nullopt;
}

// ---- Scene

/// Reports repairs that lost data at once; the scene panel lists all sentences.
void Session::tellRepairs() {
    if (!m_opened->report) return;
    const LoadReport& report = *m_opened->report;
    if (report.degenerateFaces + report.duplicateFaces + report.outOfRangeFaces + report.nonFiniteVertices == 0 &&
        report.remarks.empty())
        return;
    const auto count = [](size_t number) { return std::to_string(number); };
    raise(Severity::Warning,
          {QT_TRANSLATE_NOOP("core",
                             "%1 was repaired. Dropped faces: degenerate %2, duplicate %3, out of range %4; vertices that are no "
                             "numbers: %5; other remarks: %6. The Scene panel tells all."),
           {m_opened->scene->name(), count(report.degenerateFaces), count(report.duplicateFaces), count(report.outOfRangeFaces),
            count(report.nonFiniteVertices), count(report.remarks.size())}});
}

void Session::show(const OpenedScenePointer& opened) {
    m_opened = opened;
    m_hidden.assign(opened->scene->instances().size(), false);
    m_up = opened->scene->remarks().up.value_or(m_chosenUp.value_or(opened->scene->upAxis()));
    m_chosenNear.reset();
    setSection(std::nullopt);
    m_camera = Camera{};
    m_pick.reset();
    m_pointBefore.reset();
    setStep(std::nullopt);
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
    tellRepairs();
}

void Session::showScene(const ScenePointer& scene) {
    m_scene = scene;
    setGroup(std::nullopt);
    m_frames->interrupt(std::nullopt);
    cancelFigures();
    if (m_meter) m_meter->leaveOthers(scene);
    m_objects.clear();
    for (uint32_t object = 0; object < m_hidden.size(); ++object)
        if (!m_hidden[object]) m_objects.push_back(object);
    if (m_upload) m_upload->setScene(scene);
    if (m_moving) m_moving->setScene(scene);
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

// ---- Views

std::vector<int> Session::shownViews() const {
    std::vector<int> views;
    for (int view = 0; view < kMostViews; ++view)
        if (shown(view)) views.push_back(view);
    return views;
}

void Session::wantStrategies() {
    std::array<bool, kMostViews> wanted{};
    for (const int view : shownViews()) {
        wanted[size_t(view)] = wanted[size_t(culledBy(view))] = true;
        const Wipe& wipe = setup(view).wipe;
        if (wipe.mode == Wipe::Mode::OtherView || wipe.mode == Wipe::Mode::Difference)
            wanted[size_t(culledBy(wipe.other))] = true;
    }
    for (int view = 0; view < kMostViews; ++view) slot(view).setWanted(wanted[size_t(view)]);
}

void Session::setViewCount(int count) {
    if (count == m_viewCount || std::find(kViewCounts.begin(), kViewCounts.end(), count) == kViewCounts.end()) return;
    const std::vector<int> before = shownViews();
    m_viewCount = count;
    if (count > 1 && m_activeView >= count) setActiveView(0);
    for (const int view : shownViews())
        if (std::ranges::find(before, view) == before.end()) offerStrategy(view);
    wantStrategies();
    emit viewCountChanged();
    update();
}

void Session::offerStrategy(int view) {
    if (slot(view).everChosen()) return;
    std::set<std::string> taken;
    for (const int other : shownViews())
        if (other < view || slot(other).everChosen()) taken.insert({slot(other).id(), slot(culledBy(other)).id()});
    for (const RegisteredStrategy& strategy : strategies())
        if (!taken.contains(strategy.info.id) && !unavailable(strategy.info)) return slot(view).choose(strategy.info.id);
}

void Session::setActiveView(int view) {
    if (view < 0 || view >= kMostViews || view == m_activeView) return;
    m_activeView = view;
    wantStrategies();
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
        // Views that observed this view now observe the view that it observes.
        for (int other = 0; other < kMostViews; ++other)
            if (this->setup(other).role == Role::Observer && this->setup(other).observed == view) {
                m_views[size_t(other)].setup.observed = setup.observed;
                if (other == setup.observed) m_views[size_t(other)].setup.role = Role::Linked;
                emit setupChanged(other);
            }
    if (m_upload) m_upload->want(setup.upload);
    wantStrategies();
    emit setupChanged(view);
    if (otherCamera) emit cameraChanged();
    update();
}

void Session::update() {
    if (m_pictures) m_pictures->update(m_activeView);
    updateFigures();
}

}  // namespace cullscope::ui
