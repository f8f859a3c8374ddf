#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "core/frame/prediction.h"
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
#include "ui/session/moving_views.h"
#include "ui/session/session_marks.h"
#include "ui/session/view_meter.h"

namespace cullscope::ui {

using NamedPartsPointer = std::shared_ptr<const NamedParts>;
using OpenedScenePointer = std::shared_ptr<const OpenedScene>;

enum class Severity { Information, Warning, Error };

/// The document of the desktop: the scene, the camera that the linked views share, the setups of all views, their pictures and
/// metrics. Does not depend on widgets. Views are numbered from 0; a view that is not shown keeps its setup.
class Session : public QObject {
    Q_OBJECT

public:
    static constexpr int kMostViews = 8;
    static constexpr std::array kViewCounts{1, 2, 4, 6, 8};

    struct Options {
        SceneSourceOptions sceneSource;
        SceneLoader::Opener opener;      ///< empty: core's openScene
        SceneUpload::Uploader uploader;  ///< empty: GpuThread::upload
        GpuThread::Options gpu;
        std::optional<Viewport> pictureSize = kUsualPictureSize;  ///< of all views at first; none: they fit the window
        TimingProtocol rounds = ViewMeter::protocol();            ///< of the views' speeds
        int restBeforeMeasuring = 200;                            ///< ms without a change, after which the views are measured
        int waitForStep = 100;  ///< ms for a step's picture, before panels show the step without it
        bool graphics = true;   ///< false: no OpenGL, for tests of the rest
    };

    /// Throws Error(OpenGl) if `options.graphics` is set and OpenGL 4.5 is not available.
    explicit Session(Options options, QObject* parent = nullptr);
    ~Session() override;

    // Scene
    void open(const QString& specification) { m_loader.open(specification); }
    /// Shows a scene that was opened already; the effect is that of open().
    void show(const OpenedScenePointer& opened);
    [[nodiscard]] SceneLoader& loader() { return m_loader; }
    /// The opened scene; null: none was opened yet.
    [[nodiscard]] const OpenedScenePointer& opened() const { return m_opened; }
    /// The scene that is shown and measured: the opened scene without its hidden objects.
    [[nodiscard]] const ScenePointer& scene() const { return m_scene; }
    /// One flag per object of the opened scene.
    [[nodiscard]] const std::vector<bool>& hidden() const { return m_hidden; }
    void setHidden(const std::vector<bool>& hidden);
    /// The object of the opened scene for an instance of scene(), and the instance for an object (none: it is hidden).
    [[nodiscard]] uint32_t objectOf(uint32_t instance) const { return m_objects[instance]; }
    [[nodiscard]] std::optional<uint32_t> instanceOf(uint32_t object) const;
    [[nodiscard]] const SceneSourceOptions& sceneSource() const { return m_sceneSource; }
    /// The uploaded scene; null: not uploaded (yet).
    [[nodiscard]] const SceneBuffersPointer& buffers(Upload upload = Upload::Vbo) const;
    /// Why the upload of the present scene failed; empty: it succeeded or is in progress.
    [[nodiscard]] const Message& uploadFailure() const;

    // The linked views' camera
    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Sets the linked camera, with near and far planes set around the scene.
    void setCamera(const Camera& camera);
    [[nodiscard]] UpAxis upAxis() const { return m_up; }
    void setUpAxis(UpAxis up);
    /// Restores the initial camera in all linked views; observers get their initial cameras too.
    void goHome();
    /// Fits the whole scene into the active view.
    void frameScene();
    /// Fits a sphere (such as that of a picked object) into the active view.
    void frame(const Sphere& sphere);
    [[nodiscard]] const std::optional<double>& chosenNear() const { return m_chosenNear; }
    void setChosenNear(const std::optional<double>& distance);
    [[nodiscard]] Angle defaultFovy() const { return Camera{}.fovy; }

