#include "ui/startup/first_views.h"

#include <algorithm>

#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

/// The second view watches the first one as long as there are two. More views are there to be compared: then it has a strategy of
/// its own, and watches again when there are two. That ends when the view is changed otherwise.
class FirstObserver : public QObject {
public:
    explicit FirstObserver(Session& session) : QObject(&session), m_session(session) {
        watch();
        connect(&session, &Session::viewCountChanged, this, &FirstObserver::follow);
        connect(&session, &Session::setupChanged, this, [this](int view) {
            if (view != 1 || m_changing || m_session.setup(1).role == m_role) return;
            disconnect(&m_session, nullptr, this, nullptr);
            deleteLater();
        });
    }

private:
    void watch() {
        m_session.observe(1, 0);
        ViewSetup watching = m_session.setup(1);
        watching.look.watch();
        m_session.setSetup(1, watching);
        m_role = Role::Observer;
    }
    void follow() {
        const Role wanted = m_session.viewCount() > 2 ? Role::Linked : Role::Observer;
        if (m_session.setup(1).role != m_role || wanted == m_role) return;
        m_changing = true;
        if (wanted == Role::Observer) {
            watch();
        } else {
            ViewSetup linked = m_session.setup(1);
            linked.role = Role::Linked;
            linked.look = m_session.setup(0).look;
            m_session.setSetup(1, linked);
            m_role = Role::Linked;
        }
        m_changing = false;
    }

    Session& m_session;
    Role m_role = Role::Linked;
    bool m_changing = false;
};

}  // namespace

void showFirstViews(Session& session, const std::vector<StrategyRequest>& chosen) {
    session.setActiveView(0);
    if (chosen.empty()) {
        session.slot(0).choose(baselines().back()->id);
        session.offerStrategy(1);
        new FirstObserver(session);
        return;
    }
    for (size_t i = 0; i < chosen.size(); ++i) session.slot(int(i)).choose(chosen[i].id, chosen[i].parameters);
    for (const int count : Session::kViewCounts)
        if (size_t(count) >= chosen.size()) return session.setViewCount(count);
}

}  // namespace cullscope::ui
