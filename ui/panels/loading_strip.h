#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "ui/jobs/scene_loader.h"

namespace cullscope::ui {

/// What is being opened, how far it is, and a button that stops it; hidden while nothing is.
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
