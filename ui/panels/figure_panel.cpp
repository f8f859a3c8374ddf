#include "ui/panels/figure_panel.h"

#include <QEvent>
#include <QHeaderView>

namespace cullscope::ui {

namespace {

constexpr int kRowHeight = 20;  // all rows show at once on a screen of 768 lines

}  // namespace

FigurePanel::FigurePanel(Session& session, QWidget* parent)
    : QTableView(parent), m_session(session), m_model(new FigureModel(this)) {
    setModel(m_model);
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setSelectionMode(QAbstractItemView::NoSelection);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setSectionsClickable(false);
    verticalHeader()->setSectionsClickable(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setMinimumSectionSize(kRowHeight);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setStyleSheet(
        QStringLiteral("QHeaderView, QHeaderView::section, QTableCornerButton::section { border: 0; background: palette(base); "
                       "padding: 1px 4px; }"));
    connect(&session, &Session::viewCountChanged, this, &FigurePanel::refresh);
    connect(&session, &Session::activeViewChanged, this, [this] {
        if (m_session.viewCount() == 1) refresh();
    });
    connect(&session, &Session::figuresChanged, this, [this](int view) { m_model->setFigures(view, m_session.figures(view)); });
    refresh();
}

void FigurePanel::refresh() {
    setAccessibleName(tr("Figures"));
    std::vector<FigureModel::Column> columns;
    for (int view = 0; view < Session::kMostViews; ++view)
        if (m_session.shown(view)) columns.push_back({view, m_session.figures(view)});
    m_model->setColumns(std::move(columns));
}

void FigurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QTableView::changeEvent(event);
}

}  // namespace cullscope::ui
