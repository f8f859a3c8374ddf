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
    connect(&m_upload, &SceneUpload::changed, this, &MovingViews::take);
}

MovingViews::~MovingViews() {
    m_work.cancel();
    m_upload.blockSignals(true);
}

void MovingViews::setScene(const ScenePointer& scene) {
    m_work.cancel();
    m_rest.stop();
    m_scene = scene;
    m_objects = m_merged = nullptr;
    m_made = nullptr;
    m_upload.setScene(nullptr);
    std::ranges::fill(m_milliseconds, 0.0);
    if (!scene || scene->triangleCount() < kLarge) return;
    const auto work = [this, scene](const std::stop_token& stop) -> Background::Delivery {
        const ScenePointer objects = coarseScene(*scene, kCoarseTriangles, Progress{nullptr, stop});
        const ScenePointer merged = mergedScene(*objects, Progress{nullptr, stop});
        return [this, objects, merged] {
            m_objects = objects;
            m_merged = merged;
            m_upload.setScene(merged);
        };
    };
    // Without a coarse scene the pictures come later; there is nothing to tell.
    m_work.start(work, [](const std::exception&) -> Background::Delivery { return [] {}; });
}

void MovingViews::take() {
    const SceneBuffersPointer& buffers = m_upload.buffers(Upload::Vbo);
    m_made = buffers && m_merged && buffers->scenePointer() == m_merged
                 ? std::make_shared<const CoarseBuffers>(CoarseBuffers{m_objects, buffers})
                 : nullptr;
    emit changed();
}

void MovingViews::move() { m_rest.start(); }

void MovingViews::made(int view, const ViewPicture& picture) {
    if (!picture.request.coarse) m_milliseconds[size_t(view)] = picture.milliseconds;
}

CoarseBuffersPointer MovingViews::coarseFor(const std::vector<int>& shown, const ScenePointer& scene) const {
    if (!moving() || !m_made || scene != m_scene) return nullptr;
    double all = 0.0;
    for (const int view : shown) all += m_milliseconds[size_t(view)];
    return all > kFollowing ? coarse() : nullptr;
}

}  // namespace cullscope::ui
