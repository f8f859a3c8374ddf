#include "ui/session/session_file.h"

#include <QCoreApplication>
#include <fstream>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/scene/gallery/gallery.h"
#include "core/scene/hidden.h"
#include "ui/session/session_json.h"
#include "ui/session/view_sizes.h"

namespace cullscope::ui {

namespace {

constexpr const char* kFormat = "cullscope session";
constexpr int kVersion = 1;
constexpr int kMostObjects = 100'000'000;
constexpr size_t kMostValues = 100'000;
constexpr uintmax_t kMostBytes = 64u << 20;  // a session has about 20 kB; a mesh with that file name is not read

constexpr std::array kUpAxes{std::pair<const char*, UpAxis>{"y", UpAxis::Y}, std::pair<const char*, UpAxis>{"z", UpAxis::Z}};

bool isGeneratorsName(const std::string& file) {
    const std::string id = file.substr(0, file.find(':'));
    const auto isKnown = [&](const std::vector<GeneratorInfo>& known) {
        return std::any_of(known.begin(), known.end(), [&](const GeneratorInfo& info) { return info.id == id; });
    };
    return isKnown(sceneGenerators()) || isKnown(galleryInfos());
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return std::filesystem::path(absoluteFile(file.string())).parent_path();
}

std::string relativeTo(const std::filesystem::path& folder, const std::string& file) {
    const std::string relative = std::filesystem::path(absoluteFile(file)).lexically_relative(folder).string();
    if (relative.empty()) return file;  // there is no way from one to the other: a working folder is gone
    // A file with the name of a generator must not be read as that generator.
    return isGeneratorsName(relative) ? "./" + relative : relative;
}

Json jsonOfState(const SessionState& state, const std::string& scene) {
    Json json{{"format", kFormat}, {"version", kVersion}, {"scene", scene}};
    json["objects"] = state.hidden.size();
    json["hidden"] = hiddenToText(state.hidden);
    json["up"] = state.up == UpAxis::Y ? "y" : "z";
    json["camera"] = jsonOf(state.camera);
    json["chosen_near"] = state.chosenNear ? Json(*state.chosenNear) : Json();
    if (state.section) json["section"] = sectionText(*state.section);
    json["arrangement"] = state.arrangement;
    json["view_count"] = state.viewCount;
    json["active_view"] = state.activeView;
    if (state.place) json["place"] = {{"entry", state.place->entries}, {"of", state.place->whole}};
    if (!state.structurePanel.page.empty()) json["inside"]["page"] = state.structurePanel.page;
    if (!state.structurePanel.map.empty()) json["inside"]["map"] = state.structurePanel.map;
    if (state.style) json["colours"] = jsonOf(*state.style);
    for (const SessionState::View& view : state.views) json["views"].push_back(jsonOf(view));
    for (const std::optional<CameraBookmark>& place : state.bookmarks) {
        json["bookmarks"].push_back(place ? jsonOf(static_cast<const Camera&>(*place)) : Json());
        if (place && !place->name.empty()) json["bookmarks"].back()["name"] = place->name;
    }
    return json;
}

nlohmann::json parsed(std::string_view text, const std::string& file) {
    size_t values = 0;
    // The tree of a text's values takes twenty times its memory and more: that of a session has some thousand values.
    const auto count = [&](int, nlohmann::json::parse_event_t, const nlohmann::json&) {
        if (++values > kMostValues)
            throwInput(QT_TRANSLATE_NOOP("core", "%1 is no session that can be read: it has more than %2 values."),
                       {file, std::to_string(kMostValues)});
        return true;
    };
    try {
        return nlohmann::json::parse(text, count);
    } catch (const nlohmann::json::parse_error& failure) {
        throwInput(QT_TRANSLATE_NOOP("core", "%1 is no session that can be read: it is not JSON from byte %2 on."),
                   {file, std::to_string(failure.byte)});
    } catch (const nlohmann::json::out_of_range&) {
        throwInput(QT_TRANSLATE_NOOP("core", "%1 is no session that can be read: a number in it is too large."), {file});
    }
}

bool isSession(const nlohmann::json& json) { return json.is_object() && json.contains("format") && json["format"] == kFormat; }

void requireVersion(const JsonField& version, const std::string& file) {
    if (version.wholeNumber(1, std::numeric_limits<int>::max()) > kVersion)
        throwInput(QT_TRANSLATE_NOOP("core", "%1 was saved by a newer Cullscope: install that one to open it."), {file});
}

/// A scene specification with absolute file paths; relative ones are relative to `folder`.
std::string readScene(const JsonField& field, const std::filesystem::path& folder) {
    const std::string& scene = field.text();
    if (scene.empty())
        field.checked([] { throwInput(QT_TRANSLATE_NOOP("core", "name a mesh file or a generator such as bunny.")); });
    return withFiles(scene, [&](const std::string& file) { return (folder / file).lexically_normal().string(); });
}

std::vector<bool> readHidden(const JsonField& json) {
    const std::optional<JsonField> hidden = json.find("hidden");
    if (!hidden) return {};
    const size_t objects = size_t(json.at("objects").wholeNumber(0, kMostObjects));
    return hidden->checked([&] { return hiddenFromText(hidden->text(), objects); });
}

Section readSection(const JsonField& field) {
    const std::optional<Section> section = sectionFromText(field.text());
    if (!section)
        field.checked([] { throwInput(QT_TRANSLATE_NOOP("core", "write x, y, z or view, and a share, as in \"x:0.5\".")); });
    return section.value_or(Section{});
}

void readViews(const JsonField& list, SessionState& state) {
    const size_t count = list.listSize(state.views.size());
    std::vector<ViewSetup> setups;
    for (size_t view = 0; view < count; ++view) {
        state.views[view] = readView(list.at(view));
        setups.push_back(state.views[view].setup);
    }
    list.checked([&] {
        if (const auto why = tooManyPixels(setups, kMostPixelsOfSession)) throwInput(why->text, why->arguments);
    });
    for (size_t view = 0; view < count; ++view) {
        const ViewSetup& setup = state.views[view].setup;
        if (setup.role != Role::Observer) continue;
        const size_t observed = size_t(setup.observed);
        if (observed == view || state.views[observed].setup.role == Role::Observer)
            list.at(view).at("observed").checked([] {
                throwInput(QT_TRANSLATE_NOOP("core", "a view can watch only another one that is no observer itself."));
            });
    }
}

void readBookmarks(const JsonField& list, CameraBookmarks::Places& places) {
    const size_t count = list.listSize(places.size());
    for (size_t place = 0; place < count; ++place)
        if (const JsonField bookmark = list.at(place); !bookmark.isNull()) {
            places[place] = readCamera(bookmark);
            if (const auto name = bookmark.find("name")) places[place]->name = name->text();
        }
}

void readWindow(const JsonField& json, SessionState& state) {
    if (const auto text = json.find("arrangement")) state.arrangement = text->text();
    if (const auto active = json.find("active_view")) state.activeView = active->wholeNumber(0, Session::kMostViews - 1);
    if (const auto count = json.find("view_count")) {
        state.viewCount = count->wholeNumber(1, Session::kMostViews);
        const auto& known = Session::kViewCounts;
        if (std::find(known.begin(), known.end(), state.viewCount) == known.end())
            count->checked([] { throwInput(QT_TRANSLATE_NOOP("core", "there are 1, 2, 4, 6 or 8 views.")); });
    }
}

LogPlace readPlace(const JsonField& place) {
    const int whole = place.at("of").wholeNumber(1, std::numeric_limits<int>::max());
    return {size_t(place.at("entry").wholeNumber(0, whole)), size_t(whole)};
}

void readStructurePanel(const JsonField& inside, SessionState& state) {
    if (const auto page = inside.find("page")) state.structurePanel.page = page->text();
    if (const auto map = inside.find("map")) state.structurePanel.map = map->text();
}

SessionState readState(const JsonField& json, const std::filesystem::path& file) {
    requireVersion(json.at("version"), file.string());
    SessionState state;
    state.scene = readScene(json.at("scene"), folderOf(file));
    state.hidden = readHidden(json);
    if (const auto up = json.find("up")) state.up = up->oneOf<UpAxis>(JsonField::Words<UpAxis>(kUpAxes));
    state.camera = readCamera(json.at("camera"));
    if (const auto near = json.find("chosen_near")) {
        state.chosenNear = near->number();
        if (!(*state.chosenNear > 0.0))
            near->checked([] { throwInput(QT_TRANSLATE_NOOP("core", "the near distance must be above 0.")); });
    }
    readWindow(json, state);
    if (const auto place = json.find("place")) state.place = readPlace(*place);
    if (const auto inside = json.find("inside")) readStructurePanel(*inside, state);
    if (const auto section = json.find("section")) state.section = readSection(*section);
    if (const auto colours = json.find("colours")) state.style = readStyle(*colours);
    readViews(json.at("views"), state);
    if (const auto bookmarks = json.find("bookmarks")) readBookmarks(*bookmarks, state.bookmarks);
    return state;
}

}  // namespace

std::string stateToText(const SessionState& state, const std::filesystem::path& file) {
    if (state.scene.empty()) throwUsage(QT_TRANSLATE_NOOP("core", "There is no scene to save yet: open one first."));
    std::string scene = withAbsoluteFiles(state.scene);
    if (!file.empty())
        scene = withFiles(scene, [folder = folderOf(file)](const std::string& mesh) { return relativeTo(folder, mesh); });
    try {
        return jsonOfState(state, scene).dump(1) + "\n";
    } catch (const nlohmann::json::type_error&) {
        throwUsage(
            QT_TRANSLATE_NOOP("core", "The name of the scene's file is no UTF-8, which a session needs: rename the file."));
    }
}

std::optional<SessionState> stateFromText(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parsed(text, file.string());
    if (!isSession(json)) return std::nullopt;
    return stateFromJson(json, file);
}

SessionState stateFromJson(const nlohmann::json& json, const std::filesystem::path& file) {
    return readState(JsonField(json, file.string()), file);
}

void saveSession(const std::filesystem::path& file, const SessionState& state) {
    const std::string text = stateToText(state, file);
    writeFileAtomically(file, [&](std::ostream& out) { out << text; });
}

SessionState loadSession(const std::filesystem::path& file) {
    std::error_code failure;
    const uintmax_t bytes = std::filesystem::file_size(file, failure);
    std::ifstream in(file, std::ios::binary);
    if (failure || !in)
        throwInput(QT_TRANSLATE_NOOP("core", "%1 cannot be opened: check the name and that you may read it."), {file.string()});
    if (bytes <= kMostBytes) {
        std::stringstream text;
        text << in.rdbuf();
        if (std::optional<SessionState> state = stateFromText(text.str(), file)) return *state;
    }
    throwInput(
        QT_TRANSLATE_NOOP("core", "%1 is no session that Cullscope saved. Open a mesh, a session, or a picture of Cullscope."),
        {file.string()});
}

}  // namespace cullscope::ui
