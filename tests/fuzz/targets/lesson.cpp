#include <nlohmann/json.hpp>

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"
#include "ui/session/lesson.h"
#include "ui/session/session_file.h"

namespace cullscope::fuzz {

void lesson(std::string_view input) {
    const std::filesystem::path file = scratchFolder() / "input.lesson";
    ui::Lesson lesson;
    if (!accepted({ErrorKind::Input}, [&] { lesson = ui::lessonFromText(input, file); })) return;
    require(!lesson.steps.empty(), "a lesson has no step");
    // What a step shows can be added as another step, and is read back.
    const ui::LessonStep last = lesson.steps.back();
    const std::string text =
        "title en -\nstep\nsay en -\n\n" + ui::stepText({{{"en", "-"}}, {}}, last.state, {{"en", "-"}}, file);
    const ui::LessonStep added = ui::lessonFromText(text, file).steps.back();
    require(added.state.viewCount == last.state.viewCount && added.state.camera == last.state.camera,
            "a step that is added is read back as another one");
}

}  // namespace cullscope::fuzz
