#include "ui/session/undo_step.h"

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// The setup without the viewing camera, which is compared separately.
ViewSetup withoutViewing(ViewSetup setup) {
    setup.viewing = Camera{};
    return setup;
}

template <typename Value>
void carry(Value& base, const Value& from, const Value& to) {
    if (!(from == to)) base = to;
}

/// The parts that differ between two states, as far as undo names them.
struct Difference {
    bool linkedCamera = false, hidden = false;
    std::vector<int> viewing, strategies, parameters, setups;

    Difference(const SessionState& a, const SessionState& b)
        : linkedCamera(!(a.camera == b.camera) || a.up != b.up || a.chosenNear != b.chosenNear), hidden(a.hidden != b.hidden) {
        for (int view = 0; view < Session::kMostViews; ++view) {
            const SessionState::View& x = a.views[size_t(view)];
            const SessionState::View& y = b.views[size_t(view)];
            if (x.strategy != y.strategy)
                strategies.push_back(view);
            else if (x.parameters != y.parameters)
                parameters.push_back(view);
            if (withoutViewing(x.setup) != withoutViewing(y.setup)) setups.push_back(view);
            if (!(x.setup.viewing == y.setup.viewing)) viewing.push_back(view);
        }
    }

    [[nodiscard]] bool any() const { return linkedCamera || hidden || !viewing.empty() || views() > 0; }
    /// The number of differences besides cameras and hidden objects.
    [[nodiscard]] size_t views() const { return strategies.size() + parameters.size() + setups.size(); }
};

}  // namespace

bool differInUndoable(const SessionState& a, const SessionState& b) { return Difference(a, b).any(); }

SessionState withDifference(const SessionState& base, const SessionState& from, const SessionState& to) {
    SessionState result = base;
    carry(result.camera, from.camera, to.camera);
    carry(result.up, from.up, to.up);
    carry(result.chosenNear, from.chosenNear, to.chosenNear);
    carry(result.hidden, from.hidden, to.hidden);
    for (size_t view = 0; view < result.views.size(); ++view) {
        SessionState::View& changed = result.views[view];
        const SessionState::View &before = from.views[view], &after = to.views[view];
        if (before.strategy != after.strategy || before.parameters != after.parameters) {
            changed.strategy = after.strategy;
            changed.parameters = after.parameters;
        }
        Camera viewing = changed.setup.viewing;
        carry(viewing, before.setup.viewing, after.setup.viewing);
        if (withoutViewing(before.setup) != withoutViewing(after.setup)) changed.setup = after.setup;
        changed.setup.viewing = viewing;
    }
    return result;
}

UndoStep::UndoStep(SessionState before, SessionState after, std::function<SessionState()> current, Apply apply)
    : m_before(std::move(before)), m_after(std::move(after)), m_current(std::move(current)), m_apply(std::move(apply)) {}

void UndoStep::redo() {
    if (!std::exchange(m_done, false)) go(m_before, m_after);
}

void UndoStep::go(const SessionState& from, const SessionState& to) const { m_apply(withDifference(m_current(), from, to)); }

QString UndoStep::name() const {
    const Difference difference(m_before, m_after);
    if (difference.views() == 0) {
        if (difference.hidden) return tr("hidden objects");
        if (difference.linkedCamera || difference.viewing.size() != 1) return tr("camera");
        return tr("camera of view %1").arg(viewLetter(difference.viewing.front()));
    }
    if (difference.views() > 1 || difference.hidden) return tr("several changes");
    if (!difference.strategies.empty()) return tr("strategy of view %1").arg(viewLetter(difference.strategies.front()));
    if (!difference.parameters.empty()) return tr("parameters of view %1").arg(viewLetter(difference.parameters.front()));
    return tr("display of view %1").arg(viewLetter(difference.setups.front()));
}

}  // namespace cullscope::ui
