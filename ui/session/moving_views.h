#pragma once

#include <QObject>
#include <QTimer>
#include <array>

#include "ui/jobs/background.h"
#include "ui/jobs/scene_upload.h"
#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// Which views are drawn coarsely, because the user moves a camera and their whole pictures would not follow it. A large scene
/// has a coarse one for this, which is made beside the window after it was opened. After a short rest the views are whole again.
/// Nothing is counted or measured of a coarse picture.
class MovingViews : public QObject {
    Q_OBJECT

public:
    /// Scenes of fewer triangles follow as they are.
    static constexpr uint64_t kLarge = 400'000;
    static constexpr uint64_t kCoarseTriangles = 60'000;
    /// A whole picture of all shown views may take so long, in ms, before they are drawn coarsely.
    static constexpr double kFollowing = 60.0;

    /// `rest`: ms without a move, after which the views are whole again.
    MovingViews(GpuThread& gpu, int views, int rest, QObject* parent = nullptr);
    ~MovingViews() override;

    void setScene(const ScenePointer& scene);
    /// The user moves a camera.
    void move();
    [[nodiscard]] bool moving() const { return m_rest.isActive(); }
    /// A view's new picture: how long a whole one takes is remembered.
    void made(int view, const ViewPicture& picture);
    /// The coarse scene with which a picture is to be drawn now; null: the scene itself. `shown`: the views that are drawn.
    [[nodiscard]] CoarseBuffersPointer coarseFor(const std::vector<int>& shown, const ScenePointer& scene) const;
    /// The same once the views move, whether they do or not. For tests.
    [[nodiscard]] const CoarseBuffersPointer& coarse() const { return m_made; }

signals:
    /// The views rest, or there is a coarse scene now.
    void changed();

private:
    SceneUpload m_upload;
    Background m_work;
    void take();

    ScenePointer m_scene;
    ScenePointer m_objects, m_merged;    ///< the coarse scene, and the same in one mesh
    CoarseBuffersPointer m_made;         ///< both, once the mesh is uploaded
    std::vector<double> m_milliseconds;  ///< by view: of its last whole picture; 0: none was drawn yet
    QTimer m_rest;
};

}  // namespace cullscope::ui
