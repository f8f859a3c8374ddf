#include "ui/dialogs/run_dialog.h"

#include "core/base/error.h"
#include "core/gpu/context.h"

namespace cullscope::ui {

RunDialog::RunDialog(Session& session, Measures measures, QWidget* parent)
    : QDialog(parent), m_session(session), m_measures(measures) {}

RunDialog::~RunDialog() {
    m_stop.request_stop();
    if (m_running && m_measures == Measures::Times) m_session.setMeasuring(true);
}

void RunDialog::reject() {
    m_stop.request_stop();
    QDialog::reject();
}

void RunDialog::cancelBy(QPushButton* button) {
    connect(button, &QPushButton::clicked, this, [this, button] {
        m_stop.request_stop();
        button->setEnabled(false);
    });
}

void RunDialog::whileRunning(std::function<void()> tell) {
    QMetaObject::invokeMethod(this, [this, tell = std::move(tell)] {
        if (m_running) tell();
    });
}

void RunDialog::run(Work work) {
    m_running = true;
    m_stop = std::stop_source();
    if (m_measures == Measures::Times) m_session.setMeasuring(false);
    showState();
    // The destructor waits for the thread and drops what was to be delivered: this object outlives both.
    m_work.start(
        [this, work = std::move(work), stop = m_stop.get_token()](const std::stop_token&) -> Background::Delivery {
            // An OpenGL context belongs to the thread that made it.
            const HeadlessContext gl;
            const auto tell = [this](double share, std::string_view) { whileRunning([this, share] { showProgress(share); }); };
            return [this, result = work({tell, stop})] {
                if (result) result();
                end({});
            };
        },
        [this](const std::exception& failure) -> Background::Delivery {
            const auto* error = dynamic_cast<const Error*>(&failure);
            const bool stopped = error != nullptr && error->kind() == ErrorKind::Interrupted;
            const Message message =
                stopped ? Message{} : sentenceOf(failure, QT_TRANSLATE_NOOP("core", "The experiment cannot be run: %1"));
            return [this, message] { end(message); };
        });
}

void RunDialog::end(const Message& failure) {
    m_running = false;
    if (m_measures == Measures::Times) m_session.setMeasuring(true);
    showState();
    if (!failure.empty()) showFailure(failure);
    emit ended();
}

}  // namespace cullscope::ui
