// Writes steps of lessons: what differs between the sessions of two steps, as lines.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/visibility/registry.h"
#include "ui/session/lesson.h"
#include "ui/session/session_file.h"
#include "ui/session/session_json.h"

namespace cullscope::ui {

namespace {

/// A lesson's steps begin from this one.
LessonStep stepBeforeTheFirst() { return lessonFromText("title en -\nstep\nsay en -\n", {}).steps.front(); }

std::map<std::string, std::string> withoutDefaults(const SessionState::View& view) {
    const ParameterSet defaults(findStrategy(view.strategy).info.parameters);
    std::map<std::string, std::string> parameters = view.parameters;
    std::erase_if(parameters, [&](const auto& each) { return each.second == toText(defaults.value(each.first)); });
    return parameters;
}

/// What a step says of a state: nothing of the window, and of views that are not seen what the step before said.
SessionState reduced(SessionState state, const SessionState& before) {
    state.arrangement.clear();
    state.bookmarks = {};
    state.style.reset();
    if (std::ranges::find(state.hidden, true) == state.hidden.end()) state.hidden.clear();
    for (int view = 0; view < Session::kMostViews; ++view) {
        SessionState::View& mine = state.views[size_t(view)];
        const SessionState::View& former = before.views[size_t(view)];
        if (!isSeen(state, view)) mine = former;
        mine.parameters = withoutDefaults(mine);
        if (mine.setup.role == Role::Linked) mine.setup.viewing = former.setup.viewing;
        if (mine.setup.role != Role::Frozen) mine.setup.culling = former.setup.culling;
    }
    return state;
}

Json sessionJsonOf(const SessionState& state, const std::filesystem::path& file) { return Json::parse(stateToText(state, file)); }

/// The session of a step, without the cameras that it leaves to the program: they differ from any that is given.
Json sessionJsonOf(const LessonStep& step, const SessionState& now, const std::filesystem::path& file) {
    SessionState state = step.state;
    for (SessionState::View& view : state.views) view.parameters = withoutDefaults(view);
    Json json = sessionJsonOf(state, file);
    if (step.defaultScene) json.erase("scene");
    if (!step.saysUp) json.erase("up");
    if (step.camera.kind != CameraChoice::Kind::Given) json.erase("camera");
    for (size_t view = 0; view < step.viewing.size(); ++view) {
        const Role role = now.views[view].setup.role;
        if (role != Role::Linked && step.viewing[view].kind != CameraChoice::Kind::Given) json["views"][view].erase("viewing");
        if (role == Role::Frozen && step.culling[view].kind != CameraChoice::Kind::Given) json["views"][view].erase("culling");
        // With another strategy, a step begins with its default parameters.
        if (now.views[view].strategy != state.views[view].strategy) json["views"][view]["parameters"] = Json::object();
    }
    return json;
}

std::string textOf(const Json& value) {
    if (!value.is_string()) return value.dump();
    const auto& text = value.get_ref<const std::string&>();
    const bool plain = !text.empty() && text.front() != '"' && text.find_first_of("\r\n\t") == std::string::npos &&
                       text.front() != ' ' && text.back() != ' ' && !Json::accept(text) &&
                       !(text.size() == 1 && text[0] >= 'A' && text[0] < 'A' + Session::kMostViews);
    return plain ? text : value.dump();
}

void writeDifference(std::ostream& out, const std::string& name, const Json* before, const Json& now) {
    // A camera is one value.
    if (!now.is_object() || now.contains("eye")) {
        if (!before || *before != now) out << name << ' ' << textOf(now) << '\n';
        return;
    }
    const auto under = [&](const std::string& key) { return name.empty() ? key : name + '.' + key; };
    for (const auto& [key, value] : now.items()) {
        const bool has = before && before->is_object() && before->contains(key);
        writeDifference(out, under(key), has ? &before->at(key) : nullptr, value);
    }
    if (!before || !before->is_object()) return;
    for (const auto& [key, value] : before->items())
        if (!now.contains(key)) out << under(key) << " null\n";
}

std::string oneLine(std::string text) {
    for (char& letter : text)
        if (letter == '\n' || letter == '\r') letter = ' ';
    return text;
}

void writeTexts(std::ostream& out, const char* key, const LessonText& texts) {
    for (const auto& [language, words] : texts) out << key << ' ' << language << ' ' << oneLine(words) << '\n';
}

}  // namespace

std::string stepText(const Lesson& before, const SessionState& state, const LessonText& sentence,
                     const std::filesystem::path& file) {
    const LessonStep last = before.steps.empty() ? stepBeforeTheFirst() : before.steps.back();
    const SessionState reducedState = reduced(state, last.state);
    Json was = sessionJsonOf(last, reducedState, file), now = sessionJsonOf(reducedState, file);
    std::ostringstream out;
    out << "step\n";
    writeTexts(out, "say", sentence);
    Json formerViews = was["views"], views = now["views"];
    for (Json* json : {&was, &now}) json->erase("views");
    writeDifference(out, {}, &was, now);
    for (size_t view = 0; view < views.size(); ++view)
        writeDifference(out, std::string(1, char('A' + view)), &formerViews[view], views[view]);
    return out.str();
}

void appendStep(const std::filesystem::path& file, const LessonText& title, const SessionState& state,
                const LessonText& sentence) {
    std::string text;
    Lesson lesson;
    if (std::filesystem::exists(file)) {
        lesson = loadLesson(file);
        std::ifstream in(file, std::ios::binary);
        std::ostringstream all;
        all << in.rdbuf();
        text = all.str();
        if (!text.ends_with('\n')) text += '\n';
    } else {
        std::ostringstream head;
        writeTexts(head, "title", title);
        text = head.str();
    }
    text += '\n' + stepText(lesson, state, sentence, file);
    // What is written can be read.
    (void)lessonFromText(text, file);
    writeFileAtomically(file, [&](std::ostream& out) { out << text; });
}

}  // namespace cullscope::ui
