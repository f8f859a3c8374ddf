#include "ui/window/side_panel.h"

#include <QAction>
#include <QKeyEvent>
#include <QVBoxLayout>

#include "ui/look/tinted_icon.h"

namespace cullscope::ui {

namespace {

constexpr QSize kIcon{24, 24};

QToolButton* railButton(QWidget* rail) {
    auto* button = new QToolButton(rail);
    button->setAutoRaise(true);
    button->setIconSize(kIcon);
    button->setFixedSize(SidePanel::kRailWidth - 4, SidePanel::kRailWidth - 4);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

}  // namespace

SidePanel::SidePanel(QWidget* parent)
    : QWidget(parent), m_rail(new QWidget(this)), m_frame(new QFrame(this)), m_pages(new QStackedWidget(m_frame)) {
    auto* rail = new QVBoxLayout(m_rail);
    rail->setContentsMargins(2, 4, 2, 4);
    rail->setSpacing(4);
    rail->addStretch(1);
    m_title = new QLabel(m_frame);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setContentsMargins(8, 6, 8, 2);
    auto* frame = new QVBoxLayout(m_frame);
    frame->setContentsMargins(0, 0, 0, 0);
    frame->setSpacing(0);
    frame->addWidget(m_title);
    frame->addWidget(m_pages, 1);
    m_frame->setFrameShape(QFrame::StyledPanel);
    m_frame->setAutoFillBackground(true);
    m_frame->hide();
    m_frame->installEventFilter(this);
    arrange();
}

void SidePanel::addPage(QWidget* page, const QString& icon) {
    const int number = m_pages->addWidget(page);
    QToolButton* button = railButton(m_rail);
    button->setIcon(tintedIcon(icon));
    button->setCheckable(true);
    m_buttons.push_back(button);
    qobject_cast<QVBoxLayout*>(m_rail->layout())->insertWidget(number, button);
    connect(button, &QToolButton::clicked, this, [this, number](bool down) { setOpenPage(down ? number : -1); });
}

void SidePanel::addAction(QAction* action) {
    QToolButton* button = railButton(m_rail);
    button->setDefaultAction(action);
    m_rail->layout()->addWidget(button);
}

void SidePanel::setPageTitle(int page, const QString& title) {
    button(page).setToolTip(title);
    button(page).setAccessibleName(title);
    if (page == m_open) m_title->setText(title);
}

void SidePanel::setOpenPage(int page) {
    for (size_t i = 0; i < m_buttons.size(); ++i) m_buttons[i]->setChecked(int(i) == page);
    if (page == m_open) return;
    m_open = page;
    if (page >= 0) {
        m_pages->setCurrentIndex(page);
        m_title->setText(button(page).toolTip());
    }
    arrange();
    if (page >= 0 && isVisible()) m_pages->currentWidget()->setFocus(Qt::OtherFocusReason);
}

void SidePanel::arrange() {
    const bool open = m_open >= 0;
    setFixedWidth(kRailWidth + (open ? kPageWidth : 0));
    m_rail->setGeometry(0, 0, kRailWidth, height());
    m_frame->setGeometry(kRailWidth, 0, kPageWidth, height());
    m_frame->setVisible(open);
}

/// Escape closes the page, and the keyboard's focus returns to its button.
bool SidePanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && watched == m_frame) {
        button(std::max(0, m_open)).setFocus();
        setOpenPage(-1);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void SidePanel::resizeEvent(QResizeEvent*) { arrange(); }

void SidePanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_open >= 0)
        setOpenPage(-1);
    else
        QWidget::keyPressEvent(event);
}

}  // namespace cullscope::ui
