#include "ui/panels/outliner.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "ui/session/object_pick.h"

namespace cullscope::ui {

namespace {

constexpr int kEyeWidth = 26;
constexpr int kVerdictWidth = 24;
constexpr int kNumberWidth = 66;
constexpr int kSizeWidth = 50;

}  // namespace

Outliner::Outliner(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(new ObjectModel(this)),
      m_search(new QLineEdit(this)),
      m_view(new LongListView(this)) {
    setUpView();
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    m_view->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_search);
    layout->addWidget(m_view, 1);
    connect(m_search, &QLineEdit::textChanged, this, &Outliner::setSearch);
    connect(m_view, &QTreeView::clicked, this, &Outliner::clicked);
    connect(m_view, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (index.column() != ObjectModel::Eye) frameSelected();
    });
    connect(m_view, &QWidget::customContextMenuRequested, this, &Outliner::showMenu);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &Outliner::takeSelection);
    connect(&session, &Session::sceneChanged, this, &Outliner::refreshScene);
    connect(&session, &Session::hiddenChanged, this, [this] {
        m_model->setHidden(m_session.hidden());
        refreshVerdicts();
        emit stateChanged();
    });
    connect(&session, &Session::pickChanged, this, &Outliner::followPick);
    connect(&session, &Session::activeViewChanged, this, &Outliner::refreshVerdicts);
    connect(&session, &Session::questionChanged, this, &Outliner::refreshVerdicts);
    connect(&session, &Session::metricsChanged, this, [this](int view) {
        if (m_session.culledBy(m_session.activeView()) == view) refreshVerdicts();
    });
    retranslate();
    refreshScene();
}

void Outliner::setReader(SnapshotReader& reader) {
    m_reader = &reader;
    reader.readFor(this);
    connect(&reader, &SnapshotReader::changed, this, &Outliner::refreshVerdicts);
    connect(&reader, &QObject::destroyed, this, [this] { m_reader = nullptr; });
}

void Outliner::setUpView() {
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setAllColumnsShowFocus(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setIconSize({16, 16});
    m_view->setIndentation(0);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setSortingEnabled(true);
    QHeaderView& header = *m_view->header();
    header.setSortIndicatorClearable(true);
    header.setSortIndicator(-1, Qt::AscendingOrder);
    header.setMinimumSectionSize(kVerdictWidth);
    header.setSectionResizeMode(ObjectModel::Name, QHeaderView::Stretch);
    m_view->setColumnWidth(ObjectModel::Eye, kEyeWidth);
    m_view->setColumnWidth(ObjectModel::Triangles, kNumberWidth);
    m_view->setColumnWidth(ObjectModel::Verdict, kVerdictWidth);
    m_view->setColumnWidth(ObjectModel::Size, kSizeWidth);
}

void Outliner::refreshScene() {
    m_model->setScene(m_session.opened() ? m_session.opened()->scene : nullptr);
    m_model->setHidden(m_session.hidden());
    refreshVerdicts();
    followPick();
    emit stateChanged();
}

void Outliner::refreshVerdicts() {
    // Verdicts of a scene that is not shown any more number its objects differently.
    if (!m_session.opened() || m_model->scene() != m_session.opened()->scene) return;
    const ScenePointer& shown = m_session.scene();
    // Verdicts would answer an open question.
    if (m_session.question()) return m_model->setVerdicts(shown, nullptr, nullptr);
    const ViewMetrics& figures = m_session.figures(m_session.activeView());
    const bool known = figures.state == ViewMetrics::State::Ready && figures.states && figures.subject.buffers &&
                       figures.subject.buffers->scenePointer() == shown;
    const SnapshotReadingPointer reading = m_reader ? m_reader->reading() : nullptr;
    const bool read = reading && reading->strategy->scenePointer() == shown;
    m_model->setVerdicts(shown, known ? figures.states : nullptr, read ? reading : nullptr);
}

// ---- Selection

std::vector<uint32_t> Outliner::selected() const {
    std::vector<uint32_t> objects;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows()) objects.push_back(m_model->objectAt(index.row()));
    return objects;
}

void Outliner::setSearch(const QString& text) {
    const std::vector<uint32_t> before = selected();
    m_model->setSearch(text);
    select(before);
}

void Outliner::select(const std::vector<uint32_t>& objects) {
    const QScopedValueRollback guard(m_following, true);
    std::vector<bool> wanted(m_session.hidden().size(), false);
    for (const uint32_t object : objects) wanted[object] = true;
    QItemSelection selection;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const int first = row;
        while (row < m_model->rowCount() && wanted[m_model->objectAt(row)]) ++row;
        if (row > first) selection.select(m_model->index(first, 0), m_model->index(row - 1, ObjectModel::ColumnCount - 1));
    }
    m_view->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    if (!selection.isEmpty()) m_view->scrollTo(selection.front().topLeft());
    emit stateChanged();
}

