#include "core/visibility/ordering/named_subjects.h"

#include <algorithm>
#include <map>

namespace cullscope::ordering {
namespace {

constexpr size_t kShare = 0;  ///< the operand of a drawn part that is its share of the triangle's area

/// Closed, as a line.
std::vector<Vec3> outlineOf(std::vector<Vec3> corners) {
    if (!corners.empty()) corners.push_back(corners.front());
    return corners;
}

}  // namespace

NamedParts partsInCells(const Scene& scene, const FrameLog& log, const BspTree& tree, size_t planes, size_t nodeOperand) {
    const size_t nodes = tree.nodes().size();
    if (planes == 0 && nodes > NamedParts::kMostLeaves) {
        NamedParts unnamed;
        unnamed.leaves = nodes;
        return unnamed;
    }
    const BspCells cells = cellsOf(tree, planes);
    const size_t leaves = planes > 0 ? cells.leaves.size() : nodes;
    // Polygons that lie in a given plane are kept above the leaves: behind the leaves, that plane is a place, too.
    std::map<uint32_t, size_t> placeOfPlane;
    for (uint32_t node = 0; planes > 0 && node < nodes; ++node)
        if (!cells.leafOf[node] && !tree.partsOf(tree.nodes()[node]).empty())
            placeOfPlane.try_emplace(tree.nodes()[node].depth, 0);
    for (size_t next = leaves; auto& [plane, place] : placeOfPlane) place = next++;
    NamedParts result = namedParts(scene, log, [&](const Decision& fragment) {
        const auto node = uint32_t(fragment.operands[nodeOperand]);
        const auto place = planes == 0          ? std::optional<size_t>(node)
                           : cells.leafOf[node] ? cells.leafOf[node]
                                                : std::optional(placeOfPlane.at(tree.nodes()[node].depth));
        return PartKey{cells.rank[cells.cellOf(node)], place};
    });
    result.leaves = leaves;
    for (size_t place = 0; place < leaves; ++place)
        result.places.push_back(planes > 0 ? BspCells::leafName(place) : nodeName(tree, cells, scene, uint32_t(place)));
    for (const auto& [plane, place] : placeOfPlane) result.places.push_back(scene.planes()[plane].name);
    return result;
}

bool NamedSubjects::namesPartsOf(const FrameLog& log) {
    const auto few = [](const Command& command) {
        const auto* own = std::get_if<OwnTrianglesPointer>(&command);
        return own != nullptr && (*own)->triangles.size() <= kMostTriangles;
    };
    return log.recorded && std::ranges::any_of(log.commands, few);
}

NamedSubjects::NamedSubjects(const Scene& scene, const FrameLog& log, const NamedParts& parts, RoleOfOperand role)
    : m_role(role) {
    for (const LoggedDetail& logged : log.details)
        if (auto polygons = std::dynamic_pointer_cast<const PolygonsInHand>(logged.detail)) m_inHand = std::move(polygons);
    for (const Decision& decision : log.decisions)
        if (decision.subject.kind == Subject::Kind::Fragment && decision.places.count > 0 && decision.operands[kShare] < 1.0)
            m_cut.insert(decision.subject.number);
    if (!parts.own || parts.parts.empty()) return;
    m_partNames.resize(parts.own->triangles.size());
    for (const NamedParts::Part& part : parts.parts)
        for (const PlaceRun& run : part.drawn)
            for (uint32_t place = run.first; place < run.first + run.count; ++place) m_partNames[place] = part.name;
    for (uint32_t instance = 0; instance < scene.instances().size(); ++instance) {
        m_objects.push_back(scene.instances()[instance].name);
        m_firstTriangles.push_back(scene.firstTriangle(instance));
    }
}

const PolygonsInHand::Pair* NamedSubjects::pairOf(size_t number) const {
    const bool has = m_inHand && number >= m_inHand->first && number - m_inHand->first < m_inHand->pairs.size();
    return has ? &m_inHand->pairs[number - m_inHand->first] : nullptr;
}

std::optional<SubjectPlace> NamedSubjects::of(const Scene& /*scene*/, const Decision& decision) const {
    if (decision.subject.kind != Subject::Kind::Fragment) return std::nullopt;
    SubjectPlace place;
    for (size_t i = 0; i < decision.operandCount; ++i)
        if (m_role(decision, i) == OperandRole::Node) place.node = uint32_t(decision.operands[i]);
    return place;
}

std::optional<SubjectPlace> NamedSubjects::at(const Scene& scene, const Decision& decision, size_t number) const {
    std::optional<SubjectPlace> place = of(scene, decision);
    const PolygonsInHand::Pair* pair = pairOf(number);
    if (!place || pair == nullptr) return place;
    // What is drawn is lit by its own triangles.
    if (decision.places.count == 0) place->lines.push_back(outlineOf(m_inHand->corners[pair->p]));
    if (pair->q != pair->p) place->compared.push_back(outlineOf(m_inHand->corners[pair->q]));
    return place;
}

PlaceRun NamedSubjects::drawnOf(const Decision& decision, size_t number, bool second) const {
    if (decision.places.count > 0 && !second) return decision.places;
    const PolygonsInHand::Pair* pair = pairOf(number);
    return pair == nullptr ? PlaceRun() : m_inHand->drawn[second ? pair->q : pair->p];
}

std::string NamedSubjects::partName(const PlaceRun& drawn) const {
    return drawn.count > 0 && drawn.first < m_partNames.size() ? m_partNames[drawn.first] : std::string();
}

bool NamedSubjects::isWhole(const Decision& decision, size_t number) const {
    const PolygonsInHand::Pair* pair = pairOf(number);
    return pair != nullptr ? m_inHand->whole[pair->p] : !m_cut.contains(decision.subject.number);
}

EntryNames NamedSubjects::names(const StructureSnapshot& snapshot, const Decision& decision, size_t number) const {
    EntryNames names;
    names.whole = decision.subject.kind == Subject::Kind::Fragment && isWhole(decision, number);
    const bool ofPart = decision.subject.kind == Subject::Kind::Fragment && !m_partNames.empty();
    if (ofPart) names.subject = partName(drawnOf(decision, number, false));
    bool second = false;
    for (size_t i = 0; i < decision.operandCount; ++i) {
        const OperandRole role = m_role(decision, i);
        if (role == OperandRole::Node && decision.operands[i] < double(snapshot.nodes.size()))
            names.operands[i] = snapshot.nodes[size_t(decision.operands[i])].name;
        if (role != OperandRole::Triangle || !ofPart) continue;
        std::string called = partName(drawnOf(decision, number, second));
        if (called.empty()) {
            const auto after = std::ranges::upper_bound(m_firstTriangles, uint64_t(decision.operands[i]));
            called = m_objects[size_t(after - m_firstTriangles.begin()) - 1];
        }
        names.operands[i] = std::to_string(uint64_t(decision.operands[i])) + " (" + called + ")";
        second = true;
    }
    return names;
}

}  // namespace cullscope::ordering
