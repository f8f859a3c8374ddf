#include "ui/startup/first_views.h"

#include "core/visibility/registry.h"

namespace cullscope::ui {

void showFirstViews(Session& session, const std::vector<StrategyRequest>& chosen) {
    session.setActiveView(0);
    if (chosen.empty()) {
        session.slot(0).choose(baselines().back()->id);
        session.observe(1, 0);
        ViewSetup watching = session.setup(1);
        watching.look.watch();
        session.setSetup(1, watching);
        return;
    }
    for (size_t i = 0; i < chosen.size(); ++i) {
        session.slot(int(i)).choose(chosen[i].id);
        session.slot(int(i)).setParameters(chosen[i].parameters);
    }
    for (const int count : Session::kViewCounts)
        if (size_t(count) >= chosen.size()) return session.setViewCount(count);
}

}  // namespace cullscope::ui
