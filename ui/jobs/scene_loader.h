#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "core/base/message.h"
#include "core/scene/scene_source.h"
#include "ui/jobs/background.h"

namespace cullscope::ui {

/// Opens scenes in the background, one at a time; a newer request replaces an older one.
class SceneLoader : public QObject {
    Q_OBJECT

public:
    /// Function that opens a scene: core's openScene, or a slower one in a test.
    using Opener = std::function<OpenedScene(const std::string& specification, const Progress& progress)>;

    explicit SceneLoader(Opener opener, QObject* parent = nullptr);

    /// Files of the specification are named by absolute paths from now on: in the opened scene's specification, so that nothing
    /// that is done with it later depends on the working folder.
    void open(const QString& specification);
    /// Stops the loading: `loading` is false at once, and the worker thread ends within 100 ms.
    void cancel();
    [[nodiscard]] bool loading() const { return m_background.busy(); }
    [[nodiscard]] const QString& specification() const { return m_specification; }

signals:
    void started(const QString& specification);
    /// `share` in [0, 1]; `stage` is one of core's English names. At most 20 times a second.
    void progressed(double share, const QString& stage);
    void loaded(const std::shared_ptr<const cullscope::OpenedScene>& scene);
    void failed(const cullscope::Message& message);
    void cancelled();

private:
    /// Filled by the worker thread, read by the timer.
    struct Board {
        std::mutex mutex;
        double share = 0.0;
        std::string stage;
    };

    void showProgress();
    Background::Delivery run(const std::string& specification, const std::shared_ptr<Board>& board, const std::stop_token& stop);
    Background::Delivery failureOf(const std::string& specification, const std::exception& failure);

    Opener m_opener;
    Background m_background;
    QTimer m_poll;
    std::shared_ptr<Board> m_board;
    QString m_specification;
};

}  // namespace cullscope::ui
