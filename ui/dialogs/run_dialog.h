#pragma once

#include <QDialog>
#include <QPushButton>
#include <functional>
#include <stop_token>

#include "core/base/progress.h"
#include "ui/jobs/background.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// A dialog that runs an experiment on a thread and an OpenGL context of its own, so that the window can be used meanwhile. One
/// experiment runs at a time; closing the dialog stops it.
class RunDialog : public QDialog {
    Q_OBJECT

public:
    ~RunDialog() override;

    [[nodiscard]] bool running() const { return m_running; }
    /// Closes the dialog and stops what is under way.
    void reject() override;

signals:
    void ended();

protected:
    enum class Measures {
        Losses,  ///< the views' figures may be measured meanwhile
        Times    ///< they wait: what is measured for them would add to these times
    };
    /// What is done with a result, on the window's thread; may be empty.
    using Result = std::function<void()>;
    /// Called on the work's thread, with a context current; reads nothing of the dialog. What it tells the progress comes to
    /// showProgress.
    using Work = std::function<Result(const Progress&)>;

    RunDialog(Session& session, Measures measures, QWidget* parent);

    /// Runs it. Then, or where it was stopped or failed, shows the state and emits ended().
    void run(Work work);
    /// A button that stops what is under way.
    void cancelBy(QPushButton* button);
    /// Calls something on the window's thread, if the work runs then. May be called on the work's thread.
    void whileRunning(std::function<void()> tell);

    /// Shows whether something runs, and the newest result.
    virtual void showState() = 0;
    virtual void showProgress(double /*share*/) {}
    /// Shows why the work failed, after showState.
    virtual void showFailure(const Message& failure) = 0;

    Session& m_session;

private:
    void end(const Message& failure);

    Measures m_measures;
    bool m_running = false;
    std::stop_source m_stop;
    Background m_work;
};

}  // namespace cullscope::ui
