#include "ui/panels/shown_strategy.h"

#include "core/visibility/registry.h"

namespace cullscope::ui {

const StrategyInfo& shownStrategy(const Session& session) {
    return findStrategy(session.slot(session.culledBy(session.activeView())).id()).info;
}

void followShownStrategy(Session& session, QObject* context, const std::function<void()>& then) {
    for (const auto signal : {&Session::activeViewChanged, &Session::viewCountChanged, &Session::sceneChanged})
        QObject::connect(&session, signal, context, then);
    for (const auto signal : {&Session::strategyChosen, &Session::setupChanged})
        QObject::connect(&session, signal, context, [then](int) { then(); });
}

}  // namespace cullscope::ui
