#pragma once

#include <QObject>
#include <filesystem>
#include <map>

#include "ui/jobs/background.h"
#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// Makes one screenshot without blocking the window: draws the plan's pictures tile by tile on the GPU thread, with the window's
/// pictures in between, then paints and writes the file on a worker thread. Must be destroyed before the GPU thread.
class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(GpuThread& gpu, ScreenshotPlan plan, std::filesystem::path path, QObject* parent = nullptr);
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
    void step(uint64_t job);
    void deliver(uint64_t job, std::function<void()> news);
    void write(const std::shared_ptr<Pictures>& pictures);

    GpuThread& m_gpu;
    ScreenshotPlan m_plan;
    std::filesystem::path m_path;
    JobNumbers m_jobs;
    std::shared_ptr<Drawing> m_drawing;
    Background m_background;
};

/// The metadata of a picture about the session that it shows.
struct ScreenshotContent {
    std::string session;  ///< JSON of the session's state; empty: another program made the file
    ScreenshotOptions options;
    std::map<std::string, std::string> metadata;  ///< all pairs, also those whose names begin with "cullscope:"
};

/// Reads the metadata of a picture. Throws Error(Input) if the file is not a readable picture.
[[nodiscard]] ScreenshotContent readScreenshot(const std::filesystem::path& path);

}  // namespace cullscope::ui
