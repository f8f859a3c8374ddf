#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "core/gpu/context.h"
#include "core/scene/camera_moves.h"
#include "core/scene/scene_source.h"
#include "ui/jobs/background.h"
#include "ui/jobs/gpu_thread.h"
#include "ui/jobs/picture_maker.h"
#include "ui/jobs/scene_loader.h"
#include "ui/jobs/scene_upload.h"
#include "ui/jobs/strategy_slot.h"
#include "ui/jobs/view_metrics.h"
#include "ui/jobs/view_setup.h"
#include "ui/session/view_meter.h"

namespace cullscope::ui {

using OpenedScenePointer = std::shared_ptr<const OpenedScene>;

enum class Severity { Information, Warning, Error };

/// What was picked, in the numbering of the whole scene.
struct Pick {
    uint32_t object = 0;    ///< instance of the opened scene
    uint64_t triangle = 0;  ///< of the opened scene
    Vec3 point{0.0};

    bool operator==(const Pick&) const = default;
};

/// The desktop's document: the scene, the camera that the linked views share, what each view shows and how, the pictures and
/// the figures. Knows no widget. Views are numbered from 0; a view that is not shown keeps its setup.
class Session : public QObject {
    Q_OBJECT

public:
    static constexpr int kMostViews = 8;
    static constexpr std::array kViewCounts{1, 2, 4, 8};

    struct Options {
        SceneSourceOptions sceneSource;
        SceneLoader::Opener opener;      ///< empty: core's openScene
        SceneUpload::Uploader uploader;  ///< empty: GpuThread::upload
        GpuThread::Options gpu;
        bool graphics = true;  ///< false: no OpenGL, for tests of the rest
    };

    /// Throws Error(OpenGl) where graphics are wanted and there is no OpenGL 4.5.
    explicit Session(Options options, QObject* parent = nullptr);
    ~Session() override;

    // Scene
    void open(const QString& specification) { m_loader.open(specification); }
    /// Shows a scene that is there already, as `open` does once it has read one.
    void show(const OpenedScenePointer& opened);
    [[nodiscard]] SceneLoader& loader() { return m_loader; }
    /// Null: nothing opened yet.
    [[nodiscard]] const OpenedScenePointer& opened() const { return m_opened; }
    /// What is shown and measured: the opened scene less the hidden objects.
    [[nodiscard]] const ScenePointer& scene() const { return m_scene; }
    /// One flag an object of the opened scene.
    [[nodiscard]] const std::vector<bool>& hidden() const { return m_hidden; }
    void setHidden(const std::vector<bool>& hidden);
    /// The object of the opened scene that an instance of scene() is, and the other way round (none: hidden).
    [[nodiscard]] uint32_t objectOf(uint32_t instance) const { return m_objects[instance]; }
    [[nodiscard]] std::optional<uint32_t> instanceOf(uint32_t object) const;
    [[nodiscard]] const SceneSourceOptions& sceneSource() const { return m_sceneSource; }
    /// Null while it is not uploaded (yet).
    [[nodiscard]] const SceneBuffersPointer& buffers(Upload upload = Upload::Vbo) const;
    /// Why OpenGL did not take the present scene; empty: it did, or it is on its way.
    [[nodiscard]] const Message& uploadFailure() const;

    // The linked views' camera
    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Near and far are set around the scene.
    void setCamera(const Camera& camera);
    [[nodiscard]] UpAxis upAxis() const { return m_up; }
    void setUpAxis(UpAxis up);
    /// The first camera again, in all linked views; observers look anew.
    void goHome();
    /// All of the scene in the active view.
    void frameScene();
    /// A sphere (such as a picked object's) in the active view.
    void frame(const Sphere& sphere);
    [[nodiscard]] const std::optional<double>& chosenNear() const { return m_chosenNear; }
    void setChosenNear(const std::optional<double>& distance);
    [[nodiscard]] Angle defaultFovy() const { return Camera{}.fovy; }

    // Views
    [[nodiscard]] int viewCount() const { return m_viewCount; }
    /// One of kViewCounts.
    void setViewCount(int count);
    /// With one view it is the active one.
    [[nodiscard]] bool shown(int view) const { return m_viewCount == 1 ? view == m_activeView : view < m_viewCount; }
    [[nodiscard]] std::vector<int> shownViews() const;
    [[nodiscard]] int activeView() const { return m_activeView; }
    void setActiveView(int view);
    [[nodiscard]] StrategySlot& slot(int view) { return *m_views[size_t(view)].slot; }
    [[nodiscard]] const StrategySlot& slot(int view) const { return *m_views[size_t(view)].slot; }
    [[nodiscard]] const ViewSetup& setup(int view) const { return m_views[size_t(view)].setup; }
    /// Everything of a view but its strategy. An observer of an observer watches what that one watches.
    void setSetup(int view, const ViewSetup& setup);

    // Cameras of a view
    void setLinked(int view);
    void observe(int view, int observed);
    void setFrozen(int view, bool frozen);
    /// The view whose strategy, culling camera and verdicts this one shows: itself, or the one that it observes.
    [[nodiscard]] int culledBy(int view) const;
    [[nodiscard]] const Camera& cullingCamera(int view) const;
    [[nodiscard]] const Camera& viewingCamera(int view) const;
    /// The shared camera for a linked view, else its own.
    void setViewingCamera(int view, const Camera& camera);

