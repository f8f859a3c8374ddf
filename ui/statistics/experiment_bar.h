#pragma once

#include <QComboBox>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "core/base/message.h"
#include "core/experiments/sweeps.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene.h"

namespace cullscope::ui {

/// The user's settings of an experiment, besides its strategies.
struct ExperimentSettings {
    std::string path;                 ///< its name; of a file, the file
    std::optional<CameraPath> poses;  ///< of a path that is known; none: a built-in one, which may take seconds to make
    Viewport size;
    int repetitions = 0;                 ///< of each frame; 0: until the median is steady
    std::vector<ParameterSweep> sweeps;  ///< sweeps to measure; empty: the shown views' strategies
};

/// Sets up, starts and cancels an experiment: camera path, picture size, repetitions, and what is measured: the shown views'
/// strategies or predefined parameter sweeps.
class ExperimentBar : public QWidget {
    Q_OBJECT

public:
    explicit ExperimentBar(QWidget* parent = nullptr);

    /// Sets the scene; null: no experiment can be started.
    void setScene(ScenePointer scene);
    /// Sets the size that the entry "as the view" stands for.
    void setCurrentSize(const Viewport& size);
    /// Offers a path that the user recorded; none withdraws it.
    void setRecordedPath(std::optional<CameraPath> path);
    /// Reads a path file and chooses it. An invalid file emits `failed` and changes nothing.
    void openPath(const QString& file);
    void setRunning(bool running);
    void setProgress(double share, const QString& stage);

    /// Emits `startRequested`.
    void start(const std::vector<ParameterSweep>& sweeps = {});
    /// The menu of parameter sweeps: all of them, then each one.
    [[nodiscard]] QMenu& sweeps() { return *m_sweeps; }

signals:
    void startRequested(const cullscope::ui::ExperimentSettings& settings);
    void cancelRequested();
    void failed(const cullscope::Message& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fillPaths();
    void choosePath(int row);
    void setUpSizes();
    void setUpSweeps();
    void refresh();
    void retranslate();
    void choosePathFor(ExperimentSettings& settings) const;

    ScenePointer m_scene;
    Viewport m_currentSize;
    std::optional<CameraPath> m_recorded;
    std::optional<CameraPath> m_opened;
    QComboBox* m_path;
    QSpinBox* m_poses;
    QComboBox* m_size;
    QSpinBox* m_repetitions;
    QPushButton* m_start;
    QToolButton* m_sweep;
    QMenu* m_sweeps;
    QProgressBar* m_progress;
    int m_chosen = 0;           ///< row of m_path, never that of "Open a path file…"
    bool m_pathChosen = false;  ///< the user has chosen the path
    bool m_running = false;
};

}  // namespace cullscope::ui
