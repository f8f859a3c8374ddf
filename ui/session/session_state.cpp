#include "ui/session/session_state.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/scene/hidden.h"
#include "ui/session/session_json.h"

namespace cullscope::ui {

namespace {

SessionState::View captureView(const Session& session, int view) {
    const StrategySlot& slot = session.slot(view);
    SessionState::View captured{slot.id(), {}, session.setup(view)};
    for (const ParameterDeclaration& declaration : slot.parameters().declarations())
        captured.parameters.emplace(declaration.key, toText(slot.parameters().value(declaration.key)));
    return captured;
}

void applyHidden(Session& session, const std::vector<bool>& hidden) {
    const size_t objects = session.hidden().size();
    if (hidden.size() == objects) return session.setHidden(hidden);
    session.setHidden(std::vector<bool>(objects, false));
    if (std::find(hidden.begin(), hidden.end(), true) != hidden.end())
        session.raise(Severity::Warning,
                      {QT_TRANSLATE_NOOP("core", "The scene has %1 objects now, no longer %2: all of them are shown."),
                       {std::to_string(objects), std::to_string(hidden.size())}});
}

/// Sets observers last, because their setup depends on that of the observed view.
void applySetups(Session& session, const SessionState& state) {
    for (const bool observers : {false, true})
        for (int view = 0; view < Session::kMostViews; ++view) {
            const ViewSetup& setup = state.views[size_t(view)].setup;
            if ((setup.role == Role::Observer) == observers) session.setSetup(view, setup);
        }
}

}  // namespace

SessionState captureState(const Session& session) {
    SessionState state;
    if (session.opened()) state.scene = session.opened()->specification;
    state.hidden = session.hidden();
    state.camera = session.camera();
    state.up = session.upAxis();
    state.chosenNear = session.chosenNear();
    state.section = session.section();
    state.viewCount = session.viewCount();
    state.activeView = session.activeView();
    if (session.step()) state.place = session.step()->place;
    for (int view = 0; view < Session::kMostViews; ++view) state.views[size_t(view)] = captureView(session, view);
    return state;
}

void applyState(Session& session, const SessionState& state) {
    if (!session.opened()) return;
    std::array<ParameterSet, Session::kMostViews> parameters;
    for (size_t view = 0; view < parameters.size(); ++view)
        if (!state.views[view].strategy.empty()) parameters[view] = parametersOf(state.views[view]);

    session.setViewCount(state.viewCount);
    session.setActiveView(state.activeView);
    for (int view = 0; view < Session::kMostViews; ++view) {
        const std::string& strategy = state.views[size_t(view)].strategy;
        if (strategy.empty()) continue;
        session.slot(view).choose(strategy, parameters[size_t(view)]);
    }
    applyHidden(session, state.hidden);
    // Set first: a change of the up axis moves all cameras.
    session.setUpAxis(state.up);
    applySetups(session, state);
    session.setChosenNear(state.chosenNear);
    session.setSection(state.section);
    session.setCamera(state.camera);
}

PictureSubject pictureSubject(const Session& session, int view, const std::optional<ViewRequest>& request) {
    const StrategySlot& slot = session.slot(session.culledBy(view));
    PictureSubject subject;
    subject.scene = session.opened()->specification;
    subject.modelFolders = session.sceneSource().modelFolders;
    subject.hidden = hiddenToText(session.hidden());
    subject.strategy = slot.id();
    subject.parameters = slot.parameters();
    subject.culling = session.cullingCamera(view);
    subject.viewing = session.viewingCamera(view);
    subject.size = request ? request->size : session.renderSize(view);
    subject.cullingSize = request ? request->cullingSize : subject.size;
    subject.look = request ? request->look : session.setup(view).look;
    subject.section = request ? request->section : session.section();
    subject.style = request ? request->style : session.drawStyle();
    return subject;
}

}  // namespace cullscope::ui
