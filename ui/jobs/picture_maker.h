#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "ui/jobs/gpu_jobs.h"
#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// Draws the views' pictures on the GPU thread, one at a time and in turns, each from what its view wants when its turn
/// comes: nothing is ever drawn for a wish that has passed, and a view whose wish has not changed is not drawn. What the loss of
/// the thread's context spoils is not shown: the picture before it stays until the scene is in the new context.
class PictureMaker : public QObject {
    Q_OBJECT

public:
    /// What a view wants to show now; nothing: it is not shown, or its scene or strategy is not ready.
    using Wish = std::function<std::optional<ViewRequest>(int view)>;

    PictureMaker(GpuThread& gpu, int views, Wish wish, QObject* parent = nullptr);
    ~PictureMaker() override;

    /// Wishes may have changed; `first` has two turns of three while it has a wish.
    void update(int first);
    /// Null: nothing drawn yet.
    [[nodiscard]] const ViewPicturePointer& picture(int view) const { return m_views[size_t(view)].picture; }
    /// Whether the view's picture is of its present wish.
    [[nodiscard]] bool isCurrent(int view) const;
    /// Whether a picture is under way or wanted.
    [[nodiscard]] bool busy() const;
    /// How many pictures of the view were drawn so far.
    [[nodiscard]] size_t drawn(int view) const { return m_views[size_t(view)].drawn; }
    /// Lets go of all pictures and of what they hold on the graphics card.
    void forget();

    /// Draws a picture out of turn and waits for it. Throws what core throws.
    [[nodiscard]] ViewPicturePointer drawNow(const ViewRequest& request);

    /// Looks up what a request's picture shows at a pixel (y upward); `found` is called here, not on the GPU thread, and not at
    /// all where the thread lost its context, another pick was asked for, or this one was cancelled.
    void pick(const ViewRequest& request, int x, int y,
              std::function<void(const std::optional<ViewPictureDrawer::Picked>&)> found);
    void cancelPick() { m_picks.cancel(); }

signals:
    void pictureMade(int view);
    /// A view cannot be drawn; it is tried again when its wish changes.
    void failed(int view, const cullscope::Message& message);

private:
    struct ViewState {
        ViewPicturePointer picture;
        std::optional<ViewRequest> given;  ///< the newest request that was drawn or refused
        size_t drawn = 0;
    };

    void schedule();
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
    int m_turnsOfFirst = 0;  ///< since another view had one
    int m_cursor = 0;        ///< where the turns of the others go on
    bool m_scheduled = false;
    GpuJobs m_jobs, m_picks;
};

}  // namespace cullscope::ui
