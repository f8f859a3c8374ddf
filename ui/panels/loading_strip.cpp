#include "ui/panels/loading_strip.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>

#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kSteps = 1000;

}  // namespace

LoadingStrip::LoadingStrip(SceneLoader& loader, QWidget* parent)
    : QWidget(parent),
      m_loader(loader),
      m_stage(new QLabel(this)),
      m_bar(new QProgressBar(this)),
      m_cancel(new QPushButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(m_stage, 1);
    layout->addWidget(m_bar);
    layout->addWidget(m_cancel);
    m_bar->setFixedWidth(240);
    connect(m_cancel, &QPushButton::clicked, &loader, &SceneLoader::cancel);
    connect(&loader, &SceneLoader::started, this, [this] {
        refresh(0.0, {});
        show();
    });
    connect(&loader, &SceneLoader::progressed, this, &LoadingStrip::refresh);
    connect(&loader, &SceneLoader::loaded, this, &QWidget::hide);
    connect(&loader, &SceneLoader::failed, this, &QWidget::hide);
    connect(&loader, &SceneLoader::cancelled, this, &QWidget::hide);
    retranslate();
    hide();
}

void LoadingStrip::refresh(double share, const QString& stage) {
    m_share = share;
    m_stageName = stage;
    // Without a fraction yet, the range 0 to 0 makes the bar indeterminate.
    m_bar->setRange(0, share > 0.0 ? kSteps : 0);
    m_bar->setValue(int(share * kSteps));
    const QString what = QFileInfo(m_loader.specification()).fileName();
    const QString opening = tr("Opening %1").arg(what.isEmpty() ? m_loader.specification() : what);
    m_stage->setText(stage.isEmpty() ? opening
                                     : tr("%1: %2", "opening what, stage").arg(opening, translated(stage.toStdString())));
}

void LoadingStrip::retranslate() {
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Stop opening and keep the present scene"));
    m_bar->setAccessibleName(tr("Progress of opening"));
    refresh(m_share, m_stageName);
}

void LoadingStrip::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
