#include "ui/screenshots/screenshot_options.h"

#include <array>

#include "core/base/json.h"
#include "core/scene/camera.h"

namespace cullscope::ui {

namespace {

constexpr std::array kBackgrounds{std::pair{"as shown", ScreenshotOptions::Background::AsShown},
                                  std::pair{"white", ScreenshotOptions::Background::White},
                                  std::pair{"black", ScreenshotOptions::Background::Black},
                                  std::pair{"transparent", ScreenshotOptions::Background::Transparent}};

void read(const Json& json, const char* key, bool& value) {
    if (json.contains(key) && json[key].is_boolean()) value = json[key].get<bool>();
}

std::optional<Viewport> sizeOf(const Json& json) {
    if (!json.is_array() || json.size() != 2 || !json[0].is_number_integer() || !json[1].is_number_integer()) return std::nullopt;
    const auto width = json[0].get<int64_t>(), height = json[1].get<int64_t>();
    if (std::min(width, height) < 1 || std::max(width, height) > kMostPixels) return std::nullopt;
    return Viewport{int(width), int(height)};
}

}  // namespace

std::string optionsText(const ScreenshotOptions& options) {
    Json json;
    if (options.size) json["size"] = {options.size->width, options.size->height};
    json["grid"] = options.grid;
    json["overlays"] = options.overlays;
    json["legend"] = options.legend;
    json["caption"] = options.caption;
    if (!options.captionText.isEmpty()) json["caption_text"] = options.captionText.toStdString();
    for (const auto& [word, background] : kBackgrounds)
        if (background == options.background) json["background"] = word;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ScreenshotOptions screenshotOptionsFromText(std::string_view text) {
    ScreenshotOptions options;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return options;
    if (json.contains("size")) options.size = sizeOf(json["size"]);
    read(json, "grid", options.grid);
    read(json, "overlays", options.overlays);
    read(json, "legend", options.legend);
    read(json, "caption", options.caption);
    if (json.contains("caption_text") && json["caption_text"].is_string())
        options.captionText = QString::fromStdString(json["caption_text"].get<std::string>());
    for (const auto& [word, background] : kBackgrounds)
        if (json.contains("background") && json["background"] == word) options.background = background;
    return options;
}

}  // namespace cullscope::ui
