#pragma once

#include "core/frame/curve.h"
#include "core/visibility/spherical/map_details.h"
#include "core/visibility/strategy.h"

namespace cullscope::spherical {

/// The shows of strategies that decide by cells of maps: spheres with rays, contour bands and their sizes, and the index map.
[[nodiscard]] std::vector<Show> showsOfBands(bool slopes);
/// The shows of strategies that decide by a quadtree over each map: spheres with cells, the inner kernel, and the index map.
[[nodiscard]] std::vector<Show> showsOfCells();

// What Strategy (strategy.h) says of a show, by the snapshot of a recorded frame.

[[nodiscard]] std::vector<OverlayLines> mapOverlay(std::string_view id, const OverlayContext& context,
                                                   const StructureSnapshot& snapshot);
[[nodiscard]] std::optional<Message> whyNoMapShow(std::string_view id, std::string_view colouring, std::string_view strategy,
                                                  const StructureSnapshot& snapshot, const Scene& scene);
/// The decision that is shown: that about `object`, else the one that placeOfDecision (map_details.h) chooses. Null: the frame
/// has none.
[[nodiscard]] std::optional<SphericalDecision> shownDecision(const FrameLog& log, const std::optional<uint32_t>& object);
[[nodiscard]] CellMapPointer indexMapOf(MapSnapshot map, const Scene& scene);
[[nodiscard]] Curve curveOf(const SphericalDecision& decision, const Scene& scene, const std::optional<uint32_t>& part);
[[nodiscard]] std::string mapLine(const StructureSnapshot& snapshot, const Scene& scene);
/// Appends the steps of the decision about a triangle (why.h).
void addMapStepsOf(const StructureSnapshot& snapshot, const FrameLog& log, uint32_t instance, uint32_t triangle,
                   std::vector<WhyStep>& steps);

/// A strategy whose snapshots have MapDetails, with its id.
template <typename OwnStructure>
class StrategyWithMaps : public StrategyWith<OwnStructure> {
public:
    explicit StrategyWithMaps(std::string id) : m_id(std::move(id)) {}

    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view id, const OverlayContext& context,
                                                    const Structure& structure, const FrameLog& log) const final {
        return mapOverlay(id, context, this->snapshot(structure, log));
    }
    [[nodiscard]] std::optional<Message> whyNotShown(std::string_view id, std::string_view colouring, const Structure& structure,
                                                     const FrameLog& log) const final {
        return whyNoMapShow(id, colouring, m_id, this->snapshot(structure, log), structure.scene());
    }
    [[nodiscard]] CellMapPointer directionMap(std::string_view /*id*/, const Structure& structure, const FrameLog& log,
                                              const std::optional<uint32_t>& object) const final {
        const std::optional<SphericalDecision> shown = shownDecision(log, object);
        if (!shown) return nullptr;
        return indexMapOf(mapOfDecision(this->own(structure), log, *shown), structure.scene());
    }
    [[nodiscard]] std::optional<Curve> curve(std::string_view /*id*/, const Structure& structure, const FrameLog& log,
                                             const std::optional<uint32_t>& object,
                                             const std::optional<uint32_t>& part) const final {
        const std::optional<SphericalDecision> shown = shownDecision(log, object);
        if (!shown) return std::nullopt;
        return curveOf(mapOfDecision(this->own(structure), log, *shown).decision, structure.scene(), part);
    }
    [[nodiscard]] std::string frameLine(const Structure& structure, const FrameLog& log) const final {
        return mapLine(this->snapshot(structure, log), structure.scene());
    }
    void addWhySteps(const Structure& structure, const FrameLog& log, uint32_t instance, uint32_t triangle,
                     std::vector<WhyStep>& steps) const final {
        addMapStepsOf(this->snapshot(structure, log), log, instance, triangle, steps);
    }

protected:
    /// The map of an object with a frame's decision about it.
    [[nodiscard]] virtual MapSnapshot mapOfDecision(const OwnStructure& structure, const FrameLog& log,
                                                    const SphericalDecision& decision) const = 0;

private:
    std::string m_id;
};

}  // namespace cullscope::spherical
