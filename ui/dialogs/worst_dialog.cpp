#include "ui/dialogs/worst_dialog.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QScreen>
#include <QVBoxLayout>

#include "core/experiments/reports.h"
#include "core/scene/tour.h"
#include "ui/plots/plot_file.h"
#include "ui/statistics/history_store.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr QSize kWorstSize{1000, 620};
constexpr QSize kWorstMapSize{1100, 480};
constexpr int kMostTried = 100'000;
constexpr int kUsuallyTried = 200;

}  // namespace

std::optional<PlotPoint> WorstMap::valueAt(const QPointF& place) const {
    const PlotDrawing drawn = drawing();
    if (drawn.places.empty() || !drawn.places.front().box.contains({place.x(), place.y()})) return std::nullopt;
    const PlotPlace& plot = drawn.places.front();
    const double across = (place.x() - plot.box.left) / (plot.box.right - plot.box.left);
    const double up = (plot.box.bottom - place.y()) / (plot.box.bottom - plot.box.top);
    return PlotPoint{plot.x.first + across * (plot.x.last - plot.x.first), plot.y.first + up * (plot.y.last - plot.y.first)};
}

void WorstMap::mouseReleaseEvent(QMouseEvent* event) {
    const std::optional<PlotPoint> value =
        event->button() == Qt::LeftButton && !empty() ? valueAt(event->position()) : std::nullopt;
    if (!value) return LinePlotWidget::mouseReleaseEvent(event);
    emit valueChosen(*value);
}

WorstDialog::WorstDialog(Session& session, QWidget* parent)
    : RunDialog(session, Measures::Times, parent),
      m_of(new QComboBox(this)),
      m_from(new QComboBox(this)),
      m_views(new QSpinBox(this)),
      m_answer(new QLabel(this)),
      m_map(new WorstMap(this)),
      m_progress(new QProgressBar(this)),
      m_start(new QPushButton(tr("&Search"), this)),
      m_cancel(new QPushButton(tr("C&ancel"), this)),
      m_go(new QPushButton(tr("&Go to the worst view"), this)),
      m_save(new QPushButton(tr("Sa&ve the map…"), this)),
      m_close(new QPushButton(tr("C&lose"), this)),
      m_exporter(new ResultExporter(this)) {
    setWindowTitle(tr("The worst view of a strategy"));
    m_of->addItem(tr("that loses most"), int(worst::Of::Missed));
    m_of->addItem(tr("that gains least"), int(worst::Of::Ratio));
    m_of->setAccessibleName(tr("What is sought"));
    m_from->addItem(tr("from around the scene"), false);
    m_from->addItem(tr("from places within the scene"), true);
    m_from->setAccessibleName(tr("Where the eye is"));
    if (m_session.scene()) m_from->setCurrentIndex(isStoodIn(*m_session.scene()) ? 1 : 0);
    m_views->setRange(1, kMostTried);
    m_views->setValue(kUsuallyTried);
    m_views->setPrefix(tr("views: "));
    m_views->setAccessibleName(tr("How many views are tried at most"));
    m_answer->setWordWrap(true);
    m_progress->setAccessibleName(tr("Progress"));
    auto* top = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_of, m_from, m_views}) top->addWidget(widget);
    top->addStretch(1);
    top->addWidget(m_start);
    top->addWidget(m_cancel);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_progress, 1);
    for (QPushButton* button : {m_go, m_save, m_close}) bottom->addWidget(button);
    for (QPushButton* button : {m_cancel, m_go, m_save, m_close}) button->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_answer);
    layout->addWidget(m_map, 1);
    layout->addLayout(bottom);
    connect(m_start, &QPushButton::clicked, this, &WorstDialog::start);
    cancelBy(m_cancel);
    connect(m_go, &QPushButton::clicked, this, [this] {
        if (m_result) goTo(m_result->views[m_result->worst]);
    });
    connect(m_save, &QPushButton::clicked, this, &WorstDialog::save);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_map, &WorstMap::valueChosen, this, [this](const PlotPoint& value) {
        if (const worst::TriedView* view = m_result ? m_result->at(value) : nullptr) goTo(*view);
    });
    connect(m_exporter, &ResultExporter::written, this, [this](const QString& path) { m_session.tellSaved(path); });
    connect(m_exporter, &ResultExporter::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
    showState();
    resize(kWorstSize.boundedTo(screen()->availableGeometry().size()));
}

void WorstDialog::start() {
    if (running() || !m_session.scene()) return;
    const StrategySlot& slot = m_session.slot(m_session.culledBy(m_session.activeView()));
    worst::WorstRequest request;
    request.scene = m_session.scene();
    request.strategy = {slot.id(), slot.parameters()};
    request.of = worst::Of(m_of->currentData().toInt());
    request.size = m_session.renderSize(m_session.activeView());
    request.inside = m_from->currentData().toBool();
    request.views = size_t(m_views->value());
    m_result.reset();
    run([this, request](const Progress& progress) -> Result {
        return [this, result = worst::worstView(request, progress)] {
            if (!result.views.empty()) m_result = result;
            if (!result.interrupted) keepReport(m_session, reportOf(result));
        };
    });
}

void WorstDialog::showProgress(double share) { m_progress->setValue(int(100.0 * share)); }

void WorstDialog::showFailure(const Message& failure) { m_answer->setText(translated(failure)); }

void WorstDialog::showState() {
    m_start->setEnabled(!running() && m_session.scene());
    m_cancel->setEnabled(running());
    m_go->setEnabled(m_result.has_value());
    m_save->setEnabled(m_result.has_value());
    if (!running()) m_progress->setValue(m_result ? 100 : 0);
    if (m_result) m_map->setPlot(worst::worstMap(*m_result));
    m_map->setVisible(m_result.has_value());
    if (running())
        m_answer->setText(tr("Views are being tried, the worst parts of the map again and again in smaller parts…"));
    else if (!m_result)
        m_answer->setText(
            tr("The active view's strategy is drawn in many views, and the worst ones are searched more closely. A "
               "click on the map flies there."));
    else {
        QStringList sentences;
        for (const Message& sentence : worst::sentences(*m_result)) sentences << translated(sentence);
        m_answer->setText(sentences.join(QLatin1Char(' ')));
    }
}

void WorstDialog::goTo(const worst::TriedView& view) {
    if (m_session.scene() != m_result->request.scene) return;
    CameraPath path = m_result->lens;
    path.poses = {view.pose};
    m_session.setCamera(path.camera(0));
}

void WorstDialog::save() {
    QFileDialog dialog(this, tr("Save the map"), {}, tr("Pictures (*.svg *.pdf *.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("svg"));
    if (dialog.exec() != QDialog::Accepted) return;
    const QString file = dialog.selectedFiles().front();
    const QByteArray bytes = file.endsWith(QStringLiteral(".pdf"))   ? plotPdf(*m_map, kWorstMapSize)
                             : file.endsWith(QStringLiteral(".png")) ? plotPng(*m_map, kWorstMapSize)
                                                                     : plotSvg(*m_map, kWorstMapSize);
    m_exporter->write(file.toStdString(), [bytes] { return bytes; });
}

}  // namespace cullscope::ui
