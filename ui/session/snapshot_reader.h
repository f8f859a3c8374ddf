#pragma once

#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "ui/jobs/snapshot_reading.h"
#include "ui/session/session.h"

class QWidget;

namespace cullscope::ui {

/// Reads the decisions of the frame whose verdicts a view shows, the active one where no other is named: the view's recorded
/// frame (ViewFrames), which it fetches from the GPU thread whenever strategy, culling camera, render size, scene, step or pick
/// change. What panels show of it, such as the tree, the reasons and the map of the picked object, is made on a thread of this
/// reader and not in a paint event: one reading at a time, and without steps at most ten a second. Only a reading of the present
/// state is delivered. Nothing is read while none of the registered widgets is visible.
class SnapshotReader : public QObject {
    Q_OBJECT

public:
    /// `view`: always that one; none: the active one.
    explicit SnapshotReader(Session& session, QObject* parent = nullptr, std::optional<int> view = std::nullopt);

    [[nodiscard]] int view() const { return m_view.value_or(m_session.activeView()); }

    /// Registers a widget: the reader works while the widget is visible.
    void readFor(QWidget* widget);

    /// The newest reading; null: none of the present scene yet. While fresh() is false it may be of an older camera or strategy
    /// than the view's.
    [[nodiscard]] const SnapshotReadingPointer& reading() const { return m_reading; }
    [[nodiscard]] bool fresh() const;
    /// Whether one of the registered widgets is visible.
    [[nodiscard]] bool wanted() const;
    /// The picked triangle, numbered as in the shown scene; none: no triangle is picked, or its object is hidden.
    [[nodiscard]] std::optional<uint64_t> pickedTriangle() const;
    /// The picked triangle's state against the truth, at a step as the frame has it so far; none while it is not known.
    [[nodiscard]] std::optional<TriangleState> pickedState() const;
    /// The number of readings begun so far. For tests.
    [[nodiscard]] size_t begun() const { return m_begun; }

signals:
    /// reading() or fresh() changed.
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Request {
        FrameRequest frame;
        std::optional<uint64_t> triangle;
        std::optional<LogPlace> upTo;
    };

    [[nodiscard]] static SnapshotReadingPointer readingOf(const Request& request, const ViewFramePointer& frame,
                                                          const Message& failure, const SnapshotReadingPointer& known);
    [[nodiscard]] std::optional<Request> present() const;
    [[nodiscard]] bool answers(const Request& request) const;
    void check();
    void start();
    void startReading(const Request& request, const ViewFramePointer& frame, const Message& failure,
                      const SnapshotReadingPointer& known);
    [[nodiscard]] bool busy() const { return m_background.busy() || m_gpuJobs.busy(); }
    void take(const Request& request, SnapshotReadingPointer reading);

    Session& m_session;
    std::optional<int> m_view;
    std::vector<QWidget*> m_readers;
    SnapshotReadingPointer m_reading;
    bool m_wasFresh = false;
    size_t m_begun = 0;
    QTimer m_pause;
    Background m_background;
    GpuJobs m_gpuJobs;
};

}  // namespace cullscope::ui
