#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "core/visibility/registry.h"

namespace cullscope {

/// The structures in use, each built once for a scene, a strategy and those of its parameters that are read when building. A
/// structure is freed when the last of its users leaves it. Thread-safe; different structures are built at the same time.
class StructureStore {
public:
    /// The structure, built here if no user has it; where another thread is building it, waits for that one. Throws what
    /// Strategy::build throws.
    [[nodiscard]] StructurePointer get(const RegisteredStrategy& strategy, const ParameterSet& parameters,
                                       const ScenePointer& scene, const Progress& progress = {});
    /// How many structures were built so far.
    [[nodiscard]] size_t built() const;
    /// Bytes of those that have users (StructureReport::bytes), each structure once.
    [[nodiscard]] uint64_t bytes() const;

private:
    struct Key {
        const Scene* scene = nullptr;
        std::shared_ptr<const Strategy> strategy;  ///< itself and not its id: another one may have the same
        std::string parameters;                    ///< those that are read when building

        auto operator<=>(const Key&) const = default;
    };
    struct Place {
        std::timed_mutex building;
        std::weak_ptr<const Structure> structure;
    };

    [[nodiscard]] std::shared_ptr<Place> placeOf(const Key& key);

    mutable std::mutex m_mutex;
    std::map<Key, std::shared_ptr<Place>> m_places;
    size_t m_built = 0;
    std::vector<std::weak_ptr<const Structure>> m_made;  ///< those built, but for some that are freed
};

}  // namespace cullscope
