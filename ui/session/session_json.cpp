#include "ui/session/session_json.h"

#include "core/base/json.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

template <typename Enum>
using Word = std::pair<const char*, Enum>;

constexpr std::array kRoles{Word<Role>{"linked", Role::Linked}, Word<Role>{"observer", Role::Observer},
                            Word<Role>{"frozen", Role::Frozen}};
constexpr std::array kUploads{Word<Upload>{"vbo", Upload::Vbo}, Word<Upload>{"vertex-array", Upload::VertexArray}};
constexpr std::array kWipes{Word<Wipe::Mode>{"none", Wipe::Mode::None}, Word<Wipe::Mode>{"truth", Wipe::Mode::Truth},
                            Word<Wipe::Mode>{"loss", Wipe::Mode::Loss}, Word<Wipe::Mode>{"other-view", Wipe::Mode::OtherView},
                            Word<Wipe::Mode>{"difference", Wipe::Mode::Difference}};

constexpr std::array kProjections{Word<ProjectionKind>{"perspective", ProjectionKind::Perspective},
                                  Word<ProjectionKind>{"parallel", ProjectionKind::Parallel}};

constexpr const char* kFitsWindow = "window";
constexpr std::array kSizeWords{Word<std::optional<Viewport>>{kFitsWindow, std::nullopt}};

template <typename Enum, size_t Count>
const char* wordOf(const std::array<Word<Enum>, Count>& words, Enum value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return words.front().first;
}

template <typename Enum, size_t Count>
void read(const JsonField& group, const char* key, const std::array<Word<Enum>, Count>& words, Enum& value) {
    if (const auto field = group.find(key)) value = field->template oneOf<Enum>(JsonField::Words<Enum>(words));
}

void readViewNumber(const JsonField& group, const char* key, int& value) {
    if (const auto field = group.find(key)) value = field->wholeNumber(0, Session::kMostViews - 1);
}

Json jsonOf(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

/// The key of a show in files.
std::string keyOf(const Show& show) { return show.field.key.empty() ? show.id : show.field.key; }

Json jsonOf(const ViewLook& look) {
    Json json = Json::object();
    for (const Show* show : pictureShows()) {
        const bool on = look.shows(show->id);
        if (show->field.on.empty())
            json[keyOf(*show)] = on;
        else
            json[keyOf(*show)] = on ? show->field.on : show->field.off;
    }
    return json;
}

ViewLook readLook(const JsonField& field) {
    ViewLook look;
    for (const Show* show : pictureShows()) {
        const auto found = field.find(keyOf(*show).c_str());
        if (!found) continue;
        const std::array words{Word<bool>{show->field.off.c_str(), false}, Word<bool>{show->field.on.c_str(), true}};
        look.show(show->id, show->field.on.empty() ? found->boolean() : found->oneOf<bool>(JsonField::Words<bool>(words)));
    }
    return look;
}

Json jsonOf(const Wipe& wipe) {
    return {{"mode", wordOf(kWipes, wipe.mode)}, {"other", wipe.other}, {"position", wipe.position}};
}

Wipe readWipe(const JsonField& field) {
    Wipe wipe;
    read(field, "mode", kWipes, wipe.mode);
    readViewNumber(field, "other", wipe.other);
    if (const auto position = field.find("position")) wipe.position = position->number(0.0, 1.0);
    return wipe;
}

Json jsonOf(const Viewport& size) { return {{"width", size.width}, {"height", size.height}}; }

Viewport readSize(const JsonField& field) {
    return {field.at("width").wholeNumber(1, kMostPixels), field.at("height").wholeNumber(1, kMostPixels)};
}

}  // namespace

Json jsonOf(const Camera& camera) {
    // In radians: the conversion to degrees and back does not return every angle exactly.
    Json json{{"eye", jsonOf(camera.eye)},         {"target", jsonOf(camera.target)}, {"up", jsonOf(camera.up)},
              {"fovy_rad", camera.fovy.radians()}, {"near", camera.nearDistance},     {"far", camera.farDistance}};
    if (camera.projection == ProjectionKind::Parallel) {
        json["projection"] = projectionId(camera.projection);
        json["height"] = camera.height;
    }
    return json;
}