    // Views
    [[nodiscard]] int viewCount() const { return m_viewCount; }
    /// `count` is one of kViewCounts. Views that come into sight are offered strategies.
    void setViewCount(int count);
    /// Gives a view whose strategy was never chosen the first one of the registry that no other shown view has and that this
    /// machine can use: eight views compare eight strategies.
    void offerStrategy(int view);
    /// Whether a view is shown. With a view count of 1 the active view is.
    [[nodiscard]] bool shown(int view) const { return m_viewCount == 1 ? view == m_activeView : view < m_viewCount; }
    [[nodiscard]] std::vector<int> shownViews() const;
    [[nodiscard]] int activeView() const { return m_activeView; }
    void setActiveView(int view);
    [[nodiscard]] StrategySlot& slot(int view) { return *m_views[size_t(view)].slot; }
    [[nodiscard]] const StrategySlot& slot(int view) const { return *m_views[size_t(view)].slot; }
    [[nodiscard]] const ViewSetup& setup(int view) const { return m_views[size_t(view)].setup; }
    /// Sets all settings of a view but its strategy. A view set to observe an observer observes what that one does.
    void setSetup(int view, const ViewSetup& setup);

    // Cameras of a view
    void setLinked(int view);
    void observe(int view, int observed);
    void setFrozen(int view, bool frozen);
    /// The view whose strategy, culling camera and verdicts this view shows: the observed view of an observer, else itself.
    [[nodiscard]] int culledBy(int view) const;
    [[nodiscard]] const Camera& cullingCamera(int view) const;
    [[nodiscard]] const Camera& viewingCamera(int view) const;
    /// Sets the shared camera for a linked view, else the view's own camera.
    void setViewingCamera(int view, const Camera& camera);
    /// The same by the user's hand: pictures of a large scene may be coarse until the hand rests.
    void moveViewingCamera(int view, const Camera& camera);

    // Pictures
    /// The size of a view in the window in device pixels; also its picture's size if that is fitted to the window.
    [[nodiscard]] Viewport viewport(int view) const { return m_views[size_t(view)].viewport; }
    void setViewport(int view, const Viewport& size);
    /// Sets the size of the pictures of views; none: they fit the window. Changes nothing and raises a warning where all views
    /// would have more than kMostPixelsAskedFor together (view_sizes.h).
    void setPictureSize(const std::vector<int>& views, const std::optional<Viewport>& size);
    [[nodiscard]] Viewport renderSize(int view) const { return setup(view).size.value_or(viewport(view)); }
    /// Pixels of a view's picture for one unit of line widths and signs: more where the picture is shown small, as in a lecture.
    void setPictureUnit(int view, double unit);
    [[nodiscard]] const DrawStyle& drawStyle() const { return m_style; }
    void setDrawStyle(const DrawStyle& style);
    /// The plane that cuts the pictures of all views; none: they show all that is drawn. Another scene has none at first.
    [[nodiscard]] const std::optional<Section>& section() const { return m_section; }
    void setSection(const std::optional<Section>& section);
    /// The request for a view's picture; none while scene, strategy or size are missing.
    [[nodiscard]] std::optional<ViewRequest> viewRequest(int view) const;
    /// The newest picture of a view; null: none yet, or the strategy is refused.
    [[nodiscard]] ViewPicturePointer picture(int view) const {
        return m_pictures && !slot(culledBy(view)).refused() ? m_pictures->picture(view) : nullptr;
    }
    [[nodiscard]] PictureMaker* pictures() { return m_pictures.get(); }
    [[nodiscard]] MovingViews* moving() { return m_moving.get(); }

    // Stepping (stepper.h)
    [[nodiscard]] const std::optional<ShownStep>& step() const { return m_step; }
    void setStep(const std::optional<ShownStep>& step);
    /// Whether a new step's picture is awaited: until it is painted, panels show the former step.
    [[nodiscard]] bool stepAwaitsPicture() const;
    /// The step of the frame that a view shows; null: it is not stepped.
    [[nodiscard]] const ShownStep* stepOf(int view) const {
        return m_step && m_step->view == culledBy(view) ? &*m_step : nullptr;
    }
    /// The open question with what is expected so far; its items are numbered as in the shown scene. While it is open, no view
    /// tells what its strategy decided: all show all triangles, and a click names what is clicked.
    [[nodiscard]] const std::optional<Prediction>& question() const { return m_question; }
    void setQuestion(const std::optional<Prediction>& question);
    /// Names in the open question what a view shows within a rectangle of its picture (y upward): triangles or objects. What is
    /// all named already is taken back. Does nothing in a question about parts.
    void nameIn(int view, const PictureTile& within);
    /// The parts that a question about parts names; null: it is about objects or triangles, or there is none.
    [[nodiscard]] const NamedPartsPointer& questionParts() const { return m_questionParts; }
    /// Opens a question about parts. `question` numbers them as `parts` does.
    void setQuestion(const Prediction& question, const NamedPartsPointer& parts);

