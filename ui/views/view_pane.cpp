#include "ui/views/view_pane.h"

#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kGap = 2;  // pixels between two views
constexpr int kChipInset = 8;

}  // namespace

ViewPane::ViewPane(Session& session, int view, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_view(view),
      m_header(new ViewHeader(session, view, this)),
      m_picture(new SceneView(session, view, this)),
      m_chip(new QLabel(m_picture)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_header);
    layout->addWidget(m_picture, 1);
    m_chip->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_chip->setAutoFillBackground(true);
    m_chip->setForegroundRole(QPalette::ToolTipText);
    m_chip->setBackgroundRole(QPalette::ToolTipBase);
    m_chip->setMargin(4);
    connect(&session, &Session::cameraChanged, this, &ViewPane::refreshChip);
    retranslate();
}

QString ViewPane::chipText() const {
    QStringList parts;
    const Camera& camera = m_session.camera();
    if (m_session.chosenNear()) parts << tr("near plane %1").arg(QLocale().toString(camera.nearDistance, 'g', 3));
    if (std::abs((camera.fovy - m_session.defaultFovy()).degrees()) > 0.05)
        parts << tr("field of view %1°").arg(QLocale().toString(camera.fovy.degrees(), 'f', 1));
    if (parts.isEmpty()) return {};
    return tr("%1 (Home resets)").arg(parts.join(QStringLiteral(" · ")));
}

void ViewPane::refreshChip() {
    const QString text = chipText();
    if (text == m_chip->text() && m_chip->isVisibleTo(m_picture) == !text.isEmpty()) return;
    m_chip->setText(text);
    m_chip->setVisible(!text.isEmpty());
    m_chip->adjustSize();
    m_chip->move(kChipInset, kChipInset);
}

void ViewPane::retranslate() {
    m_picture->setAccessibleName(tr("Picture of view %1").arg(viewLetter(m_view)));
    m_picture->setAccessibleDescription(tr("Arrow keys turn, plus and minus zoom, Shift with arrow keys pans, W A S D Q E fly."));
    refreshChip();
}

void ViewPane::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

ViewGrid::ViewGrid(Session& session, QWidget* parent) : QWidget(parent), m_session(session) {
    for (int view = 0; view < Session::kMostViews; ++view) {
        auto* pane = new ViewPane(session, view, this);
        connect(&pane->picture(), &SceneView::menuRequested, this, &ViewGrid::menuRequested);
        m_panes.push_back(pane);
    }
    connect(&session, &Session::viewCountChanged, this, &ViewGrid::arrange);
    arrange();
}

void ViewGrid::arrange() {
    int shown = 0;
    for (int view = 0; view < Session::kMostViews; ++view) shown += m_session.shown(view) ? 1 : 0;
    const int each = (width() - kGap * (shown - 1)) / shown;
    int x = 0;
    for (int view = 0; view < Session::kMostViews; ++view) {
        ViewPane* pane = m_panes[size_t(view)];
        pane->setVisible(m_session.shown(view));
        if (!m_session.shown(view)) continue;
        pane->setGeometry(x, 0, each, height());
        x += each + kGap;
    }
}

void ViewGrid::resizeEvent(QResizeEvent*) { arrange(); }

void ViewGrid::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), palette().color(QPalette::Mid)); }

}  // namespace cullscope::ui
