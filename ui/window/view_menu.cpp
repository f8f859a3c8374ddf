#include "ui/window/view_menu.h"

#include <QActionGroup>
#include <numeric>

#include "core/visibility/built_strategy.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"
#include "ui/window/size_options.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

QAction* ViewMenu::option(QMenu& menu, const QString& text, bool checked, std::function<void()> choose) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    if (auto* exclusive = menu.findChild<QActionGroup*>(QString(), Qt::FindDirectChildrenOnly)) exclusive->addAction(action);
    QObject::connect(action, &QAction::triggered, &menu, std::move(choose));
    return action;
}

QMenu* ViewMenu::addChoice(const QString& title) {
    QMenu* menu = m_menu.addMenu(title);
    menu->setToolTipsVisible(true);
    new QActionGroup(menu);
    return menu;
}

QAction* ViewMenu::change(QMenu& menu, const QString& text, bool checked, const std::function<void(ViewSetup&)>& edit) {
    return option(menu, text, checked, [session = &m_session, view = view(), edit] {
        ViewSetup changed = session->setup(view);
        edit(changed);
        session->setSetup(view, changed);
    });
}

void ViewMenu::needsCameraPicture(QAction* action) const {
    if (!setup().look.inPlace()) return;
    action->setEnabled(false);
    action->setToolTip(WindowActions::modelStandsInPlace());
}

void ViewMenu::addStrategies() {
    QMenu* menu = addChoice(tr("Strategy"));
    const int culling = m_session.culledBy(view());
    for (const RegisteredStrategy& strategy : strategies()) {
        // Right of the tab stands what menus show as shortcuts.
        const QString text = translated(strategy.info.name) + QLatin1Char('\t') + promiseWord(usualPromise(strategy.info.id));
        QAction* action = option(*menu, text, strategy.info.id == m_session.slot(culling).id(),
                                 [session = &m_session, culling, id = strategy.info.id] { session->slot(culling).choose(id); });
        const std::optional<Message> why = m_session.unavailable(strategy.info);
        action->setEnabled(!why);
        action->setToolTip(translated(why ? *why : Message{strategy.info.description, {}}));
    }
}

void ViewMenu::addCameras() {
    QMenu* menu = addChoice(tr("Camera"));
    Session* session = &m_session;
    const int view = this->view();
    option(*menu, tr("Linked with the other views"), setup().role == Role::Linked, [session, view] { session->setLinked(view); });
    QAction* freeze = option(*menu, m_actions.freeze->text(), setup().role == Role::Frozen,
                             [session, view] { session->setFrozen(view, true); });
    freeze->setShortcut(Qt::Key_F);
    menu->addSeparator();
    for (const int other : m_session.shownViews()) {
        if (other == view || m_session.setup(other).role == Role::Observer) continue;
        option(*menu, tr("Watch view %1 from outside").arg(viewLetter(other)),
               setup().role == Role::Observer && setup().observed == other, [session, view, other] {
                   session->observe(view, other);
                   ViewSetup changed = session->setup(view);
                   changed.look.watch();
                   session->setSetup(view, changed);
               });
    }
}

void ViewMenu::addLook() {
    QMenu* menu = m_menu.addMenu(tr("Picture"));
    menu->setToolTipsVisible(true);
    const ViewLook& look = setup().look;
    for (const Show* show : pictureShows()) {
        // What stands in this menu alone belongs to the show before it, and can be chosen while that one is seen.
        const bool part = show->action.empty();
        const bool on = part ? look.shows(show->id) : look.has(*show);
        QAction* action = change(*menu, translated(part ? show->title : show->action), on,
                                 [show, on](ViewSetup& setup) { setup.look.showWithAll(*show, !on); });
        if (!show->key.empty()) action->setShortcut(QKeySequence(QString::fromStdString(show->key)));
        if (part && show->with() && !look.has(*show->with())) action->setEnabled(false);
        if (!show->inPlace()) needsCameraPicture(action);
    }
}

void ViewMenu::addComparisons() {
    QMenu* menu = addChoice(tr("Compare"));
    const Wipe& wipe = setup().wipe;
    const auto choice = [&](const QString& text, Wipe::Mode mode, int other) {
        const bool pair = mode == Wipe::Mode::OtherView || mode == Wipe::Mode::Difference;
        return change(*menu, text, wipe.mode == mode && (!pair || wipe.other == other), [mode, other](ViewSetup& setup) {
            setup.wipe.mode = mode;
            setup.wipe.other = other;
        });
    };
    choice(tr("Nothing"), Wipe::Mode::None, wipe.other);
    choice(m_actions.truth->text(), Wipe::Mode::Truth, wipe.other)->setShortcut(Qt::Key_T);
    choice(m_actions.loss->text(), Wipe::Mode::Loss, wipe.other)->setShortcut(Qt::Key_M);
    for (const int other : m_session.shownViews()) {
        if (m_session.culledBy(other) == m_session.culledBy(view())) continue;
        menu->addSeparator();
        choice(tr("Wipe: view %1 | this one").arg(viewLetter(other)), Wipe::Mode::OtherView, other);
        choice(tr("Pixels that differ from view %1").arg(viewLetter(other)), Wipe::Mode::Difference, other);
    }
    for (QAction* action : menu->actions()) needsCameraPicture(action);
}

void ViewMenu::addSizes() {
    QMenu* menu = m_menu.addMenu(tr("Picture size"));
    const std::optional<Viewport>& size = setup().size;
    addSizeOptions(*menu, size, m_session.renderSize(view()),
                   [session = &m_session, view = view()](const auto& wanted) { session->setPictureSize({view}, wanted); });
    menu->addSeparator();
    QObject::connect(menu->addAction(tr("The same in all views")), &QAction::triggered, menu, [session = &m_session, size] {
        std::vector<int> all(Session::kMostViews);
        std::iota(all.begin(), all.end(), 0);
        session->setPictureSize(all, size);
    });
}

void ViewMenu::addUploads() {
    QMenu* menu = addChoice(tr("Vertices"));
    change(*menu, tr("Buffer objects"), setup().upload == Upload::Vbo, [](ViewSetup& setup) { setup.upload = Upload::Vbo; });
    QAction* arrays = change(*menu, tr("Vertex arrays of the program's memory"), setup().upload == Upload::VertexArray,
                             [](ViewSetup& setup) { setup.upload = Upload::VertexArray; });
    if (m_session.gpu() && !m_session.gpu()->info().compatibilityProfile) {
        arrays->setEnabled(false);
        arrays->setText(tr("Vertex arrays: this OpenGL has no compatibility profile"));
    }
}

void ViewMenu::addPanels(const std::vector<PlaceablePanel>& panels, const std::vector<PlaceablePanel>& below) {
    QMenu* menu = addChoice(tr("In this place"));
    change(*menu, tr("Picture"), setup().panel.empty(), [](ViewSetup& setup) { setup.panel.clear(); });
    for (const PlaceablePanel& panel : panels)
        change(*menu, panel.name, setup().panel == panel.id, [id = panel.id](ViewSetup& setup) { setup.panel = id; });
    QMenu* strip = addChoice(tr("Below the picture"));
    change(*strip, tr("Nothing"), setup().below.empty(), [](ViewSetup& setup) { setup.below.clear(); });
    for (const PlaceablePanel& panel : below)
        change(*strip, panel.name, setup().below == panel.id, [id = panel.id](ViewSetup& setup) { setup.below = id; });
}

}  // namespace cullscope::ui
