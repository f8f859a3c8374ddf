#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope::quake {

/// What a level places in itself: a key and its value each, such as "classname" "func_door".
struct Entity {
    struct Pair {
        std::string key, value;
    };
    std::vector<Pair> pairs;

    /// Empty where the entity does not have the key.
    [[nodiscard]] std::string_view value(std::string_view key) const;
    /// Where "origin" places it; 0 without one or where it is no three finite numbers.
    [[nodiscard]] Vec3 origin() const;
    /// The number of the model of "model" "*N"; none for entities without one.
    [[nodiscard]] std::optional<uint32_t> model() const;
};

/// Reads the text of a level's entities: { "key" "value" … } for each. `refuse` is called, and throws, with the byte within the
/// text at which it is none.
[[nodiscard]] std::vector<Entity> readEntities(std::string_view text, const std::function<void(size_t byte)>& refuse);

}  // namespace cullscope::quake
