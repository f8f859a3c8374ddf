#include "ui/panels/metrics_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

constexpr int kRowHeight = 20;

}  // namespace

MetricsPanel::MetricsPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(new MetricsModel(this)),
      m_table(new QTableView(this)),
      m_software(new QLabel(this)) {
    setUpTable();
    m_software->setWordWrap(true);
    m_software->setMargin(4);
    m_software->setAutoFillBackground(true);
    m_software->setBackgroundRole(QPalette::ToolTipBase);
    m_software->setForegroundRole(QPalette::ToolTipText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_software);
    setFocusProxy(m_table);
    connect(&session, &Session::viewCountChanged, this, &MetricsPanel::refresh);
    connect(&session, &Session::activeViewChanged, this, [this] {
        if (m_session.viewCount() == 1) refresh();
    });
    connect(&session, &Session::setupChanged, this, &MetricsPanel::refresh);
    connect(&session, &Session::metricsChanged, this, [this](int view) {
        m_model->setFigures(view, m_session.figures(view));
        fitColumns();
    });
    refresh();
}

void MetricsPanel::setUpTable() {
    m_table->setModel(m_model);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setTextElideMode(Qt::ElideNone);
    m_table->viewport()->installEventFilter(this);
    m_table->horizontalHeader()->setSectionsClickable(false);
    QHeaderView& rows = *m_table->verticalHeader();
    rows.setSectionsClickable(false);
    rows.setSectionResizeMode(QHeaderView::Fixed);
    rows.setMinimumSectionSize(kRowHeight);
    rows.setDefaultSectionSize(kRowHeight);
    rows.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setColours();
}

/// A style sheet does not follow palette changes: the colours are written into it again for each palette.
void MetricsPanel::setColours() {
    // Padding is set per section: around the whole header it would shift the titles against their columns.
    m_table->setStyleSheet(
        QStringLiteral("QTableView, QHeaderView, QHeaderView::section, QTableCornerButton::section { border: 0; background: %1; "
                       "color: %2; } QHeaderView::section, QTableCornerButton::section { padding: 1px 4px; }")
            .arg(palette().color(QPalette::Base).name(), palette().color(QPalette::Text).name()));
}

void MetricsPanel::refresh() {
    m_table->setAccessibleName(tr("Figures"));
    m_software->setText(tr("Software OpenGL: not the times of a graphics card"));
    m_software->setVisible(m_session.gpu() && m_session.gpu()->info().software);
    std::vector<MetricsModel::Column> columns;
    for (const int view : m_session.measuredViews()) columns.push_back({view, m_session.figures(view)});
    m_model->setColumns(std::move(columns));
    m_table->ensurePolished();
    fitColumns();
}

void MetricsPanel::fitColumns() {
    QHeaderView& header = *m_table->horizontalHeader();
    const QAbstractItemView& cells = *m_table;
    int widest = 0, all = 0;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const int width = std::max(cells.sizeHintForColumn(column), header.sectionSizeHint(column));
        widest = std::max(widest, width);
        all += width;
    }
    const int room = m_table->viewport()->width();
    const QHeaderView::ResizeMode mode =
        widest * m_model->columnCount() <= room ? QHeaderView::Stretch : QHeaderView::ResizeToContents;
    if (header.count() > 0 && header.sectionResizeMode(0) != mode) header.setSectionResizeMode(mode);
    // The dock scrolls as a whole: rows that scroll inside it again would be hard to reach.
    const int bar = all > room ? m_table->horizontalScrollBar()->sizeHint().height() : 0;
    m_table->setMinimumHeight(header.sizeHint().height() + m_table->verticalHeader()->length() + 4 + bar);
}

bool MetricsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) fitColumns();
    return QWidget::eventFilter(watched, event);
}

void MetricsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) setColours();
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
