#include "ui/jobs/scene_loader.h"

#include <QCoreApplication>
#include <new>

#include "core/base/error.h"
#include "core/scene/absolute_files.h"

namespace cullscope::ui {

namespace {

constexpr int kProgressInterval = 50;  // ms

}  // namespace

SceneLoader::SceneLoader(Opener opener, QObject* parent) : QObject(parent), m_opener(std::move(opener)) {
    m_poll.setInterval(kProgressInterval);
    connect(&m_poll, &QTimer::timeout, this, &SceneLoader::showProgress);
}

void SceneLoader::open(const QString& specification) {
    m_specification = specification;
    m_board = std::make_shared<Board>();
    m_background.start(
        [this, text = specification.toStdString(), board = m_board](const std::stop_token& stop) {
            return run(text, board, stop);
        },
        [this, text = specification.toStdString()](const std::exception& failure) { return failureOf(text, failure); });
    m_poll.start();
    emit started(specification);
}

void SceneLoader::cancel() {
    if (!loading()) return;
    m_background.cancel();
    m_poll.stop();
    emit cancelled();
}

void SceneLoader::showProgress() {
    double share = 0.0;
    QString stage;
    {
        const std::lock_guard lock(m_board->mutex);
        share = m_board->share;
        stage = QString::fromStdString(m_board->stage);
    }
    emit progressed(share, stage);
}

Background::Delivery SceneLoader::run(const std::string& specification, const std::shared_ptr<Board>& board,
                                      const std::stop_token& stop) {
    Progress progress;
    progress.stop = stop;
    progress.report = [board](double share, std::string_view stage) {
        const std::lock_guard lock(board->mutex);
        board->share = share;
        board->stage = stage;
    };
    // First of all, because the working folder may go away while the scene is opened.
    const std::string absolute = withAbsoluteFiles(specification);
    OpenedScene opened = m_opener(specification, progress);
    if (opened.specification == specification) opened.specification = absolute;
    const auto scene = std::make_shared<const OpenedScene>(std::move(opened));
    return [this, scene] {
        m_poll.stop();
        emit loaded(scene);
    };
}

Background::Delivery SceneLoader::failureOf(const std::string& specification, const std::exception& failure) {
    Message message{QT_TRANSLATE_NOOP("core", "%1 cannot be opened: %2"), {specification, failure.what()}};
    if (const auto* error = dynamic_cast<const Error*>(&failure))
        message = error->message();
    else if (dynamic_cast<const std::bad_alloc*>(&failure))
        message = {QT_TRANSLATE_NOOP("core", "There is not enough memory to open %1. Choose a smaller model."), {specification}};
    return [this, message = std::move(message)] {
        m_poll.stop();
        emit failed(message);
    };
}

}  // namespace cullscope::ui
