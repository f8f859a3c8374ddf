#pragma once

#include <QObject>
#include <filesystem>

#include "ui/jobs/background.h"
#include "ui/jobs/gpu_jobs.h"
#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// Makes one screenshot without blocking the window: draws the plan's pictures tile by tile on the GPU thread, with the window's
/// pictures in between, then paints and writes the file on a worker thread. Must be destroyed before the GPU thread.
class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(GpuThread& gpu, ViewFramesPointer frames, ScreenshotPlan plan, std::filesystem::path path,
               QObject* parent = nullptr);
    ~Screenshot() override;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    void start();
    /// Stops the screenshot: no file is written unless it is finished already, and no further signal is emitted.
    void cancel();

signals:
    /// `share` in [0, 1] of the work.
    void progressed(double share);
    void done(const QString& path);
    void failed(const cullscope::Message& message);

private:
    struct Drawing;  ///< objects that live on the GPU thread
    using Pictures = std::vector<TiledPicture::Result>;

    /// Draws one tile; returns false if it was the last one. Throws what core throws, and Error(OpenGl) if the context was lost.
    [[nodiscard]] bool drawNext();
    void draw(GpuJobs::Step& step);
    void write(const std::shared_ptr<Pictures>& pictures);

    GpuThread& m_gpu;
    ScreenshotPlan m_plan;
    std::filesystem::path m_path;
    std::shared_ptr<Drawing> m_drawing;
    Background m_background;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
