#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "core/gpu/context.h"
#include "core/scene/scene_source.h"
#include "ui/session/background.h"
#include "ui/session/figure_meter.h"
#include "ui/session/figures.h"
#include "ui/session/gpu_thread.h"
#include "ui/session/navigation.h"
#include "ui/session/scene_loader.h"
#include "ui/session/strategy_slot.h"

namespace cullscope::ui {

using OpenedScenePointer = std::shared_ptr<const OpenedScene>;

enum class Severity { Information, Warning, Error };

/// The desktop's document: the scene, the camera that the views share, what each view shows, and the figures. Knows no widget.
class Session : public QObject {
    Q_OBJECT

public:
    static constexpr int kMostViews = 2;

    struct Options {
        SceneSourceOptions sceneSource;
        SceneLoader::Opener opener;                                                    ///< empty: core's openScene
        std::function<SceneBuffersPointer(GpuThread&, const ScenePointer&)> uploader;  ///< empty: GpuThread::upload
        bool graphics = true;  ///< false: no OpenGL, for tests of the rest
    };

    /// Throws Error(OpenGl) where graphics are wanted and there is no OpenGL 4.5.
    explicit Session(Options options, QObject* parent = nullptr);
    ~Session() override;

    // Scene
    void open(const QString& specification) { m_loader.open(specification); }
    [[nodiscard]] SceneLoader& loader() { return m_loader; }
    /// Null: nothing opened yet.
    [[nodiscard]] const OpenedScenePointer& opened() const { return m_opened; }
    [[nodiscard]] const SceneBuffersPointer& buffers() const { return m_buffers; }
    /// Why OpenGL did not take the present scene; empty: it did, or it is on its way.
    [[nodiscard]] const Message& uploadFailure() const { return m_uploadFailure; }
    [[nodiscard]] const SceneSourceOptions& sceneSource() const { return m_sceneSource; }

    // Camera
    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Near and far are set around the scene.
    void setCamera(const Camera& camera);
    [[nodiscard]] UpAxis upAxis() const { return m_up; }
    void setUpAxis(UpAxis up);
    void goHome();
    void frameScene();
    [[nodiscard]] const std::optional<double>& chosenNear() const { return m_chosenNear; }
    void setChosenNear(const std::optional<double>& distance);
    [[nodiscard]] Angle defaultFovy() const { return Camera{}.fovy; }

    // Views
    [[nodiscard]] int viewCount() const { return m_viewCount; }
    void setViewCount(int count);
    /// With one view it is the active one.
    [[nodiscard]] bool shown(int view) const { return m_viewCount == kMostViews || view == m_activeView; }
    [[nodiscard]] int activeView() const { return m_activeView; }
    void setActiveView(int view);
    [[nodiscard]] StrategySlot& slot(int view) { return *m_views[size_t(view)].slot; }
    [[nodiscard]] const StrategySlot& slot(int view) const { return *m_views[size_t(view)].slot; }
    [[nodiscard]] const Figures& figures(int view) const { return m_views[size_t(view)].figures; }
    [[nodiscard]] Viewport viewport(int view) const { return m_views[size_t(view)].viewport; }
    void setViewport(int view, const Viewport& size);
    /// Measures although the scene is large.
    void requestFigures();
    /// Whether the figures of every shown view are known (or known to be unobtainable).
    [[nodiscard]] bool figuresSettled() const;

    // OpenGL
    [[nodiscard]] GpuThread* gpu() { return m_gpu.get(); }
    [[nodiscard]] FigureMeter* meter() { return m_meter.get(); }

    void raise(cullscope::ui::Severity severity, const Message& message) { emit messageRaised(severity, message); }

signals:
    void sceneChanged();
    void buffersChanged();
    void cameraChanged();
    void viewCountChanged();
    void activeViewChanged();
    void strategyChosen(int view);
    void strategyBuilt(int view);
    void figuresChanged(int view);
    void messageRaised(cullscope::ui::Severity severity, const cullscope::Message& message);

private:
    struct ViewState {
        std::unique_ptr<StrategySlot> slot;
        Viewport viewport{0, 0};
        Figures figures;
    };

    void makeViews();
    void show(const OpenedScenePointer& opened);
    void upload();
    void takeBuffers(const SceneBuffersPointer& buffers);
    void giveUpUpload(const Message& message);
    [[nodiscard]] double aspect() const;
    void makeStale();
    void setFigures(int view, const Figures& figures);
    void measure(bool asked);

    SceneSourceOptions m_sceneSource;
    SceneLoader m_loader;
    OpenedScenePointer m_opened;
    std::unique_ptr<GpuThread> m_gpu;
    std::unique_ptr<FigureMeter> m_meter;
    SceneBuffersPointer m_buffers;
    Message m_uploadFailure;
    std::function<SceneBuffersPointer(GpuThread&, const ScenePointer&)> m_uploader;
    JobNumbers m_uploads;

    Camera m_camera;
    UpAxis m_up = UpAxis::Y;
    std::optional<double> m_chosenNear;
    bool m_atHome = true;

    std::array<ViewState, kMostViews> m_views;
    int m_viewCount = kMostViews;
    int m_activeView = kMostViews - 1;
    QTimer m_rest;
};

}  // namespace cullscope::ui
