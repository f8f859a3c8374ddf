#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "ui/jobs/gpu_jobs.h"
#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// Draws the views' pictures on the GPU thread, one at a time and in turns. Each picture is drawn from the request that its view
/// has when its turn comes: outdated requests are never drawn, and a view with an unchanged request is skipped. A picture spoilt
/// by a context loss is not shown; the one before stays until the scene is uploaded to the new context.
class PictureMaker : public QObject {
    Q_OBJECT

public:
    /// Returns the request that a view has now; none: the view is not shown, or its scene or strategy is not ready.
    using Wish = std::function<std::optional<ViewRequest>(int view)>;

    PictureMaker(GpuThread& gpu, int views, ViewFramesPointer frames, Wish wish, QObject* parent = nullptr);
    ~PictureMaker() override;

    /// Call it when requests may have changed. View `first` gets two turns of three while it has a request.
    void update(int first);
    /// The view's newest picture; null: none was drawn yet.
    [[nodiscard]] const ViewPicturePointer& picture(int view) const { return m_views[size_t(view)].picture; }
    /// Whether the view's picture was drawn from its present request.
    [[nodiscard]] bool isCurrent(int view) const;
    /// Whether a picture is being drawn or is still to be drawn.
    [[nodiscard]] bool busy() const;
    /// The number of pictures drawn for the view so far.
    [[nodiscard]] size_t drawn(int view) const { return m_views[size_t(view)].drawn; }
    /// Releases all pictures and the GPU memory that they hold.
    void forget();

    /// Draws a picture out of turn and waits for it. Throws what core throws, and Error(OpenGl) if the context was lost.
    [[nodiscard]] ViewPicturePointer drawNow(const ViewRequest& request);

    /// Looks up what a request's picture shows at a pixel (y upward); `found` is called here, not on the GPU thread, and not at
    /// all where the thread lost its context, another pick was asked for, or this one was cancelled.
    void pick(const ViewRequest& request, int x, int y,
              std::function<void(const std::optional<ViewPictureDrawer::Picked>&)> found);
    /// The same, waited for; none, too, where the request cannot be drawn.
    [[nodiscard]] std::optional<ViewPictureDrawer::Picked> pickNow(const ViewRequest& request, int x, int y);
    /// The same of all triangles that it shows within a rectangle (y upward).
    void pickIn(const ViewRequest& request, const PictureTile& within, std::function<void(const std::vector<uint64_t>&)> found);
    void cancelPick() { m_picks.cancel(); }

signals:
    void pictureMade(int view);
    /// A view cannot be drawn; PictureMaker tries again when its request changes.
    void failed(int view, const cullscope::Message& message);

private:
    struct ViewState {
        ViewPicturePointer picture;
        std::optional<ViewRequest> given;  ///< the newest request that was drawn, failed, or was spoilt by a context loss
        size_t drawn = 0;
    };

    void schedule();
    /// Ends a whole picture under way of a view whose wish is a coarse one by now: the user moves it.
    void endOvertaken();
    void drawNext();
    [[nodiscard]] bool wants(int view) const;
    [[nodiscard]] int nextView() const;
    void finish(int view, const ViewRequest& request, const ViewPicturePointer& picture, const Message& failure);
    void passOver(int view, const ViewRequest& request);

    GpuThread& m_gpu;
    Wish m_wish;
    std::shared_ptr<ViewPictureDrawer> m_drawer;
    std::vector<ViewState> m_views;
    int m_first = 0;
    int m_turnsOfFirst = 0;  ///< turns of m_first since another view had one
    int m_cursor = 0;        ///< the view at which the search for the next turn of the others begins
    bool m_scheduled = false;
    GpuJobs m_jobs, m_picks;
    int m_drawnView = 0;               ///< of the newest job
    bool m_drawsCoarsely = false;      ///< likewise
    std::stop_source m_stopOfDrawing;  ///< likewise
};

}  // namespace cullscope::ui
