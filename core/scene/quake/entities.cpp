#include "core/scene/quake/entities.h"

#include <charconv>
#include <cmath>

#include "core/mesh/numbers_in_text.h"

namespace cullscope::quake {

std::string_view Entity::value(std::string_view key) const {
    for (const Pair& pair : pairs)
        if (pair.key == key) return pair.value;
    return {};
}

Vec3 Entity::origin() const {
    std::string_view rest = value("origin");
    Vec3 place(0.0);
    for (int axis = 0; axis < 3; ++axis)
        if (!parseReal(takeWord(rest), place[axis]) || !std::isfinite(place[axis])) return Vec3(0.0);
    return place;
}

std::optional<uint32_t> Entity::model() const {
    const std::string_view text = value("model");
    uint32_t number = 0;
    if (!text.starts_with('*')) return std::nullopt;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::vector<Entity> readEntities(std::string_view text, const std::function<void(size_t byte)>& refuse) {
    std::vector<Entity> entities;
    bool within = false;
    std::optional<std::string> key;
    for (size_t at = 0; at < text.size(); ++at) {
        const char letter = text[at];
        if (letter == '{' && !within) {
            entities.emplace_back();
            within = true;
        } else if (letter == '}' && within && !key) {
            within = false;
        } else if (letter == '"' && within) {
            const size_t end = text.find('"', at + 1);
            if (end == std::string_view::npos) refuse(at);
            std::string word(text.substr(at + 1, end - at - 1));
            if (key) {
                entities.back().pairs.push_back({std::move(*key), std::move(word)});
                key.reset();
            } else {
                key = std::move(word);
            }
            at = end;
        } else if (static_cast<unsigned char>(letter) > ' ') {
            refuse(at);
        }
    }
    if (within) refuse(text.size());
    return entities;
}

}  // namespace cullscope::quake
