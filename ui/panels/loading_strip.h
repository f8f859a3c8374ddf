#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "ui/jobs/scene_loader.h"

namespace cullscope::ui {

/// Shows the scene that is being opened, its progress and a cancel button; hidden while no scene is being opened.
class LoadingStrip : public QWidget {
    Q_OBJECT

public:
    explicit LoadingStrip(SceneLoader& loader, QWidget* parent = nullptr);

    [[nodiscard]] QPushButton& cancelButton() { return *m_cancel; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh(double share, const QString& stage);
    void retranslate();

    SceneLoader& m_loader;
    QLabel* m_stage;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
    double m_share = 0.0;
    QString m_stageName;
};

}  // namespace cullscope::ui
