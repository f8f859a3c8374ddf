#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"
#include "ui/session/session_file.h"

namespace cullscope::fuzz {

void session(std::string_view input) {
    const std::filesystem::path file = scratchFolder() / "input.cullscope";
    std::optional<ui::SessionState> state;
    accepted({ErrorKind::Input}, [&] { state = ui::stateFromText(input, file); });
    if (!state) return;
    // The desktop saves a strategy for every view, also for those that the file left out.
    for (ui::SessionState::View& view : state->views)
        if (view.strategy.empty()) view.strategy = state->views.front().strategy;
    const std::string text = ui::stateToText(*state, file);
    require(ui::stateFromText(text, file) == state, "a session that is saved is read back as another one");
}

}  // namespace cullscope::fuzz