void Outliner::followPick() {
    const std::optional<Pick>& pick = m_session.pick();
    if (!pick) return select({});
    const std::vector<uint32_t> now = selected();
    if (std::find(now.begin(), now.end(), pick->object) != now.end()) return;
    select({pick->object});
    const QScopedValueRollback guard(m_following, true);
    if (const int row = m_model->rowOf(pick->object); row >= 0)
        m_view->selectionModel()->setCurrentIndex(m_model->index(row, 0), QItemSelectionModel::NoUpdate);
}

void Outliner::takeSelection() {
    if (m_following) return;
    const QModelIndex current = m_view->currentIndex();
    if (current.isValid() && m_view->selectionModel()->isRowSelected(current.row(), {}))
        pickObject(m_session, m_model->objectAt(current.row()));
    emit stateChanged();
}

// ---- Commands

void Outliner::clicked(const QModelIndex& index) {
    if (index.column() != ObjectModel::Eye) return;
    const uint32_t object = m_model->objectAt(index.row());
    setHidden({object}, !m_session.hidden()[object]);
}

void Outliner::setHidden(const std::vector<uint32_t>& objects, bool hidden) { setObjectsHidden(m_session, objects, hidden); }

void Outliner::toggleSelected() {
    const std::vector<uint32_t> objects = selected();
    const std::vector<bool>& hidden = m_session.hidden();
    // If some selected objects are shown and some hidden, hide all.
    const bool anyShown = std::any_of(objects.begin(), objects.end(), [&](uint32_t object) { return !hidden[object]; });
    setHidden(objects, anyShown);
}

void Outliner::isolateSelected() { isolateObjects(m_session, selected()); }

void Outliner::showAll() { showAllObjects(m_session); }

void Outliner::frameSelected() {
    const std::vector<uint32_t> objects = selected();
    if (objects.size() == 1) return frameObject(m_session, objects.front());
    Box3 box;
    for (const uint32_t object : objects) box.add(m_session.opened()->scene->instanceBox(object));
    if (!box.empty()) m_session.frame({box.centre(), 0.5 * box.diagonal()});
}

void Outliner::showMenu(const QPoint& position) {
    const bool any = m_view->selectionModel()->hasSelection();
    QMenu menu(this);
    const auto add = [&](const QString& text, void (Outliner::*command)(), bool enabled) {
        menu.addAction(text, this, command)->setEnabled(enabled);
    };
    add(tr("Hide"), &Outliner::hideSelected, any);
    add(tr("Show"), &Outliner::showSelected, any);
    add(tr("Isolate"), &Outliner::isolateSelected, any);
    add(tr("Show all"), &Outliner::showAll, m_model->scene() != nullptr);
    menu.addSeparator();
    add(tr("Frame"), &Outliner::frameSelected, any);
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

bool Outliner::keyPressed(QObject* watched, int key) {
    if (watched == m_search) {
        if (key == Qt::Key_Escape && !m_search->text().isEmpty()) {
            m_search->clear();
            return true;
        }
        if (key == Qt::Key_Down) m_view->setFocus();
        return key == Qt::Key_Down;
    }
    if (key == Qt::Key_Space)
        toggleSelected();
    else if (key == Qt::Key_Delete)
        hideSelected();
    else
        return false;
    return true;
}

bool Outliner::eventFilter(QObject* watched, QEvent* event) {
    const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    const auto* pressed = key ? static_cast<QKeyEvent*>(event) : nullptr;
    if (pressed && pressed->modifiers() == Qt::NoModifier) {
        // Accepting ShortcutOverride gives these keys to the list, even if the window has shortcuts with them.
        const bool list = watched == m_view && (pressed->key() == Qt::Key_Space || pressed->key() == Qt::Key_Delete);
        const bool escape = watched == m_search && pressed->key() == Qt::Key_Escape && !m_search->text().isEmpty();
        if (event->type() == QEvent::ShortcutOverride) {
            if (list || escape) event->accept();
            return list || escape;
        }
        if (keyPressed(watched, pressed->key())) return true;
    }
    return QWidget::eventFilter(watched, event);
}

void Outliner::retranslate() {
    m_model->retranslate();
    m_search->setPlaceholderText(tr("Search objects"));
    m_search->setAccessibleName(tr("Search objects"));
    m_view->setAccessibleName(tr("Objects of the scene"));
}

void Outliner::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
