#include "ui/panels/message_bar.h"

#include <QApplication>
#include <QDesktopServices>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QStyle>
#include <QUrl>

#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kSymbol = 16;  // pixels
constexpr int kBeside = 10;  // pixels between the parts, or more

/// Whether an event shows that the user continues to work: a click or a key press.
bool goesOn(QEvent::Type type) {
    return type == QEvent::MouseButtonPress || type == QEvent::KeyPress || type == QEvent::ShortcutOverride;
}

}  // namespace

MessageBar::MessageBar(QStatusBar& bar)
    : QFrame(&bar),
      m_icon(new QLabel(this)),
      m_text(new QLabel(this)),
      m_take(new QToolButton(this)),
      m_whole(new QToolButton(this)),
      m_close(new QToolButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 1, 4, 1);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_whole);
    layout->addWidget(m_take);
    layout->addWidget(m_close);
    m_take->hide();
    connect(m_take, &QToolButton::clicked, this, [this] {
        const std::function<void()> take = m_taken;
        hide();
        take();
    });
    m_openFolder = [](const QString& folder) { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); };
    setFrameShape(QFrame::StyledPanel);
    // A click on the bar must not reach the widget below.
    setAttribute(Qt::WA_NoMousePropagation);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    connect(m_whole, &QToolButton::clicked, this, &MessageBar::showWhole);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_close->setAutoRaise(true);
    m_close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    m_end.setSingleShot(true);
    m_end.setInterval(6000);
    connect(&m_end, &QTimer::timeout, this, &QWidget::hide);
    hide();
    bar.addWidget(this, 1);
}

void MessageBar::show(Severity severity, const Message& message) {
    m_severity = severity;
    m_message = message;
    m_take->hide();
    setVisible(!message.empty());
    refresh();
    m_end.stop();
    qApp->removeEventFilter(this);
    if (severity != Severity::Information || message.empty()) return;
    m_end.start();
    qApp->installEventFilter(this);
}

void MessageBar::offer(Severity severity, const Message& message, const std::string& action, std::function<void()> take) {
    show(severity, message);
    m_action = action;
    m_taken = std::move(take);
    m_take->show();
    refresh();
}

void MessageBar::confirmSaved(const QString& file) {
    const QFileInfo saved(file);
    offer(Severity::Information, {QT_TRANSLATE_NOOP("core", "Saved %1."), {file.toStdString()}},
          QT_TRANSLATE_NOOP("core", "Open the folder"), [this, folder = saved.absolutePath()] { m_openFolder(folder); });
}

void MessageBar::refresh() {
    const QStyle::StandardPixmap symbol = m_severity == Severity::Error     ? QStyle::SP_MessageBoxCritical
                                          : m_severity == Severity::Warning ? QStyle::SP_MessageBoxWarning
                                                                            : QStyle::SP_MessageBoxInformation;
    m_icon->setPixmap(style()->standardIcon(symbol).pixmap(kSymbol, kSymbol));
    m_text->setAccessibleName(translatedText());
    m_text->setToolTip(translatedText());
    m_whole->setText(tr("All of it…"));
    m_take->setText(translated(m_action));
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(m_close->toolTip());
    fit();
}

QString MessageBar::translatedText() const { return translated(m_message); }

void MessageBar::fit() {
    const QString text = translatedText();
    const QFontMetrics metrics(m_text->font());
    const auto without = [&](const QWidget& hidden) {
        int room = width() - kSymbol - 2 * kBeside;
        for (const QWidget* button : {m_whole, m_take, m_close})
            if (button != &hidden && (button == m_whole || !button->isHidden())) room -= button->sizeHint().width() + kBeside;
        return room;
    };
    const bool all = metrics.horizontalAdvance(text) <= without(*m_whole);
    m_whole->setVisible(!all);
    m_text->setText(all ? text : metrics.elidedText(text, Qt::ElideRight, without(*this)));
}

void MessageBar::showWhole() {
    auto* box = new QMessageBox(m_severity == Severity::Error     ? QMessageBox::Critical
                                : m_severity == Severity::Warning ? QMessageBox::Warning
                                                                  : QMessageBox::Information,
                                tr("Message"), translatedText(), QMessageBox::Close, window());
    box->setTextFormat(Qt::PlainText);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fit();
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    if (m_end.isActive() && goesOn(event->type())) {
        const auto* widget = qobject_cast<const QWidget*>(watched);
        // A click on the bar itself selects its text or closes it.
        if (widget && widget->window() == window() && widget != this && !isAncestorOf(widget)) hide();
    }
    return QFrame::eventFilter(watched, event);
}

void MessageBar::hideEvent(QHideEvent* event) {
    // A spontaneous hide event comes with the window, and the bar reappears with it. Otherwise the bar was closed: stop its
    // timer.
    if (!event->spontaneous()) {
        m_end.stop();
        qApp->removeEventFilter(this);
    }
    QFrame::hideEvent(event);
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QFrame::changeEvent(event);
}

}  // namespace cullscope::ui
