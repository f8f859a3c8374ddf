#include "ui/panels/structure_tree.h"

#include <QApplication>
#include <QEvent>
#include <QHeaderView>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "ui/session/object_pick.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr std::array kWidths{0, 64, 146, 92};  // width of the columns; the name takes the rest of 400 pixels
constexpr double kUsualLetters = 1.3;          // larger ones, of a lecture, leave room for names and verdicts alone
constexpr double kWiderVerdicts = 1.15;
constexpr int kIndentation = 12;  // pixels per level, so that the fourth level still has room for names
constexpr int kFirstRows = 24;    // rows that are expanded when a tree is first shown

}  // namespace

StructureTree::StructureTree(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reader(reader),
      m_model(new StructureModel(this)),
      m_view(new LongListView(this)),
      m_empty(new QLabel(this)) {
    setUpView();
    m_empty->setWordWrap(true);
    m_empty->setMargin(8);
    m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_empty, 1);
    connect(&reader, &SnapshotReader::changed, this, &StructureTree::refresh);
    connect(&session, &Session::metricsChanged, this, &StructureTree::refresh);
    connect(&session, &Session::pickChanged, this, &StructureTree::followPick);
    connect(&session, &Session::stepChanged, this, &StructureTree::followPick);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &StructureTree::pickSelected);
    connect(m_model, &StructureModel::modelReset, m_view, [this] {
        m_namesPlanes = false;
        m_view->expandFirstLevels(kFirstRows);
    });
    retranslate();
    refresh();
}

void StructureTree::setUpView() {
    m_view->setModel(m_model);
    m_view->setIconSize({14, 14});
    m_view->setIndentation(kIndentation);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_view->header()->setSectionResizeMode(StructureModel::Name, QHeaderView::Stretch);
    fitLetters();
}

void StructureTree::fitLetters() {
    const double scale = double(QFontInfo(font()).pixelSize()) / QFontInfo(QApplication::font()).pixelSize();
    m_large = scale > kUsualLetters;
    m_view->setWholeRows(m_large);
    // Names in a lecture are short, and its verdicts must not be.
    const double share = m_large ? scale * kWiderVerdicts : scale;
    for (int column = StructureModel::Triangles; column < StructureModel::ColumnCount; ++column)
        m_view->setColumnWidth(column, int(kWidths[size_t(column)] * share));
}

void StructureTree::refresh() {
    const SnapshotReadingPointer& reading = m_reader.reading();
    m_model->setSnapshot(reading ? reading->strategy->scenePointer() : nullptr, reading ? reading->snapshot : nullptr);
    m_model->setStates(statesOfTruth());
    // A flat list needs no expand arrows. In a tree the names need the width of the count column; their tooltips state the
    // counts.
    m_view->setRootIsDecorated(m_model->nested());
    m_view->setColumnHidden(StructureModel::Triangles, m_model->nested() || m_large);
    // So do they need that of planes, until one has rejected something; then it stays, so that no step moves the columns back.
    m_namesPlanes = m_namesPlanes || m_model->namesPlanes();
    m_view->setColumnHidden(StructureModel::Plane, m_large || (m_model->nested() && !m_namesPlanes));
    m_view->setVisible(!m_model->empty());
    // The Tab key cannot leave a panel whose focus proxy is hidden.
    setFocusProxy(m_model->empty() ? nullptr : m_view);
    m_empty->setVisible(m_model->empty());
    m_empty->setText(emptySentence());
    // A selected group is not the picked object: it stays selected until the user picks another object.
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    if (rows.isEmpty() || m_model->instanceAt(rows.front()) || m_session.stepOf(m_session.activeView())) followPick();
}

std::shared_ptr<const TriangleStates> StructureTree::statesOfTruth() const {
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    const bool known = figures.state == ViewMetrics::State::Ready && figures.states && figures.subject.buffers &&
                       figures.subject.buffers->scenePointer() == m_session.scene();
    // At a step the truth is not known: it is that of the whole frame.
    return known && m_reader.fresh() && !m_session.stepOf(m_session.activeView()) ? figures.states : nullptr;
}

QModelIndex StructureTree::followedRow() const {
    if (const ShownStep* step = m_session.stepOf(m_session.activeView()); step != nullptr) {
        const SubjectShape& shape = step->shape;
        if (shape.node) return m_model->indexOfGroup(*shape.node);
        if (shape.triangle && !shape.triangles.empty()) {
            const auto& [a, b, c] = shape.triangles.front();
            const auto group = step->frame->request.strategy->groupAt(*shape.triangle, (a + b + c) / 3.0);
            if (group) return m_model->indexOfGroup(*group);
        }
        if (step->shape.object) return m_model->indexOfInstance(*step->shape.object);
    }
    const std::optional<Pick>& pick = m_session.pick();
    const SnapshotReadingPointer& reading = m_reader.reading();
    if (const auto triangle = m_reader.pickedTriangle();
        triangle && reading && reading->strategy->scenePointer() == m_session.scene())
        if (const std::optional<uint32_t> group = reading->strategy->groupAt(*triangle, pick->point))
            return m_model->indexOfGroup(*group);
    const std::optional<uint32_t> instance = pick ? m_session.instanceOf(pick->object) : std::nullopt;
    return instance ? m_model->indexOfInstance(*instance) : QModelIndex();
}

void StructureTree::followPick() {
    const QScopedValueRollback guard(m_following, true);
    const QModelIndex index = followedRow();
    if (!index.isValid()) {
        m_view->clearSelection();
        return;
    }
    if (m_view->selectionModel()->isRowSelected(index.row(), index.parent())) return;
    m_view->setCurrentIndex(index);
    m_view->scrollTo(index);
}

void StructureTree::pickSelected() {
    if (m_following) return;
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    const SnapshotReadingPointer& reading = m_reader.reading();
    // After a change of the scene, until the first new reading, the model shows the former scene.
    if (rows.isEmpty() || !reading || reading->strategy->scenePointer() != m_session.scene())
        return m_session.setGroup(std::nullopt);
    if (const std::optional<uint32_t> group = m_model->groupAt(rows.front()))
        return m_session.setGroup(
            ChosenGroup{reading->strategy, *group, reading->strategy->groupShape(*reading->snapshot, *group)});
    m_session.setGroup(std::nullopt);
    if (const std::optional<uint32_t> instance = m_model->instanceAt(rows.front()))
        pickObject(m_session, m_session.objectOf(*instance));
}

void StructureTree::retranslate() {
    m_model->retranslate();
    m_view->setAccessibleName(tr("Boxes that the strategy tests"));
    m_empty->setText(emptySentence());
}

QString StructureTree::emptySentence() const {
    const SnapshotReadingPointer& reading = m_reader.reading();
    if (reading && !reading->failure.empty()) return translated(reading->failure);
    return tr(
        "This strategy tests no boxes. Strategies that test bounds or descend a tree list them here, with what they "
        "decided about each.");
}

void StructureTree::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    if (event->type() == QEvent::FontChange) {
        fitLetters();
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
