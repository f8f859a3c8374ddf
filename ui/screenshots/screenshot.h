#pragma once

#include <QObject>
#include <filesystem>
#include <map>

#include "ui/jobs/background.h"
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

/// What a picture's file says of the session that it shows.
struct ScreenshotContent {
    std::string session;  ///< JSON of the session's state; empty: the file was made by another program
    ScreenshotOptions options;
    std::map<std::string, std::string> metadata;  ///< all pairs, names with "cullscope:"
};

/// Throws Error(Input) where the file is no picture that can be read.
[[nodiscard]] ScreenshotContent readScreenshot(const std::filesystem::path& path);

}  // namespace cullscope::ui
