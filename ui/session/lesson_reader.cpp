// Reads lessons: lines that set values of a session, by the same fields as session files.
#include <QCoreApplication>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/visibility/registry.h"
#include "ui/session/lesson.h"
#include "ui/session/session_file.h"
#include "ui/session/session_json.h"
#include "ui/text/language_ids.h"

namespace cullscope::ui {

namespace {

using LessonJson = nlohmann::json;

constexpr size_t kMostLessonBytes = 256u << 10;
constexpr size_t kMostLessonSteps = 200;
constexpr int kDeepestValue = 4;
constexpr size_t kDeepestPath = 5;

std::string_view trimmedLine(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r";
    const size_t first = text.find_first_not_of(kSpace);
    return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// The first word of a line, and what follows it.
std::pair<std::string, std::string> cutWord(std::string_view line) {
    const size_t end = std::min(line.find_first_of(" \t"), line.size());
    return {std::string(line.substr(0, end)), std::string(trimmedLine(line.substr(end)))};
}

bool isUtf8Line(std::string_view text) {
    try {
        (void)LessonJson(std::string(text)).dump();
        return true;
    } catch (const LessonJson::type_error&) {
        return false;
    }
}

bool isViewLetter(std::string_view text) { return text.size() == 1 && text[0] >= 'A' && text[0] < 'A' + Session::kMostViews; }

/// `A.look.frustum` as the names of fields in a session: views, 0, look, frustum.
std::vector<std::string> sessionFields(const std::string& key) {
    std::vector<std::string> fields;
    std::istringstream parts(key);
    for (std::string part; std::getline(parts, part, '.');) fields.push_back(part);
    if (!fields.empty() && isViewLetter(fields.front())) {
        const int view = fields.front()[0] - 'A';
        fields.front() = "views";
        fields.insert(fields.begin() + 1, std::to_string(view));
    }
    return fields;
}

/// As JsonField names places: `views[0].look.frustum`.
std::string lessonPlaceOf(const std::vector<std::string>& fields) {
    std::string place = fields.front();
    for (size_t i = 1; i < fields.size(); ++i)
        place += i == 1 && fields.front() == "views" ? "[" + fields[i] + "]" : "." + fields[i];
    return place;
}

const LessonJson* findField(const LessonJson& json, const std::vector<std::string>& fields) {
    const LessonJson* value = &json;
    for (const std::string& field : fields) {
        if (value->is_array()) {
            if (field.size() != 1 || size_t(field[0] - '0') >= value->size()) return nullptr;
            value = &(*value)[size_t(field[0] - '0')];
            continue;
        }
        const auto found = value->is_object() ? value->find(field) : value->end();
        if (!value->is_object() || found == value->end()) return nullptr;
        value = &*found;
    }
    return value;
}

class LessonReader {
public:
    LessonReader(std::string_view text, const std::filesystem::path& file) : m_text(text), m_file(file) { startAnew(); }

    Lesson read();

private:
    void startAnew();
    void readLine(std::string_view line);
    void readText(LessonText& text, const std::string& value);
    void set(const std::string& key, const std::string& value);
    [[nodiscard]] LessonJson valueOf(const std::string& text) const;
    void endStep();
    [[nodiscard]] CameraChoice takeCamera(LessonJson& owner, const char* key, const std::string& place);
    [[nodiscard]] CameraChoice cameraChoice(LessonJson& value, const std::string& place);
    void requireKnown(const SessionState& state) const;
    [[nodiscard]] int lineOf(const std::string& place) const;
    [[noreturn]] void fail(int line, const char* sentence, std::vector<std::string> further = {}) const;

    std::string_view m_text;
    std::filesystem::path m_file;
    Lesson m_lesson;
    LessonJson m_session;
    std::map<std::string, std::pair<std::vector<std::string>, int>> m_set;  ///< by place: its fields, and the line that set it
    LessonText m_sentence, m_notes;
    int m_line = 0;
    int m_stepLine = 0;  ///< 0: before the first step
};

void LessonReader::fail(int line, const char* sentence, std::vector<std::string> further) const {
    std::vector<std::string> arguments{m_file.string() + ":" + std::to_string(line)};
    arguments.insert(arguments.end(), further.begin(), further.end());
    throwInput(sentence, std::move(arguments));
}

void LessonReader::startAnew() {
    m_session =
        LessonJson{{"format", "cullscope session"}, {"version", 1}, {"scene", kDefaultScene}, {"views", LessonJson::array()}};
    for (int view = 0; view < Session::kMostViews; ++view)
        m_session["views"].push_back(LessonJson{{"strategy", baselines().back()->id}});
}

Lesson LessonReader::read() {
    if (m_text.size() > kMostLessonBytes)
        throwInput(QT_TRANSLATE_NOOP("core", "%1 is no lesson that can be read: it has more than %2 bytes."),
                   {m_file.string(), std::to_string(kMostLessonBytes)});
    if (m_text.starts_with("\xEF\xBB\xBF")) m_text.remove_prefix(3);
    while (!m_text.empty()) {
        ++m_line;
        const size_t end = m_text.find('\n');
        readLine(trimmedLine(m_text.substr(0, end)));
        m_text.remove_prefix(end == std::string_view::npos ? m_text.size() : end + 1);
    }
    if (m_stepLine == 0)
        fail(std::max(1, m_line), QT_TRANSLATE_NOOP("core", "%1: a lesson needs a title and at least one line \"step\"."));
    endStep();
    return std::move(m_lesson);
}

void LessonReader::readLine(std::string_view line) {
    if (line.empty() || line.starts_with('#')) return;
    if (!isUtf8Line(line)) fail(m_line, QT_TRANSLATE_NOOP("core", "%1: the line is no UTF-8: save the file as UTF-8."));
    const auto& [key, value] = cutWord(line);
    if (key == "title" && m_stepLine == 0) return readText(m_lesson.title, value);
    if (key == "step" && value.empty()) {
        if (m_lesson.title.empty())
            fail(m_line, QT_TRANSLATE_NOOP("core", "%1: a lesson needs a title and at least one line \"step\"."));
        if (m_stepLine > 0) endStep();
        if (m_lesson.steps.size() == kMostLessonSteps)
            fail(m_line, QT_TRANSLATE_NOOP("core", "%1: a lesson has at most %2 steps."), {std::to_string(kMostLessonSteps)});
        m_stepLine = m_line;
        return;
    }
    if (m_stepLine > 0 && key == "say") return readText(m_sentence, value);
    if (m_stepLine > 0 && key == "note") return readText(m_notes, value);
    set(key, value);
}

void LessonReader::readText(LessonText& text, const std::string& value) {
    const auto [language, words] = cutWord(value);
    std::string known;
    for (const std::string_view id : kLanguageIds) known += (known.empty() ? "" : ", ") + std::string(id);
    if (std::ranges::find(kLanguageIds, language) == kLanguageIds.end())
        fail(m_line, QT_TRANSLATE_NOOP("core", "%1: \"%2\" is no language: write one of %3 before the sentence."),
             {language, known});
    if (words.empty()) fail(m_line, QT_TRANSLATE_NOOP("core", "%1: the sentence is missing."));
    if (!text.emplace(language, words).second)
        fail(m_line, QT_TRANSLATE_NOOP("core", "%1: there is a sentence in \"%2\" already."), {language});
}

LessonJson LessonReader::valueOf(const std::string& text) const {
    if (isViewLetter(text)) return text[0] - 'A';
    const auto limited = [this](int depth, LessonJson::parse_event_t, const LessonJson&) {
        if (depth > kDeepestValue) fail(m_line, QT_TRANSLATE_NOOP("core", "%1: the value has too many brackets."));
        return true;
    };
    LessonJson value;
    try {
        value = LessonJson::parse(text, limited);
    } catch (const nlohmann::json::exception&) {
        value = text;
    }
    return value;
}

void LessonReader::set(const std::string& key, const std::string& value) {
    const std::vector<std::string> fields = sessionFields(key);
    const bool named = !fields.empty() && std::ranges::none_of(fields, &std::string::empty);
    if (!named || fields.size() > kDeepestPath || (fields.size() == 1 && fields.front() == "views") || value.empty())
        fail(m_line, QT_TRANSLATE_NOOP("core", "%1: write a field of a session and its value, such as \"A.role observer\"."));
    LessonJson* owner = &m_session;
    const bool ofView = fields.front() == "views";
    if (ofView && (fields.size() < 3 || !isViewLetter(key.substr(0, 1)) || key.substr(1, 1) != "."))
        fail(m_line, QT_TRANSLATE_NOOP("core", "%1: write a field of a session and its value, such as \"A.role observer\"."));
    for (size_t i = 0; i + 1 < fields.size(); ++i) {
        if (owner->is_array()) {
            owner = &(*owner)[size_t(std::stoi(fields[i]))];
            continue;
        }
        LessonJson& group = (*owner)[fields[i]];
        if (!group.is_object() && !group.is_array()) group = LessonJson::object();
        if (group.is_array() && !(ofView && i == 0)) group = LessonJson::object();
        owner = &group;
    }
    // Parameters are texts. Those of one strategy are not those of another.
    const bool parameter =
        ofView && fields.size() == 4 && fields[2] == "parameters" && value != "null" && !value.starts_with('"');
    (*owner)[fields.back()] = parameter ? LessonJson(value) : valueOf(value);
    if (ofView && fields.size() == 3 && fields[2] == "strategy") {
        owner->erase("parameters");
        std::erase_if(
            m_set, [begin = "views[" + fields[1] + "].parameters"](const auto& each) { return each.first.starts_with(begin); });
    }
    m_set[lessonPlaceOf(fields)] = {fields, m_line};
}

CameraChoice LessonReader::cameraChoice(LessonJson& value, const std::string& place) {
    if (value.is_object()) return {CameraChoice::Kind::Given, {}, 0};
    const std::string text = value.is_string() ? value.get<std::string>() : std::string();
    if (text == "home") return {};
    std::istringstream words(text);
    std::vector<double> numbers;
    for (double number = 0.0; words >> number;) numbers.push_back(number);
    if (numbers.size() == 6 && words.eof()) {
        LessonJson camera = jsonOf(Camera{});
        camera["eye"] = LessonJson(std::vector(numbers.begin(), numbers.begin() + 3));
        camera["target"] = LessonJson(std::vector(numbers.begin() + 3, numbers.end()));
        value = camera;
        return {CameraChoice::Kind::Given, {}, 0};
    }
    const auto [path, pose] = cutWord(text);
    const bool digits = !pose.empty() && pose.size() < 7 && pose.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || path.empty())
        fail(lineOf(place), QT_TRANSLATE_NOOP("core",
                                              "%1: write \"home\", six numbers (where the camera stands and where it looks), "
                                              "or a camera path and the number of a pose from 0, such as \"case-1 3\"."));
    return {CameraChoice::Kind::Pose, path, size_t(std::stoul(pose))};
}

CameraChoice LessonReader::takeCamera(LessonJson& owner, const char* key, const std::string& place) {
    const auto found = owner.find(key);
    if (found == owner.end() || found->is_null()) return {};
    const CameraChoice choice = cameraChoice(*found, place);
    if (choice.kind != CameraChoice::Kind::Given) owner.erase(key);
    return choice;
}

int LessonReader::lineOf(const std::string& place) const {
    int line = m_stepLine;
    size_t longest = 0;
    for (const auto& [known, origin] : m_set) {
        const bool same = place.starts_with(known) || known.starts_with(place);
        if (!same || std::min(known.size(), place.size()) < longest) continue;
        longest = std::min(known.size(), place.size());
        line = origin.second;
    }
    return line;
}

/// A misspelt field would be passed over, as session files may have fields of later versions.
void LessonReader::requireKnown(const SessionState& state) const {
    const LessonJson known = LessonJson::parse(stateToText(state, {}));
    for (const auto& [place, origin] : m_set) {
        const LessonJson* set = findField(m_session, origin.first);
        if (set && !set->is_null() && !findField(known, origin.first))
            fail(origin.second, QT_TRANSLATE_NOOP("core", "%1: a session has no field \"%2\" here."), {place});
    }
}

void LessonReader::endStep() {
    if (m_sentence.empty()) fail(m_stepLine, QT_TRANSLATE_NOOP("core", "%1: the step has no sentence: add a line \"say\"."));
    LessonJson session = m_session;
    LessonStep step;
    step.sentence = std::exchange(m_sentence, {});
    step.notes = std::exchange(m_notes, {});
    step.saysUp = m_session.contains("up");
    step.defaultScene = session["scene"] == kDefaultScene;
    // A generator that needs no file is checked in its place.
    if (step.defaultScene) session["scene"] = "teapot";
    step.camera = takeCamera(session, "camera", "camera");
    if (step.camera.kind != CameraChoice::Kind::Given) session["camera"] = jsonOf(Camera{});
    const LessonJson count = session.value("view_count", LessonJson(2));
    for (size_t view = 0; view < step.viewing.size(); ++view) {
        // A view that is not shown watches none: the one that it watched may watch another one now.
        LessonJson& role = session["views"][view]["role"];
        if (count.is_number_unsigned() && count != 1 && view >= count.get<size_t>() && role == "observer") role = "linked";
        const std::string place = "views[" + std::to_string(view) + "]";
        step.viewing[view] = takeCamera(session["views"][view], "viewing", place + ".viewing");
        step.culling[view] = takeCamera(session["views"][view], "culling", place + ".culling");
    }
    try {
        step.state = stateFromJson(session, m_file);
        requireKnown(step.state);
    } catch (const Error& error) {
        Message message = error.message();
        if (!message.arguments.empty() && message.arguments.front().starts_with(m_file.string() + ":")) throw;
        // What is wrong with a scene's text is said without the file.
        if (message.arguments.empty() || message.arguments.front() != m_file.string())
            fail(lineOf("scene"), QT_TRANSLATE_NOOP("core", "%1: %2"), {message.english()});
        // The file's name is the first argument, the place in it the second.
        const int line = message.arguments.size() > 1 ? lineOf(message.arguments[1]) : m_stepLine;
        message.arguments.front() += ":" + std::to_string(line);
        throw Error(error.kind(), message);
    }
    m_lesson.steps.push_back(std::move(step));
}

}  // namespace

std::string textIn(const LessonText& text, const std::string& language) {
    for (const std::string& id : {language, std::string(kLanguageIds.front())})
        if (const auto found = text.find(id); found != text.end()) return found->second;
    return text.empty() ? std::string() : text.begin()->second;
}

Lesson lessonFromText(std::string_view text, const std::filesystem::path& file) { return LessonReader(text, file).read(); }

LessonText lessonTitle(std::string_view text) {
    LessonText title;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const auto [key, value] = cutWord(trimmedLine(line));
        if (key == "step") break;
        if (key == "title") title.insert(cutWord(value));
    }
    return title;
}

Lesson loadLesson(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::error_code failure;
    const uintmax_t bytes = std::filesystem::file_size(file, failure);
    if (failure || !in)
        throwInput(QT_TRANSLATE_NOOP("core", "%1 cannot be opened: check the name and that you may read it."), {file.string()});
    std::string text(size_t(std::min<uintmax_t>(bytes, kMostLessonBytes + 1)), '\0');
    in.read(text.data(), std::streamsize(text.size()));
    text.resize(size_t(in.gcount()));
    return lessonFromText(text, file);
}

}  // namespace cullscope::ui