    // Pictures
    /// The place a view has in the window, in device pixels; of its picture where that fits the window.
    [[nodiscard]] Viewport viewport(int view) const { return m_views[size_t(view)].viewport; }
    void setViewport(int view, const Viewport& size);
    [[nodiscard]] Viewport renderSize(int view) const { return setup(view).size.value_or(viewport(view)); }
    [[nodiscard]] const DrawStyle& drawStyle() const { return m_style; }
    void setDrawStyle(const DrawStyle& style);
    /// What a view wants to show now; none while scene, strategy or size are missing.
    [[nodiscard]] std::optional<ViewRequest> viewRequest(int view) const;
    /// The newest picture; null: none yet, or the strategy is refused.
    [[nodiscard]] ViewPicturePointer picture(int view) const {
        return m_pictures && !slot(culledBy(view)).refused() ? m_pictures->picture(view) : nullptr;
    }
    [[nodiscard]] PictureMaker* pictures() { return m_pictures.get(); }

    // Figures
    [[nodiscard]] const ViewMetrics& figures(int view) const { return m_views[size_t(culledBy(view))].figures; }
    /// The views whose figures the shown pictures have, in order, each once: an observer's are those of the view that it watches.
    [[nodiscard]] std::vector<int> measuredViews() const;
    /// Measures although the scene is large.
    void requestFigures();
    /// Whether the figures of every shown view are known (or known to be unobtainable).
    [[nodiscard]] bool metricsSettled() const;
    /// Stops measuring while something else is being timed.
    void setMeasuring(bool measuring);

    // Picking
    [[nodiscard]] const std::optional<Pick>& pick() const { return m_pick; }
    void setPick(const std::optional<Pick>& pick);
    /// Looks up what a view's picture shows at a pixel (y upward) and picks it; nothing there: nothing is picked.
    void pickAt(int view, int x, int y);

    // OpenGL
    /// Why this machine cannot do a strategy; nothing: it can.
    [[nodiscard]] std::optional<Message> unavailable(const StrategyInfo& info) const;
    [[nodiscard]] GpuThread* gpu() { return m_gpu.get(); }
    [[nodiscard]] ViewMeter* meter() { return m_meter.get(); }

    void raise(cullscope::ui::Severity severity, const Message& message) { emit messageRaised(severity, message); }

signals:
    void sceneChanged();
    void hiddenChanged();
    void buffersChanged();
    /// Some view's viewing or culling camera, or near plane.
    void cameraChanged();
    /// After cameraChanged: nobody moved the cameras, the first look at a scene took a new window size.
    void camerasFollowedWindow();
    void viewCountChanged();
    void activeViewChanged();
    void setupChanged(int view);
    void strategyChosen(int view);
    void strategyBuilt(int view);
    void pictureChanged(int view);
    /// A view's own figures; those of its observers are the same.
    void metricsChanged(int view);
    void pickChanged();
    /// After pickChanged, where it was a click into this view's picture that picked.
    void pickedInPicture(int view);
    void messageRaised(cullscope::ui::Severity severity, const cullscope::Message& message);

private:
    struct ViewState {
        std::unique_ptr<StrategySlot> slot;
        ViewSetup setup;
        Viewport viewport{0, 0};
        Camera firstWatch;  ///< Observer: where observe() put the camera that looks
        ViewMetrics figures;
        bool complained = false;  ///< of a picture that cannot be drawn, since the last one that could
    };

    void makeGraphics();
    void makeView(int view);
    void tellRepairs();
    void showScene(const ScenePointer& scene);
    void changeSetup(int view, const ViewSetup& setup);
    /// The view whose shape decides where the linked views' home is.
    [[nodiscard]] int homeView() const;
    void placeObservers(const std::vector<int>& views);
    [[nodiscard]] std::vector<int> observers() const;
    void followWindow(int view);
    [[nodiscard]] Camera withClipPlanesFor(int view, const Camera& camera) const;
    [[nodiscard]] double aspect(int view) const;
    void update();
    void updateFigures();
    /// Whether a view's figures are of what it is now.
    [[nodiscard]] bool figuresStand(int view) const;
    [[nodiscard]] ViewMetrics figuresWithoutMeasuring() const;
    [[nodiscard]] std::optional<MetricsSubject> subject(int view) const;
    void setFigures(int view, const ViewMetrics& figures);
    void measure(bool asked);

    SceneSourceOptions m_sceneSource;
    SceneLoader m_loader;
    OpenedScenePointer m_opened;
    ScenePointer m_scene;
    std::vector<bool> m_hidden;
    std::vector<uint32_t> m_objects;
    std::unique_ptr<GpuThread> m_gpu;
    std::unique_ptr<SceneUpload> m_upload;
    std::unique_ptr<ViewMeter> m_meter;
    std::unique_ptr<PictureMaker> m_pictures;
    DrawStyle m_style;

    Camera m_camera;
    UpAxis m_up = UpAxis::Y;
    std::optional<double> m_chosenNear;
    Camera m_home;  ///< the camera that the scene was first shown with; while it stands, it follows the window

    std::array<ViewState, kMostViews> m_views;
    int m_viewCount = 2;
    int m_activeView = 1;
    std::optional<Pick> m_pick;
    QTimer m_rest;
    std::vector<ViewMeter::Subject> m_underWay;  ///< what the meter measures now
    bool m_measuring = true;
};

}  // namespace cullscope::ui
