#include "core/visibility/structure_store.h"

#include <chrono>

#include "core/base/error.h"

namespace cullscope {
namespace {

using Clock = std::chrono::steady_clock;

// How often a thread that waits for another's structure looks for a stop request.
constexpr std::chrono::milliseconds kWaiting{50};

}  // namespace

StructurePointer StructureStore::get(const RegisteredStrategy& strategy, const ParameterSet& parameters,
                                     const ScenePointer& scene, const Progress& progress) {
    const std::shared_ptr<Place> place = placeOf({scene.get(), strategy.strategy, parameters.buildText()});
    std::unique_lock lock(place->building, std::defer_lock);
    while (!lock.try_lock_for(kWaiting)) progress.check();
    if (StructurePointer known = place->structure.lock()) return known;
    const Clock::time_point start = Clock::now();
    const std::shared_ptr<Structure> made = strategy.strategy->build(scene, parameters, progress);
    made->report.buildMilliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    try {
        strategy.strategy->prove(*made, progress);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Interrupted) throw;
        // A caller that stops gets a structure that promises less, and it is not kept for others.
        return made;
    }
    place->structure = made;
    const std::lock_guard counting(m_mutex);
    ++m_built;
    std::erase_if(m_made, [](const auto& other) { return other.expired(); });
    m_made.push_back(made);
    return made;
}

size_t StructureStore::built() const {
    const std::lock_guard lock(m_mutex);
    return m_built;
}

uint64_t StructureStore::bytes() const {
    const std::lock_guard lock(m_mutex);
    uint64_t bytes = 0;
    for (const std::weak_ptr<const Structure>& one : m_made)
        if (const StructurePointer structure = one.lock()) bytes += structure->report.bytes;
    return bytes;
}

std::shared_ptr<StructureStore::Place> StructureStore::placeOf(const Key& key) {
    const std::lock_guard lock(m_mutex);
    // Of structures without a user only the places are left. One that is being built is held by its builder.
    std::erase_if(m_places, [](const auto& entry) { return entry.second.use_count() == 1 && entry.second->structure.expired(); });
    std::shared_ptr<Place>& place = m_places[key];
    if (!place) place = std::make_shared<Place>();
    return place;
}

}  // namespace cullscope
