#pragma once

#include <QObject>
#include <filesystem>

#include "ui/jobs/background.h"
#include "ui/jobs/gpu_jobs.h"
#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// Makes one screenshot beside the window: draws the plan's pictures tile by tile on the GPU thread, with the window's pictures
/// in between, then paints and writes the file on a thread of its own. Lives no longer than the GPU thread.
class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(GpuThread& gpu, ScreenshotPlan plan, std::filesystem::path path, QObject* parent = nullptr);
    ~Screenshot() override;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    void start();
    /// Nothing is written any more, unless the file is finished already; no further signal comes.
    void cancel();

signals:
    /// The finished share.
    void progressed(double share);
    void done(const QString& path);
    void failed(const cullscope::Message& message);

private:
    struct Drawing;  ///< what lives on the GPU thread
    using Pictures = std::vector<TiledPicture::Result>;

    /// Draws one tile; false: that was the last. Throws what core throws, and Error(OpenGl) where the context was lost.
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
