#include "ui/panels/empty_state.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/scene/scene_files.h"

namespace cullscope::ui {

EmptyState::EmptyState(Session& session, QMenu* generate, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_title(new QLabel(this)),
      m_text(new QLabel(this)),
      m_open(new QPushButton(this)),
      m_generate(new QPushButton(this)) {
    QFont large = m_title->font();
    large.setPixelSize(24);
    m_title->setFont(large);
    m_title->setAlignment(Qt::AlignCenter);
    m_text->setAlignment(Qt::AlignCenter);
    m_text->setWordWrap(true);
    m_generate->setMenu(generate);
    connect(m_open, &QPushButton::clicked, this, &EmptyState::openRequested);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_open);
    buttons->addWidget(m_generate);
    buttons->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->addStretch();
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addSpacing(12);
    layout->addLayout(buttons);
    layout->addStretch();
    connect(&session.loader(), &SceneLoader::started, this, &EmptyState::retranslate);
    connect(&session.loader(), &SceneLoader::failed, this, &EmptyState::retranslate);
    connect(&session.loader(), &SceneLoader::cancelled, this, &EmptyState::retranslate);
    retranslate();
}

void EmptyState::retranslate() {
    const bool loading = m_session.loader().loading();
    QStringList formats;
    for (const std::string& extension : readableSceneExtensions()) formats << QString::fromStdString(extension).toUpper();
    m_title->setText(loading ? tr("Opening the scene…") : tr("Open a mesh or generate a scene"));
    m_text->setText(loading
                        ? tr("The window can be used meanwhile.")
                        : tr("Drop a file here (%1), or start from a built-in scene.").arg(formats.join(QStringLiteral(", "))));
    m_open->setText(tr("Open a file…"));
    m_generate->setText(tr("Generate"));
    m_open->setVisible(!loading);
    m_generate->setVisible(!loading);
}

void EmptyState::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
