#include "ui/panels/figure_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

constexpr int kRowHeight = 20;

}  // namespace

FigurePanel::FigurePanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(new FigureModel(this)),
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
    connect(&session, &Session::viewCountChanged, this, &FigurePanel::refresh);
    connect(&session, &Session::activeViewChanged, this, [this] {
        if (m_session.viewCount() == 1) refresh();
    });
    connect(&session, &Session::setupChanged, this, &FigurePanel::refresh);
    connect(&session, &Session::figuresChanged, this, [this](int view) { m_model->setFigures(view, m_session.figures(view)); });
    refresh();
}

void FigurePanel::setUpTable() {
    m_table->setModel(m_model);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionsClickable(false);
    QHeaderView& rows = *m_table->verticalHeader();
    rows.setSectionsClickable(false);
    rows.setSectionResizeMode(QHeaderView::Fixed);
    rows.setMinimumSectionSize(kRowHeight);
    rows.setDefaultSectionSize(kRowHeight);
    rows.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setStyleSheet(
        QStringLiteral("QHeaderView, QHeaderView::section, QTableCornerButton::section { border: 0; background: palette(base); "
                       "padding: 1px 4px; }"));
}

void FigurePanel::refresh() {
    m_table->setAccessibleName(tr("Figures"));
    m_software->setText(tr("Software OpenGL: not the times of a graphics card"));
    m_software->setVisible(m_session.gpu() && m_session.gpu()->info().software);
    std::vector<FigureModel::Column> columns;
    for (const int view : m_session.measuredViews()) columns.push_back({view, m_session.figures(view)});
    m_model->setColumns(std::move(columns));
    // The dock scrolls as a whole: a table that scrolled inside it would be hard to reach.
    m_table->ensurePolished();
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() + m_table->verticalHeader()->length() + 4);
}

void FigurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