    // Metrics
    [[nodiscard]] const ViewMetrics& figures(int view) const { return m_views[size_t(culledBy(view))].figures; }
    /// The views whose metrics the shown pictures have, in order and without duplicates. An observer has those of the observed
    /// view.
    [[nodiscard]] std::vector<int> measuredViews() const;
    /// Measures even if the scene is too large for automatic measurement.
    void requestFigures();
    /// Whether the metrics of every shown view are known, or known to be unavailable.
    [[nodiscard]] bool metricsSettled() const;
    /// Stops and resumes the measurement of the views, for instance around a timed experiment.
    void setMeasuring(bool measuring);

    // Picking
    [[nodiscard]] const std::optional<Pick>& pick() const { return m_pick; }
    /// The point that was picked before, from which the distance to the present one is measured; none: there is none, or nothing
    /// is picked now.
    [[nodiscard]] const std::optional<Vec3>& pointBefore() const { return m_pointBefore; }
    void setPick(const std::optional<Pick>& pick);
    /// Looks up what a view's picture shows at a pixel (y upward) and picks it; a pixel of the background clears the pick.
    void pickAt(int view, int x, int y);
    /// The object that a view's picture shows at a pixel (y upward); waits for the GPU thread. None: the background, or a
    /// question is open.
    [[nodiscard]] std::optional<uint32_t> objectAt(int view, int x, int y);
    /// Picks what is missing at a lost pixel of a view's picture, or near it, whether lost pixels are marked or not. No distance
    /// to what was picked before is measured.
    void pickLostAt(int view, int x, int y);

    /// The chosen group of the active view's strategy; none once a strategy was built anew, or something was picked.
    [[nodiscard]] const std::optional<ChosenGroup>& group() const { return m_group; }
    void setGroup(const std::optional<ChosenGroup>& group);
    /// The chosen group where the view culls with its strategy and is not stepped; null: there is none.
    [[nodiscard]] const ChosenGroup* groupOf(int view) const;

    // OpenGL
    /// Why this machine does not support a strategy; none: it does.
    [[nodiscard]] std::optional<Message> unavailable(const StrategyInfo& info) const;
    [[nodiscard]] GpuThread* gpu() { return m_gpu.get(); }
    [[nodiscard]] ViewMeter* meter() { return m_meter.get(); }
    /// The views' frames.
    [[nodiscard]] const ViewFramesPointer& frames() const { return m_frames; }
    /// Ends the frame that is being decided and the one that is being timed, and all to come: the session's window closes, and
    /// parts of it wait for the GPU thread one after the other.
    void endFrames();
    /// What the strategies of all views built.
    [[nodiscard]] const std::shared_ptr<StructureStore>& structures() const { return m_structures; }

    void raise(cullscope::ui::Severity severity, const Message& message) { emit messageRaised(severity, message); }
    /// Confirms that a file was written.
    void tellSaved(const QString& file) { emit fileSaved(file); }

signals:
    void sceneChanged();
    void hiddenChanged();
    void sectionChanged();
    void buffersChanged();
    /// The viewing or culling camera, or the near plane, of a view changed.
    void cameraChanged();
    /// Emitted after cameraChanged if the user did not move the cameras: initial cameras were adapted to a new window size.
    void camerasFollowedWindow();
    void viewCountChanged();
    void activeViewChanged();
    void setupChanged(int view);
    void strategyChosen(int view);
    void strategyBuilt(int view);
    void pictureChanged(int view);
    /// The metrics of a view changed. Its observers have the same metrics.
    void metricsChanged(int view);
    void stepChanged();
    void questionChanged();
    void pickChanged();
    void groupChanged();
    /// Emitted after pickChanged if the pick came from a click into this view's picture.
    void pickedInPicture(int view);
    void fileSaved(const QString& file);
    void messageRaised(cullscope::ui::Severity severity, const cullscope::Message& message);

private:
    /// What a view's frames are decided from while it stands. Keeps nothing alive: `strategy` is compared alone.
    struct Stand {
        const BuiltStrategy* strategy = nullptr;
        Camera culling;
        Viewport size;

