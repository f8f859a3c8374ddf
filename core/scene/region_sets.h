#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/geometry/bounds.h"

namespace cullscope {

/// Space divided by planes into regions, and for each region the objects of a scene that may be seen from it: potentially visible
/// sets. Sets are kept as bits with runs of zero bytes counted, as Quake keeps them; equal ones once.
class RegionSets {
public:
    /// A child is a node, or the region −1 − child where it is negative.
    struct Node {
        Vec3 normal{0.0, 0.0, 1.0};
        double distance = 0.0;
        std::array<int32_t, 2> children{-1, -1};  ///< where normal·p ≥ distance, and where it is less
    };
    /// Of a region without a set: everything may be seen from it.
    static constexpr uint32_t kEverything = 0xFFFFFFFF;

    RegionSets() = default;
    /// `nodes`: a tree whose root is node 0; empty: there are no regions. Beyond `within` there is none either; an empty box: the
    /// tree divides all of space.
    RegionSets(std::vector<Node> nodes, size_t regions, size_t objects, const Box3& within = {});

    /// Says what may be seen from a region: a byte for each object, 0 or not.
    void setOf(uint32_t region, std::span<const uint8_t> visible);

    [[nodiscard]] size_t regionCount() const { return m_setOf.size(); }
    [[nodiscard]] size_t objectCount() const { return m_objects; }
    /// How many different sets there are.
    [[nodiscard]] size_t setCount() const { return m_begins.size(); }
    /// The region in which a place lies that has a set; none where everything may be seen.
    [[nodiscard]] std::optional<uint32_t> regionAt(const Vec3& place) const;
    /// The objects that may be seen from a region with a set, ascending.
    [[nodiscard]] std::vector<uint32_t> objectsOf(uint32_t region) const;
    [[nodiscard]] bool hasSet(uint32_t region) const { return m_setOf[region] != kEverything; }
    /// Of the tree and the sets.
    [[nodiscard]] uint64_t bytes() const;
    [[nodiscard]] std::span<const Node> nodes() const { return m_nodes; }
    [[nodiscard]] const Box3& within() const { return m_within; }

    /// The same regions for a scene that has only some of the objects: those of these numbers, in this order.
    [[nodiscard]] RegionSets ofObjects(std::span<const uint32_t> kept) const;

private:
    std::vector<Node> m_nodes;
    Box3 m_within;
    size_t m_objects = 0;
    std::vector<uint32_t> m_setOf;   ///< by region
    std::vector<uint64_t> m_begins;  ///< by set: where it begins in m_coded
    std::string m_coded;
    std::unordered_map<std::string, uint32_t> m_known;  ///< only while sets are added
};

using RegionSetsPointer = std::shared_ptr<const RegionSets>;

}  // namespace cullscope
