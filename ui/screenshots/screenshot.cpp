#include "ui/screenshots/screenshot.h"

#include <QCoreApplication>

#include "core/base/error.h"
#include "core/image/picture_file.h"
#include "ui/screenshots/screenshot_painter.h"

namespace cullscope::ui {

namespace {

constexpr double kDrawingShare = 0.7;  // fraction of the progress; painting and writing take the rest

Message pictureFailure(const std::exception& error) {
    return sentenceOf(error, QT_TRANSLATE_NOOP("core", "The picture cannot be made: %1."),
                      QT_TRANSLATE_NOOP("core", "There is no memory for this picture: choose a smaller size."));
}

/// Runs `work` and returns the sentence of the error that it throws; empty: it succeeded.
template <typename Work>
Message failureOf(const Work& work) {
    try {
        work();
        return {};
    } catch (const std::exception& error) {
        return pictureFailure(error);
    }
}

}  // namespace

struct Screenshot::Drawing {
    FramesBeside frames;  ///< of all its pictures
    std::optional<TiledPicture> current;
    std::vector<TiledPicture::Result> pictures;
    size_t stepsDone = 0, steps = 0;

    /// Draws one tile; returns false if all are drawn.
    bool drawNext(const ScreenshotPlan& plan, Renderer& renderer) {
        if (!current) {
            const ScreenshotPlan::Part& part = plan.parts[pictures.size()];
            current.emplace(part.request, part.wanted);
        }
        ++stepsDone;
        if (current->drawNext(frames, renderer)) return true;
        pictures.push_back(current->take());
        current.reset();
        return pictures.size() < plan.parts.size();
    }
};

Screenshot::Screenshot(GpuThread& gpu, ViewFramesPointer frames, ScreenshotPlan plan, std::filesystem::path path, QObject* parent)
    : QObject(parent), m_gpu(gpu), m_plan(std::move(plan)), m_path(std::move(path)), m_drawing(std::make_shared<Drawing>()) {
    m_drawing->frames = FramesBeside(std::move(frames));
    for (const ScreenshotPlan::Part& part : m_plan.parts) m_drawing->steps += TiledPicture(part.request, part.wanted).steps();
}

Screenshot::~Screenshot() {
    cancel();
    // What lives on the GPU thread ends there.
    m_gpu.run([this] { *m_drawing = Drawing(); });
}

void Screenshot::cancel() {
    m_jobs.cancel();
    m_background.cancel();
}

void Screenshot::start() {
    m_jobs.start(m_gpu, [this](GpuJobs::Step& step) { draw(step); });
}

bool Screenshot::drawNext() {
    for (const ScreenshotPlan::Part& part : m_plan.parts) m_gpu.requireHeld(part.request.buffers);
    const bool more = m_drawing->drawNext(m_plan, m_gpu.renderer());
    m_gpu.requireHeld(m_plan.parts.front().request.buffers);
    return more;
}

void Screenshot::draw(GpuJobs::Step& step) {
    bool more = false;
    const Message failure = failureOf([&] { more = drawNext(); });
    if (!failure.empty()) return step.deliver([this, failure] { emit failed(failure); });
    const double share = kDrawingShare * double(m_drawing->stepsDone) / double(m_drawing->steps);
    step.deliver([this, share] { emit progressed(share); });
    if (more) return step.again();
    step.deliver([this, pictures = std::make_shared<Pictures>(std::move(m_drawing->pictures))] { write(pictures); });
}

void Screenshot::write(const std::shared_ptr<Pictures>& pictures) {
    const auto work = [this, plan = m_plan, path = m_path, pictures](const std::stop_token& stop) -> Background::Delivery {
        const Picture picture = screenshotPicture(plan, std::move(*pictures));
        if (!stop.stop_requested()) writePicture(path, picture, plan.style.background);
        return [this, path] {
            emit progressed(1.0);
            emit done(QString::fromStdString(path.string()));
        };
    };
    m_background.start(work, [this](const std::exception& error) -> Background::Delivery {
        return [this, why = pictureFailure(error)] { emit failed(why); };
    });
}

}  // namespace cullscope::ui
