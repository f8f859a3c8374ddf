#include "ui/panels/question_tree.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace cullscope::ui {

namespace {

constexpr int kShownRows = 24;        // rows that are expanded at first
constexpr int kRowSpacing = 12;       // indentation of a level, in pixels
constexpr size_t kMostRows = 20'000;  // a longer tree is not shown
constexpr int kNode = Qt::UserRole;   // index into StructureSnapshot::nodes

}  // namespace

QuestionTree::QuestionTree(Session& session, SnapshotReader& reader, QuestionFirst& questions, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_reader(reader),
      m_questions(questions),
      m_model(new QStandardItemModel(this)),
      m_view(new LongListView(this)),
      m_words(new QLabel(this)) {
    m_view->setModel(m_model);
    m_view->setHeaderHidden(true);
    m_view->header()->setStretchLastSection(true);
    m_view->setIndentation(kRowSpacing);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_words->setWordWrap(true);
    m_words->setMargin(8);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_words);
    layout->addWidget(m_view, 1);
    reader.readFor(this);
    connect(&reader, &SnapshotReader::changed, this, &QuestionTree::refresh);
    connect(&session, &Session::questionChanged, this, &QuestionTree::refresh);
    connect(m_view, &QTreeView::clicked, this, &QuestionTree::answer);
    refresh();
}

void QuestionTree::answer(const QModelIndex& row) {
    if (row.isValid() && m_shown && m_shown->strategy->scenePointer() == m_session.scene())
        m_questions.answerBy(*m_shown->strategy, *m_tree, size_t(row.data(kNode).toULongLong()));
}

void QuestionTree::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return answer(m_view->currentIndex());
    QWidget::keyPressEvent(event);
}

QString QuestionTree::nameOf(const Scene& scene, const StructureSnapshot& snapshot, size_t node) {
    const SnapshotNode& one = snapshot.nodes[node];
    if (!one.isGroup()) return QString::fromStdString(scene.instances()[one.instance].name);
    if (!one.name.empty()) return QString::fromStdString(one.name);
    return tr("Node %1", "of a strategy's tree").arg(one.number);
}

void QuestionTree::refresh() {
    setVisible(m_session.question().has_value());
    m_words->setText(tr("A click on a row answers, too."));
    m_view->setAccessibleName(tr("Tree to answer by"));
    const SnapshotReadingPointer& reading = m_reader.reading();
    if (!m_session.question()) return;
    const bool placed = m_session.question()->question == Prediction::Question::Place;
    const bool another = std::exchange(m_placed, placed) != placed;
    if (reading == m_shown && !another) return;
    // Another frame may list the same boxes in another order, and then a row is another one of them.
    const auto boxes = [](const SnapshotNode& node) { return std::tuple(node.parent, node.instance, node.number); };
    const std::shared_ptr<const StructureSnapshot> before = std::exchange(m_tree, reading ? treeOf(*reading) : nullptr);
    const bool same = m_shown && before && m_tree && reading->strategy == m_shown->strategy &&
                      std::ranges::equal(before->nodes, m_tree->nodes, {}, boxes, boxes);
    m_shown = reading;
    if (same && !another) return;
    m_model->clear();
    const bool any = m_tree && !m_tree->nodes.empty() && m_tree->nodes.size() <= kMostRows;
    m_view->setVisible(any);
    m_words->setVisible(any);
    if (!any) return;
    const std::vector<SnapshotNode>& nodes = m_tree->nodes;
    std::vector<QStandardItem*> rows;
    for (size_t node = 0; node < nodes.size(); ++node) {
        rows.push_back(new QStandardItem(nameOf(reading->strategy->scene(), *m_tree, node)));
        rows.back()->setData(qulonglong(node), kNode);
    }
    // Boxes come as the frame decided about them, which would answer a question about the order.
    std::vector<size_t> byNumber(nodes.size());
    std::iota(byNumber.begin(), byNumber.end(), size_t{0});
    std::ranges::sort(byNumber, {}, [&](size_t node) {
        const SnapshotNode& one = nodes[node];
        return std::pair(!one.isGroup(), one.isGroup() ? one.number : one.instance);
    });
    for (const size_t node : byNumber) {
        // Where an object lies in the tree would answer a question about its place.
        const int32_t parent = placed && !nodes[node].isGroup() ? -1 : nodes[node].parent;
        (parent < 0 ? m_model->invisibleRootItem() : rows[size_t(parent)])->appendRow(rows[node]);
    }
    m_view->expandFirstLevels(kShownRows);
}

std::shared_ptr<const StructureSnapshot> QuestionTree::treeOf(const SnapshotReading& reading) {
    if (reading.snapshot && !reading.snapshot->nodes.empty()) return reading.snapshot;
    auto objects = std::make_shared<StructureSnapshot>();
    const Scene& scene = reading.strategy->scene();
    for (uint32_t instance = 0; instance < scene.instances().size(); ++instance) {
        if (scene.meshOf(instance).triangleCount() == 0) continue;
        objects->nodes.emplace_back().instance = instance;
    }
    return objects;
}

void QuestionTree::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_shown = nullptr;
        refresh();
    }
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
