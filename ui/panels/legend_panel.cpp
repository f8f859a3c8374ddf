#include "ui/panels/legend_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QPainter>

#include "ui/text/wording.h"
#include "ui/views/promise_marker.h"

namespace cullscope::ui {

namespace {

constexpr int kMovesUntilLook = 10;
constexpr std::array kPromises{Promise::Exact, Promise::Conservative, Promise::Approximate};

/// The shape of a promise, as over the views.
class Marker : public QWidget {
public:
    Marker(Promise promise, QWidget* parent) : QWidget(parent), m_promise(promise) { setFixedSize(14, 14); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        drawPromiseMarker(painter, QRectF(1.5, 1.5, 11, 11), m_promise, palette().color(QPalette::WindowText));
    }

private:
    Promise m_promise;
};

}  // namespace

LegendPanel::LegendPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_figures(new QLabel(this)), m_next(new QLabel(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 4, 0, 0);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    m_figures->setWordWrap(true);
    grid->addWidget(m_figures, 0, 0, 1, 2);
    int row = 1;
    for (const Promise promise : kPromises) {
        auto* label = new QLabel(this);
        label->setWordWrap(true);
        grid->addWidget(new Marker(promise, this), row, 0, Qt::AlignTop);
        grid->addWidget(label, row, 1);
        m_promises << label;
        ++row;
    }
    m_next->setWordWrap(true);
    m_next->setMargin(8);
    m_next->setAutoFillBackground(true);
    m_next->setBackgroundRole(QPalette::ToolTipBase);
    m_next->setForegroundRole(QPalette::ToolTipText);
    grid->addWidget(m_next, row, 0, 1, 2);
    connect(&session, &Session::sceneChanged, this, &LegendPanel::refresh);
    connect(&session, &Session::cameraChanged, this, [this] {
        // One object alone is either drawn or not: zooming in on it shows nothing of culling.
        const bool oneObject = m_session.opened() && m_session.opened()->scene->instances().size() < 2;
        if (++m_cameraMoves == kMovesUntilLook) advance(oneObject ? Progress::Choose : Progress::Look);
    });
    connect(&session, &Session::figuresChanged, this, [this](int view) {
        const Figures& figures = m_session.figures(view);
        const bool culled = figures.state == Figures::State::Ready && figures.consideredTriangles < figures.sceneTriangles;
        if (culled && m_progress == Progress::Look) advance(Progress::Choose);
    });
    connect(&session, &Session::strategyChosen, this, [this] { advance(Progress::Done); });
    refresh();
}

void LegendPanel::advance(Progress to) {
    if (to <= m_progress) return;
    m_progress = to;
    refresh();
}

QString LegendPanel::nextAction() const {
    if (!m_session.opened()) return tr("Next: open a mesh file, or generate a scene.");
    switch (m_progress) {
        case Progress::Turn:
            return tr("Next: drag in a picture to turn the scene.");
        case Progress::Look:
            return tr("Next: turn the wheel over the scene to zoom in until part of it lies outside the picture.");
        case Progress::Choose:
            return tr("Next: choose another strategy above and compare the figures over the pictures.");
        case Progress::Done:
            return tr("Next: press H to see all keys, or open a model of your own.");
    }
    return {};
}

void LegendPanel::refresh() {
    m_figures->setText(tr("Over each picture: speed against backface · triangles submitted · pixels missed"));
    for (int i = 0; i < m_promises.size(); ++i) {
        const Promise promise = kPromises[size_t(i)];
        m_promises[i]->setText(tr("%1: %2", "promise, its meaning").arg(promiseWord(promise), promiseSentence(promise)));
    }
    m_next->setText(nextAction());
}

void LegendPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
