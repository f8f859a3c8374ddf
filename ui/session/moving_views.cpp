#include "ui/session/moving_views.h"

#include <algorithm>

#include "core/base/progress.h"
#include "core/scene/coarse_scene.h"

namespace cullscope::ui {

MovingViews::MovingViews(GpuThread& gpu, int views, int rest, QObject* parent)
    : QObject(parent), m_upload(gpu, {}), m_milliseconds(size_t(views), 0.0) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(rest);
    connect(&m_rest, &QTimer::timeout, this, &MovingViews::changed);
    connect(&m_upload, &SceneUpload::changed, this, &MovingViews::changed);
}

MovingViews::~MovingViews() {
    m_work.cancel();
    m_upload.blockSignals(true);
}

void MovingViews::setScene(const ScenePointer& scene) {
    m_work.cancel();
    m_rest.stop();
    m_scene = scene;
    m_coarse = nullptr;
    m_upload.setScene(nullptr);
    std::ranges::fill(m_milliseconds, 0.0);
    if (!scene || scene->triangleCount() < kLarge) return;
    const auto work = [this, scene](const std::stop_token& stop) -> Background::Delivery {
        const ScenePointer coarse = coarseScene(*scene, kCoarseTriangles, Progress{nullptr, stop});
        return [this, coarse] {
            m_coarse = coarse;
            m_upload.setScene(coarse);
        };
    };
    // Without a coarse scene the pictures come later; there is nothing to tell.
    m_work.start(work, [](const std::exception&) -> Background::Delivery { return [] {}; });
}

void MovingViews::move() { m_rest.start(); }

void MovingViews::made(int view, const ViewPicture& picture) {
    if (!picture.request.coarse) m_milliseconds[size_t(view)] = picture.milliseconds;
}

SceneBuffersPointer MovingViews::coarseFor(const std::vector<int>& shown, const ScenePointer& scene) const {
    if (!moving() || !coarse() || coarse()->scenePointer() != m_coarse || scene != m_scene) return nullptr;
    double all = 0.0;
    for (const int view : shown) all += m_milliseconds[size_t(view)];
    return all > kFollowing ? coarse() : nullptr;
}

}  // namespace cullscope::ui
