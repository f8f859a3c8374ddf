#include "ui/screenshots/screenshot.h"

#include <QCoreApplication>

#include "core/base/error.h"
#include "core/image/picture_file.h"
#include "ui/screenshots/screenshot_painter.h"

namespace cullscope::ui {

namespace {

constexpr double kDrawingShare = 0.7;  // fraction of the progress; painting and writing take the rest

/// Runs `work` and returns the sentence of the error that it throws; empty: it succeeded.
template <typename Work>
Message sentenceOf(const Work& work) {
    try {
        work();
        return {};
    } catch (const Error& error) {
        return error.message();
    } catch (const std::bad_alloc&) {
        return {QT_TRANSLATE_NOOP("core", "There is no memory for this picture: choose a smaller size."), {}};
    } catch (const std::exception& error) {
        return {QT_TRANSLATE_NOOP("core", "The picture cannot be made: %1."), {error.what()}};
    }
}

}  // namespace

struct Screenshot::Drawing {
    std::unique_ptr<Renderer> renderer;
    std::optional<TiledPicture> current;
    std::vector<TiledPicture::Result> pictures;
    size_t stepsDone = 0, steps = 0;

    /// Draws one tile; returns false if all are drawn.
    bool drawNext(const ScreenshotPlan& plan) {
        if (!renderer) renderer = std::make_unique<Renderer>();
        if (!current) {
            const ScreenshotPlan::Part& part = plan.parts[pictures.size()];
            current.emplace(part.request, part.wanted);
        }
        ++stepsDone;
        if (current->drawNext(*renderer)) return true;
        pictures.push_back(current->take());
        current.reset();
        return pictures.size() < plan.parts.size();
    }
};

Screenshot::Screenshot(GpuThread& gpu, ScreenshotPlan plan, std::filesystem::path path, QObject* parent)
    : QObject(parent), m_gpu(gpu), m_plan(std::move(plan)), m_path(std::move(path)), m_drawing(std::make_shared<Drawing>()) {
    connect(
        &gpu, &GpuThread::contextGoing, this, [drawing = m_drawing] { drawing->renderer.reset(); }, Qt::DirectConnection);
    for (const ScreenshotPlan::Part& part : m_plan.parts) m_drawing->steps += TiledPicture(part.request, part.wanted).steps();
}

Screenshot::~Screenshot() {
    cancel();
    // A running step may post one more, which then finds the job cancelled: wait for both.
    m_gpu.run([] {});
    // Destroy OpenGL objects on the GPU thread.
    m_gpu.run([this] { *m_drawing = Drawing(); });
}

void Screenshot::cancel() {
    m_jobs.invalidate();
    m_background.cancel();
}

void Screenshot::start() {
    const uint64_t job = m_jobs.begin();
    m_gpu.post([this, job] { step(job); });
}

void Screenshot::deliver(uint64_t job, std::function<void()> news) {
    QMetaObject::invokeMethod(
        this,
        [this, job, news = std::move(news)] {
            if (m_jobs.isCurrent(job)) news();
        },
        Qt::QueuedConnection);
}

bool Screenshot::drawNext() {
    for (const ScreenshotPlan::Part& part : m_plan.parts) m_gpu.requireHeld(part.request.buffers);
    const bool more = m_drawing->drawNext(m_plan);
    m_gpu.requireHeld(m_plan.parts.front().request.buffers);
    return more;
}

void Screenshot::step(uint64_t job) {
    if (!m_jobs.isCurrent(job)) return;
    bool more = false;
    const Message failure = sentenceOf([&] { more = drawNext(); });
    if (!failure.empty()) return deliver(job, [this, failure] { emit failed(failure); });
    const double share = kDrawingShare * double(m_drawing->stepsDone) / double(m_drawing->steps);
    deliver(job, [this, share] { emit progressed(share); });
    if (more) return m_gpu.post([this, job] { step(job); });
    m_drawing->renderer.reset();
    deliver(job, [this, pictures = std::make_shared<Pictures>(std::move(m_drawing->pictures))] { write(pictures); });
}

void Screenshot::write(const std::shared_ptr<Pictures>& pictures) {
    m_background.start([this, plan = m_plan, path = m_path, pictures](const std::stop_token& stop) {
        const Message failure = sentenceOf([&] {
            const Picture picture = screenshotPicture(plan, std::move(*pictures));
            if (!stop.stop_requested()) writePicture(path, picture, plan.style.background);
        });
        return [this, failure, path] {
            if (!failure.empty()) return emit failed(failure);
            emit progressed(1.0);
            emit done(QString::fromStdString(path.string()));
        };
    });
}

ScreenshotContent readScreenshot(const std::filesystem::path& path) {
    ScreenshotContent content;
    for (auto& [name, text] : readPicture(path).metadata) content.metadata.emplace(name, text);
    const auto text = [&](const char* name) {
        const auto found = content.metadata.find(name);
        return found == content.metadata.end() ? std::string() : found->second;
    };
    content.session = text("cullscope:session");
    content.options = screenshotOptionsFromText(text("cullscope:screenshot"));
    return content;
}

}  // namespace cullscope::ui
