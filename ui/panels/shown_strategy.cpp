#include "ui/panels/shown_strategy.h"

#include <algorithm>

#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

const StrategyInfo& strategyOf(const Session& session, int view) {
    return findStrategy(session.slot(session.culledBy(view)).id()).info;
}

}  // namespace

const StrategyInfo& shownStrategy(const Session& session) { return strategyOf(session, session.activeView()); }

std::vector<ShowMeaning> meaningsIn(const Session& session, const std::vector<int>& views) {
    std::vector<ShowMeaning> meanings;
    for (const int view : views)
        for (const ShowMeaning& meaning : meaningsOf(session.setup(view).look, strategyOf(session, view)))
            if (std::ranges::find(meanings, meaning) == meanings.end()) meanings.push_back(meaning);
    return meanings;
}

void followShownStrategy(Session& session, QObject* context, const std::function<void()>& then) {
    for (const auto signal : {&Session::activeViewChanged, &Session::viewCountChanged, &Session::sceneChanged})
        QObject::connect(&session, signal, context, then);
    for (const auto signal : {&Session::strategyChosen, &Session::setupChanged})
        QObject::connect(&session, signal, context, [then](int) { then(); });
}

}  // namespace cullscope::ui