Camera readCamera(const JsonField& field) {
    Camera camera;
    camera.eye = field.at("eye").vector();
    camera.target = field.at("target").vector();
    camera.up = field.at("up").vector();
    camera.fovy = Angle::fromRadians(field.at("fovy_rad").number());
    camera.nearDistance = field.at("near").number();
    camera.farDistance = field.at("far").number();
    if (const auto projection = field.find("projection")) camera.projection = projection->oneOf<ProjectionKind>(kProjections);
    if (camera.projection == ProjectionKind::Parallel) camera.height = field.at("height").number();
    field.checked([&] { validate(camera, {1, 1}); });
    return camera;
}

Json jsonOf(const DrawStyle& style) {
    return {{"background", jsonOf(Vec3(style.background))}, {"surface", jsonOf(Vec3(style.surface))}};
}

DrawStyle readStyle(const JsonField& field) {
    DrawStyle style;
    style.background = Vec3f(field.at("background").vector());
    style.surface = Vec3f(field.at("surface").vector());
    return style;
}

Json jsonOf(const ViewSetup& setup) {
    Json json{{"role", wordOf(kRoles, setup.role)},
              {"observed", setup.observed},
              {"viewing", jsonOf(setup.viewing)},
              {"culling", jsonOf(setup.culling)}};
    if (setup.cullingSize) json["culling_size"] = jsonOf(*setup.cullingSize);
    json["size"] = setup.size ? jsonOf(*setup.size) : Json(kFitsWindow);
    json["upload"] = wordOf(kUploads, setup.upload);
    if (!setup.below.empty()) json["below"] = setup.below;
    if (!setup.panel.empty()) json["panel"] = setup.panel;
    json["look"] = jsonOf(setup.look);
    json["wipe"] = jsonOf(setup.wipe);
    return json;
}

ViewSetup readSetup(const JsonField& field) {
    ViewSetup setup;
    read(field, "role", kRoles, setup.role);
    readViewNumber(field, "observed", setup.observed);
    if (const auto viewing = field.find("viewing")) setup.viewing = readCamera(*viewing);
    if (const auto culling = field.find("culling")) setup.culling = readCamera(*culling);
    if (const auto size = field.find("culling_size")) setup.cullingSize = readSize(*size);
    if (const auto size = field.find("size")) {
        if (size->isText())
            setup.size = size->oneOf<std::optional<Viewport>>(kSizeWords);
        else
            setup.size = readSize(*size);
    }
    read(field, "upload", kUploads, setup.upload);
    if (const auto below = field.find("below")) setup.below = below->text();
    if (const auto panel = field.find("panel")) setup.panel = panel->text();
    if (const auto look = field.find("look")) setup.look = readLook(*look);
    if (const auto wipe = field.find("wipe")) setup.wipe = readWipe(*wipe);
    return setup;
}

ParameterSet parametersOf(const SessionState::View& view) {
    ParameterSet parameters(findStrategy(view.strategy).info.parameters);
    for (const auto& [key, text] : view.parameters) parameters.setFromText(key, text);
    return parameters;
}

Json jsonOf(const SessionState::View& view) {
    Json json{{"strategy", view.strategy}, {"parameters", Json::object()}};
    for (const auto& [key, text] : view.parameters) json["parameters"][key] = text;
    json.update(jsonOf(view.setup));
    return json;
}

SessionState::View readView(const JsonField& field) {
    SessionState::View view;
    const JsonField strategy = field.at("strategy");
    view.strategy = strategy.text();
    // Check the strategy first: with an unknown one its parameters would be reported as wrong too.
    strategy.checked([&] { (void)parametersOf(view); });
    view.setup = readSetup(field);
    if (const auto parameters = field.find("parameters"))
        parameters->forEach([&](const std::string& key, const JsonField& value) {
            view.parameters.emplace(key, value.text());
            value.checked([&] { (void)parametersOf(view); });
        });
    return view;
}

}  // namespace cullscope::ui
