#include "core/scene/region_sets.h"

#include <algorithm>

namespace cullscope {
namespace {

/// A byte that is not 0 stands for itself; a run of up to 255 zero bytes is a zero byte and its length.
std::string coded(const std::vector<uint8_t>& bits) {
    std::string result;
    for (size_t i = 0; i < bits.size();) {
        result.push_back(char(bits[i]));
        if (bits[i++] != 0) continue;
        uint8_t run = 1;
        for (; i < bits.size() && bits[i] == 0 && run < 255; ++i) ++run;
        result.push_back(char(run));
    }
    return result;
}

}  // namespace

RegionSets::RegionSets(std::vector<Node> nodes, size_t regions, size_t objects, const Box3& within)
    : m_nodes(std::move(nodes)), m_within(within), m_objects(objects), m_setOf(regions, kEverything) {}

void RegionSets::setOf(uint32_t region, std::span<const uint8_t> visible) {
    std::vector<uint8_t> bits((m_objects + 7) / 8, 0);
    for (size_t i = 0; i < m_objects; ++i)
        if (visible[i] != 0) bits[i / 8] |= uint8_t(1U << (i % 8));
    std::string code = coded(bits);
    const auto [known, added] = m_known.try_emplace(std::move(code), uint32_t(m_begins.size()));
    if (added) {
        m_begins.push_back(m_coded.size());
        m_coded += known->first;
    }
    m_setOf[region] = known->second;
}

std::optional<uint32_t> RegionSets::regionAt(const Vec3& place) const {
    if (m_nodes.empty()) return std::nullopt;
    if (!m_within.empty() && (glm::any(glm::lessThan(place, m_within.min)) || glm::any(glm::greaterThan(place, m_within.max))))
        return std::nullopt;
    int32_t at = 0;
    while (at >= 0) {
        const Node& node = m_nodes[size_t(at)];
        at = node.children[glm::dot(node.normal, place) - node.distance >= 0.0 ? 0 : 1];
    }
    const auto region = uint32_t(-1 - at);
    return hasSet(region) ? std::optional(region) : std::nullopt;
}

std::vector<uint32_t> RegionSets::objectsOf(uint32_t region) const {
    std::vector<uint32_t> objects;
    size_t at = m_begins[m_setOf[region]];
    for (size_t byte = 0; byte < (m_objects + 7) / 8; ++at) {
        const auto bits = uint8_t(m_coded[at]);
        if (bits == 0) {
            byte += uint8_t(m_coded[++at]);
            continue;
        }
        for (uint32_t bit = 0; bit < 8; ++bit)
            if ((bits >> bit & 1) != 0) objects.push_back(uint32_t(8 * byte + bit));
        ++byte;
    }
    return objects;
}

uint64_t RegionSets::bytes() const {
    return m_nodes.size() * sizeof(Node) + m_setOf.size() * sizeof(uint32_t) + m_begins.size() * sizeof(uint64_t) +
           m_coded.size();
}

RegionSets RegionSets::ofObjects(std::span<const uint32_t> kept) const {
    RegionSets result(m_nodes, m_setOf.size(), kept.size(), m_within);
    std::vector<uint8_t> before(m_objects), visible(kept.size());
    for (uint32_t region = 0; region < m_setOf.size(); ++region) {
        if (!hasSet(region)) continue;
        std::ranges::fill(before, uint8_t(0));
        for (const uint32_t object : objectsOf(region)) before[object] = 1;
        std::ranges::transform(kept, visible.begin(), [&](uint32_t object) { return before[object]; });
        result.setOf(region, visible);
    }
    return result;
}

}  // namespace cullscope