        bool operator==(const Stand&) const = default;
    };
    struct ViewState {
        std::unique_ptr<StrategySlot> slot;
        ViewSetup setup;
        Viewport viewport{0, 0};
        double unit = 1.0;  ///< setPictureUnit
        Camera firstWatch;  ///< Observer: the viewing camera that observe() set
        ViewMetrics figures;
        uint32_t turn = 0;              ///< FrameRequest::turn
        uint32_t turns = 0;             ///< made since the view stands where it does
        std::optional<Stand> standsAt;  ///< where the view was when it came to rest
        bool complained = false;        ///< a drawing error was reported and no picture was drawn since
    };

    void makeGraphics();
    /// Has the strategies built that a shown view needs, and no others.
    void wantStrategies();
    [[nodiscard]] std::optional<ViewRequest> pictureWish(int view) const;
    void makeView(int view);
    void tellRepairs();
    void nameInQuestion(uint64_t triangle, const Vec3& point);
    void pickIn(int view, const ViewRequest& request, int x, int y);
    void limitToStep(ViewRequest& request) const;
    void showScene(const ScenePointer& scene);
    void changeSetup(int view, const ViewSetup& setup);
    /// The view whose aspect ratio determines the linked views' initial camera.
    [[nodiscard]] int homeView() const;
    void placeObservers(const std::vector<int>& views);
    [[nodiscard]] std::vector<int> observers() const;
    void followWindow(int view);
    [[nodiscard]] Camera withClipPlanesFor(int view, const Camera& camera) const;
    [[nodiscard]] double aspect(int view) const;
    [[nodiscard]] View cullingView(int view) const;
    void update();
    void updateFigures();
    void cancelFigures();  ///< ends the measurement under way; its views are not measured
    /// Whether a view's metrics still hold for its present state.
    [[nodiscard]] bool figuresStand(int view) const;
    [[nodiscard]] ViewMetrics figuresWithoutMeasuring() const;
    [[nodiscard]] std::optional<MetricsSubject> subject(int view) const;
    void setFigures(int view, const ViewMetrics& figures);
    void measure(bool asked);
    // Views that stand (session_settling.cpp)
    [[nodiscard]] std::optional<Stand> standOf(int view) const;
    void comeToRest();
    /// Asks for the next frame of each view that stands and whose shown frame is not settled; returns whether one is awaited.
    bool letSettle();
    void goOnSettling();  ///< a picture was made, or could not be
    /// Adds the views, frozen ones aside, whose metrics are known and that have the camera and size of one of the subjects.
    void addTimedViews(std::vector<ViewMeter::Subject>& subjects) const;

    SceneSourceOptions m_sceneSource;
    int m_waitForStep;
    TimingProtocol m_rounds;
    SceneLoader m_loader;
    OpenedScenePointer m_opened;
    ScenePointer m_scene;
    std::vector<bool> m_hidden;
    std::vector<uint32_t> m_objects;
    std::unique_ptr<GpuThread> m_gpu;
    std::unique_ptr<SceneUpload> m_upload;
    ViewFramesPointer m_frames = std::make_shared<ViewFrames>();
    std::shared_ptr<StructureStore> m_structures = std::make_shared<StructureStore>();
    std::unique_ptr<ViewMeter> m_meter;
    std::unique_ptr<MovingViews> m_moving;
    std::unique_ptr<PictureMaker> m_pictures;
    DrawStyle m_style;
    std::optional<Section> m_section;

    Camera m_camera;
    UpAxis m_up = UpAxis::Y;
    std::optional<UpAxis> m_chosenUp;  ///< for scenes that do not say what is up; none: what is guessed
    std::optional<double> m_chosenNear;
    Camera m_home;  ///< initial camera of the scene; while the user has not moved it, it follows the window size

    std::array<ViewState, kMostViews> m_views;
    int m_viewCount = 2;
    int m_activeView = 1;
    std::optional<Pick> m_pick;
    std::optional<Vec3> m_pointBefore;
    std::optional<ChosenGroup> m_group;
    std::optional<ShownStep> m_step;
    std::optional<Prediction> m_question;
    NamedPartsPointer m_questionParts;
    QTimer m_rest;
    std::vector<ViewMeter::Subject> m_underWay;  ///< subjects that the meter is measuring
    bool m_measuring = true;
};

}  // namespace cullscope::ui
