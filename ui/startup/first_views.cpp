#include "ui/startup/first_views.h"

#include <algorithm>

#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

/// The views from `first` on get strategies that no view before them has, in the order of the registry, so that eight views
/// compare eight strategies as long as there are that many that this machine can use.
void chooseForOthers(Session& session, int first) {
    std::vector<std::string> taken;
    for (int view = 0; view < first; ++view) taken.push_back(session.slot(session.culledBy(view)).id());
    int view = first;
    for (const RegisteredStrategy& strategy : strategies()) {
        const bool usable = !session.unavailable(strategy.info) && std::ranges::find(taken, strategy.info.id) == taken.end();
        if (view < Session::kMostViews && usable) session.slot(view++).choose(strategy.info.id);
    }
}

}  // namespace

void showFirstViews(Session& session, const std::vector<StrategyRequest>& chosen) {
    session.setActiveView(0);
    if (chosen.empty()) {
        session.slot(0).choose(baselines().back()->id);
        session.observe(1, 0);
        ViewSetup watching = session.setup(1);
        watching.look.watch();
        session.setSetup(1, watching);
        return chooseForOthers(session, 2);
    }
    for (size_t i = 0; i < chosen.size(); ++i) {
        session.slot(int(i)).choose(chosen[i].id);
        session.slot(int(i)).setParameters(chosen[i].parameters);
    }
    chooseForOthers(session, int(chosen.size()));
    for (const int count : Session::kViewCounts)
        if (size_t(count) >= chosen.size()) return session.setViewCount(count);
}

}  // namespace cullscope::ui
