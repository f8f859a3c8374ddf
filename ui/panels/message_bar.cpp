#include "ui/panels/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QStyle>

#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kInset = 8;

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_text(new QLabel(this)), m_close(new QToolButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 4, 4);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_close);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_close->setAutoRaise(true);
    m_close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    parent->installEventFilter(this);
    hide();
}

void MessageBar::show(Severity severity, const Message& message) {
    m_severity = severity;
    m_message = message;
    refresh();
    setVisible(!message.empty());
    raise();
}

void MessageBar::refresh() {
    const QStyle::StandardPixmap symbol = m_severity == Severity::Error     ? QStyle::SP_MessageBoxCritical
                                          : m_severity == Severity::Warning ? QStyle::SP_MessageBoxWarning
                                                                            : QStyle::SP_MessageBoxInformation;
    m_icon->setPixmap(style()->standardIcon(symbol).pixmap(20, 20));
    m_text->setText(translated(m_message));
    m_text->setAccessibleName(m_text->text());
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(m_close->toolTip());
    place();
}

void MessageBar::place() {
    const QSize room = parentWidget()->size() - QSize(2 * kInset, 2 * kInset);
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(room.width()) : sizeHint().height();
    setGeometry(kInset, parentWidget()->height() - kInset - height, room.width(), height);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QFrame::eventFilter(watched, event);
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QFrame::changeEvent(event);
}

}  // namespace cullscope::ui
