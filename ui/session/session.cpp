#include "ui/session/session.h"

#include <QCoreApplication>

#include "core/base/error.h"
#include "core/scene/camera_path.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

constexpr int kRestBeforeMeasuring = 200;  // ms
constexpr std::array<const char*, Session::kMostViews> kFirstStrategies{"all", "backface"};

SceneLoader::Opener openerFor(const Session::Options& options) {
    if (options.opener) return options.opener;
    return [source = options.sceneSource](const std::string& specification, const Progress& progress) {
        return openScene(specification, source, progress);
    };
}

}  // namespace

Session::Session(Options options, QObject* parent)
    : QObject(parent), m_sceneSource(options.sceneSource), m_loader(openerFor(options)) {
    m_uploader =
        options.uploader ? options.uploader : [](GpuThread& gpu, const ScenePointer& scene) { return gpu.upload(scene); };
    if (options.graphics) {
        m_gpu = std::make_unique<GpuThread>();
        m_meter = std::make_unique<FigureMeter>(*m_gpu);
        connect(m_meter.get(), &FigureMeter::measured, this, &Session::setFigures);
    }
    makeViews();
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
    if (m_meter) m_meter->cancel();
    m_uploads.invalidate();
    m_buffers = nullptr;
    if (!m_gpu) return;
    // What is still on its way here holds buffers, which must go while the GPU thread lives.
    m_gpu->run([] {});
    QCoreApplication::removePostedEvents(this);
}

void Session::makeViews() {
    for (size_t i = 0; i < m_views.size(); ++i) {
        const RegisteredStrategy& strategy = findStrategy(kFirstStrategies[i]);
        auto slot = std::make_unique<StrategySlot>(strategy.info.id, ParameterSet(strategy.info.parameters));
        const int view = int(i);
        connect(slot.get(), &StrategySlot::chosen, this, [this, view] {
            emit strategyChosen(view);
            makeStale();
        });
        connect(slot.get(), &StrategySlot::builtChanged, this, [this, view] {
            emit strategyBuilt(view);
            makeStale();
        });
        connect(slot.get(), &StrategySlot::failed, this, [this, view](const Message& message) {
            Figures figures;
            figures.state = Figures::State::Failed;
            figures.failure = message;
            setFigures(view, figures);
            raise(Severity::Error, message);
        });
        m_views[i].slot = std::move(slot);
    }
}

void Session::show(const OpenedScenePointer& opened) {
    m_opened = opened;
    m_buffers = nullptr;
    m_uploadFailure = {};
    m_chosenNear.reset();
    m_camera = Camera{};
    for (ViewState& view : m_views) view.slot->setScene(opened->scene);
    goHome();
    emit sceneChanged();
    emit buffersChanged();
    upload();
}

void Session::upload() {
    if (!m_gpu) return;
    const uint64_t job = m_uploads.begin();
    m_gpu->post([this, job, scene = m_opened->scene] {
        if (!m_uploads.isCurrent(job)) return;
        const auto hand = [this, job](std::function<void()> take) {
            QMetaObject::invokeMethod(
                this,
                [this, job, take = std::move(take)] {
                    if (m_uploads.isCurrent(job)) take();
                },
                Qt::QueuedConnection);
        };
        try {
            hand([this, buffers = m_uploader(*m_gpu, scene)] { takeBuffers(buffers); });
        } catch (const Error& error) {
            hand([this, message = error.message()] { giveUpUpload(message); });
        } catch (const std::exception& error) {
            const Message message{QT_TRANSLATE_NOOP("core", "The scene cannot be given to OpenGL: %1"), {error.what()}};
            hand([this, message] { giveUpUpload(message); });
        }
    });
}

void Session::takeBuffers(const SceneBuffersPointer& buffers) {
    m_buffers = buffers;
    emit buffersChanged();
    makeStale();
}

void Session::giveUpUpload(const Message& message) {
    m_uploadFailure = message;
    makeStale();
    raise(Severity::Error, message);
}

double Session::aspect() const {
    const Viewport& size = m_views[size_t(m_activeView)].viewport;
    return size.width > 0 && size.height > 0 ? double(size.width) / size.height : 4.0 / 3.0;
}

void Session::setCamera(const Camera& camera) {
    if (!m_opened) return;
    const Camera complete = withClipPlanes(camera, m_opened->scene->boundingSphere(), m_chosenNear);
    m_atHome = false;
    if (complete == m_camera) return;
    m_camera = complete;
    emit cameraChanged();
    makeStale();
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
    setCamera(homeCamera(*m_opened->scene, m_up, aspect()));
    m_atHome = true;
}

void Session::frameScene() {
    if (m_opened) setCamera(framed(m_camera, m_up, m_opened->scene->boundingSphere(), aspect()));
}

void Session::setChosenNear(const std::optional<double>& distance) {
    m_chosenNear = distance;
    setCamera(m_camera);
}

void Session::setViewCount(int count) {
    if (count < 1 || count > kMostViews || count == m_viewCount) return;
    m_viewCount = count;
    emit viewCountChanged();
    makeStale();
}

void Session::setActiveView(int view) {
    if (view < 0 || view >= kMostViews || view == m_activeView) return;
    m_activeView = view;
    emit activeViewChanged();
}

void Session::setViewport(int view, const Viewport& size) {
    ViewState& state = m_views[size_t(view)];
    if (state.viewport == size) return;
    state.viewport = size;
    // Until the camera is moved, the scene goes on filling a window that changes its size.
    if (m_atHome && view == m_activeView) goHome();
    makeStale();
}

void Session::makeStale() {
    if (m_meter) m_meter->cancel();
    for (int view = 0; view < kMostViews; ++view) {
        const bool failed = figures(view).state == Figures::State::Failed && !slot(view).built();
        Figures stale;
        stale.state = m_opened ? Figures::State::Stale : Figures::State::Nothing;
        if (!m_uploadFailure.empty()) {
            stale.state = Figures::State::Failed;
            stale.failure = m_uploadFailure;
        }
        if (!failed && figures(view).state != stale.state) setFigures(view, stale);
    }
    m_rest.start();
}

void Session::setFigures(int view, const Figures& figures) {
    m_views[size_t(view)].figures = figures;
    emit figuresChanged(view);
}

void Session::requestFigures() { measure(true); }

void Session::measure(bool asked) {
    if (!m_meter || !m_buffers || !m_opened) return;
    const bool large = m_opened->scene->triangleCount() > kOptionalAnalysisLimit;
    std::vector<FigureMeter::Subject> subjects;
    for (int view = 0; view < kMostViews; ++view) {
        if (!shown(view)) continue;
        const BuiltStrategyPointer& built = slot(view).built();
        const Viewport size = viewport(view);
        if (!built || slot(view).building() || size.width < 1 || size.height < 1) continue;
        Figures waiting;
        waiting.state = large && !asked ? Figures::State::OnRequest : Figures::State::Stale;
        setFigures(view, waiting);
        if (waiting.state == Figures::State::Stale) subjects.push_back({view, built, size});
    }
    if (!subjects.empty()) m_meter->measure(m_buffers, m_camera, std::move(subjects));
}

bool Session::figuresSettled() const {
    for (int view = 0; view < kMostViews; ++view)
        if (shown(view) && figures(view).state == Figures::State::Stale) return false;
    return true;
}

}  // namespace cullscope::ui
