#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <set>

#include "core/frame/frame_stepper.h"
#include "ui/jobs/gpu_jobs.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Steps through the frame of one view: reads it with its decisions, and tells the session how far its replay goes. Where the
/// frame changes, as by a move of the camera, the new one is stepped at the same share of its log. The opening of another scene
/// ends it.
class Stepper : public QObject {
    Q_OBJECT

public:
    static constexpr double kMostSpeed = 1'000.0;  ///< steps a second

    explicit Stepper(Session& session, QObject* parent = nullptr);

    /// Steps the view whose culling the active view shows, from the start of its frame.
    void start();
    /// The same, from a place in its frame; in a longer or shorter one from the same share of it.
    void startAt(const LogPlace& place);
    /// Shows the whole frame again.
    void stop();
    /// Whether a view is stepped, or its frame is being read for it.
    [[nodiscard]] bool active() const { return m_view >= 0; }
    [[nodiscard]] int view() const { return m_view; }
    /// Null until the frame was read.
    [[nodiscard]] const FrameStepper* place() const { return m_stepper ? &*m_stepper : nullptr; }
    /// Why the frame could not be read; empty: it was, or is being read.
    [[nodiscard]] const Message& failure() const { return m_failure; }

    void forward();
    void back();
    void jump(size_t step);
    void toEnd();
    /// Goes to the next, or the last, step with an entry of a breakpoint's kind; without breakpoints to the end, or the start.
    void toBreakpoint(bool onwards);

    /// Plays until the end or a breakpoint, from the start where it stands at the end. Where pictures take longer than steps,
    /// some steps are not shown.
    void play(bool on);
    [[nodiscard]] bool playing() const { return m_timer.isActive(); }
    void setSpeed(double stepsPerSecond);
    [[nodiscard]] double speed() const { return m_speed; }

    void setBreakpoints(const std::set<EntryKind>& kinds);
    [[nodiscard]] const std::set<EntryKind>& breakpoints() const { return m_breakpoints; }

    /// The subject and the words of the entry in hand, in the user's language.
    [[nodiscard]] QString sentence() const;

signals:
    void changed();

private:
    [[nodiscard]] std::optional<FrameRequest> wanted() const;
    void check();
    void read(const FrameRequest& request);
    void take(const ViewFramePointer& frame);
    void advance();
    void show();

    Session& m_session;
    int m_view = -1;
    ViewFramePointer m_frame;
    std::optional<FrameRequest> m_reading;  ///< under way
    std::optional<FrameStepper> m_stepper;
    std::optional<LogPlace> m_begin;  ///< where startAt() begins, until the user goes on from there
    StructureSnapshot m_snapshot;
    Message m_failure;
    std::set<EntryKind> m_breakpoints;
    double m_speed = 4.0;
    QTimer m_timer;
    QElapsedTimer m_clock;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
