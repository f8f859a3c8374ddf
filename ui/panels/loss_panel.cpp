#include "ui/panels/loss_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>

#include "core/measure/accuracy.h"
#include "ui/models/metrics_words.h"
#include "ui/session/object_pick.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// The text for a view without missed pixels: what this result shows and what it does not.
QString nothingLost(const Accuracy& accuracy) {
    if (accuracy.coveredPixels == 0) return LossPanel::tr("Nothing of the scene is in this view: there is nothing to lose.");
    const QString covered = countText(accuracy.coveredPixels);
    return LossPanel::tr(
               "0 of %1 covered pixels lost in this view. One view cannot show a loss rarer than about 3 in %1 (< %2 %).")
        .arg(covered, QLocale().toString(300.0 / double(accuracy.coveredPixels), 'g', 2));
}

QString lossOf(const ViewMetrics& figures) {
    const Accuracy& accuracy = figures.accuracy;
    const double share = double(figures.lostPixels()) / double(std::max<uint64_t>(1, accuracy.coveredPixels));
    return LossPanel::tr(
               "%1 of %2 covered pixels lost in this view (%3 %). Holes: %4, pixels of the largest: %5. N shows the next one.",
               "numbers of pixels")
        .arg(countText(figures.lostPixels()), countText(accuracy.coveredPixels), percentText(share),
             countText(figures.holes.size()), countText(accuracy.largestHolePixels));
}

}  // namespace

LossPanel::LossPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(new LossModel(this)),
      m_summary(new QLabel(this)),
      m_measure(new QPushButton(this)),
      m_view(new LongListView(this)) {
    m_summary->setWordWrap(true);
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->header()->setSectionResizeMode(LossModel::Name, QHeaderView::Stretch);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 0);
    layout->addWidget(m_summary);
    layout->addWidget(m_measure, 0, Qt::AlignLeft);
    layout->addWidget(m_view, 1);
    layout->addStretch(0);
    connect(m_view, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (const auto object = objectAt(index)) pickLoss(m_session, *object);
    });
    connect(m_view, &QTreeView::activated, this, &LossPanel::goTo);
    connect(m_measure, &QPushButton::clicked, &session, &Session::requestFigures);
    connect(&session, &Session::metricsChanged, this, &LossPanel::refresh);
    for (const auto signal : {&Session::activeViewChanged, &Session::sceneChanged, &Session::hiddenChanged})
        connect(&session, signal, this, &LossPanel::refresh);
    connect(&session, &Session::setupChanged, this, &LossPanel::refresh);
    refresh();
}

QString LossPanel::summary() const {
    const ViewMetrics& figures = this->figures();
    switch (figures.state) {
        case ViewMetrics::State::Nothing:
            return tr("There is no scene.");
        case ViewMetrics::State::Stale:
            return tr("The view changed: what it lost is being counted…");
        case ViewMetrics::State::OnRequest:
            return tr("The scene is large: what the view lost is counted when you ask for it.");
        case ViewMetrics::State::Failed:
            return translated(figures.failure);
        case ViewMetrics::State::Ready:
            break;
    }
    const QString lost = figures.lostPixels() == 0 ? nothingLost(figures.accuracy) : lossOf(figures);
    const QString explained = snappedSentence(figures);
    return explained.isEmpty() ? lost : lost + QLatin1Char('\n') + explained;
}

void LossPanel::refresh() {
    const ViewMetrics& figures = this->figures();
    m_view->setAccessibleName(tr("Objects that lost pixels"));
    m_measure->setText(tr("Count now"));
    m_measure->setVisible(figures.state == ViewMetrics::State::OnRequest);
    m_summary->setText(summary());
    const bool ready = figures.state == ViewMetrics::State::Ready && figures.subject.buffers;
    const ScenePointer scene = ready ? figures.subject.buffers->scenePointer() : nullptr;
    // While the metrics are stale the last rows stay, disabled, unless the scene has changed.
    if (ready)
        m_model->setObjects(scene, figures.lostObjects, figures.accuracy.missedPixels);
    else if (figures.state != ViewMetrics::State::Stale || m_model->scene() != m_session.scene())
        m_model->setObjects(nullptr, {}, 0);
    m_view->setEnabled(ready);
    m_view->setVisible(m_model->rowCount() > 0);
    // The Tab key cannot leave a panel whose focus proxy is hidden or disabled.
    setFocusProxy(ready && m_model->rowCount() > 0 ? m_view : nullptr);
    // Numbers stand at the right of their columns: without a gap before the next one they would touch its number.
    const int gap = 2 * m_view->fontMetrics().averageCharWidth();
    for (const int column : {LossModel::Pixels, LossModel::Share}) {
        m_view->resizeColumnToContents(column);
        m_view->setColumnWidth(column, m_view->columnWidth(column) + gap);
    }
}

std::optional<uint32_t> LossPanel::objectAt(const QModelIndex& index) const {
    if (!index.isValid() || m_model->scene() != m_session.scene()) return std::nullopt;
    return m_session.objectOf(m_model->instanceAt(index.row()));
}

void LossPanel::goTo(const QModelIndex& index) {
    const std::optional<uint32_t> object = objectAt(index);
    if (!object) return;
    pickLoss(m_session, *object);
    frameObject(m_session, *object);
}

void LossPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
