#pragma once

#include <set>

#include "core/frame/named_parts.h"
#include "core/spatial/bsp_cells.h"
#include "core/spatial/cut_triangles.h"
#include "core/visibility/structure_snapshot.h"
#include "core/visibility/subject_place.h"

namespace cullscope::ordering {

/// The polygons that a recorded frame of `painter` speaks of, so that a step can show them: attached to its first decision.
struct PolygonsInHand final : DecisionDetail {
    struct Pair {
        uint32_t p = 0, q = 0;  ///< polygons; q is p where there is no other one
    };
    size_t first = 0;                        ///< the number of the first decision that `pairs` has
    std::vector<Pair> pairs;                 ///< by decision
    std::vector<PlaceRun> drawn;             ///< by polygon: its triangles among the own ones; none where it was cut
    std::vector<std::vector<Vec3>> corners;  ///< by polygon, in world coordinates; empty: of none
    std::vector<bool> whole;                 ///< likewise: a triangle of which nothing was cut off
};

/// The parts of a frame that walked a tree, by the cells in which they lie: an object's polygons in one cell are a part, and the
/// cells are the places. Cells are the leaves below so many given planes, and then each plane in which a polygon lies, by its
/// name; without given planes the nodes, each of which has its own polygons, where there are few. `nodeOperand`: of a drawn
/// part's decision.
[[nodiscard]] NamedParts partsInCells(const Scene& scene, const FrameLog& log, const BspTree& tree, size_t planes,
                                      size_t nodeOperand);

/// What an operand of a decision is.
enum class OperandRole : uint8_t { Number, Triangle, Node };
using RoleOfOperand = OperandRole (*)(const Decision& decision, size_t operand);

/// The subjects of a frame that draws by order: polygons are lit as P, with Q beside it, where a PolygonsInHand tells of them,
/// and with the node that an operand names. Parts of objects are called as in questions, of frames with few triangles; nodes as
/// the snapshot calls them.
class NamedSubjects final : public SubjectPlaces {
public:
    /// Of frames with more own triangles parts have no names here.
    static constexpr size_t kMostTriangles = 2'000;
    [[nodiscard]] static bool namesPartsOf(const FrameLog& log);

    /// `parts`: empty where they are not named.
    NamedSubjects(const Scene& scene, const FrameLog& log, const NamedParts& parts, RoleOfOperand role);

    [[nodiscard]] std::optional<SubjectPlace> of(const Scene& scene, const Decision& decision) const override;
    [[nodiscard]] std::optional<SubjectPlace> at(const Scene& scene, const Decision& decision, size_t number) const override;
    [[nodiscard]] EntryNames names(const StructureSnapshot& snapshot, const Decision& decision, size_t number) const override;

private:
    [[nodiscard]] const PolygonsInHand::Pair* pairOf(size_t number) const;
    /// The own triangles of what a decision speaks of (`second`: of Q); none: it is not drawn as it is.
    [[nodiscard]] PlaceRun drawnOf(const Decision& decision, size_t number, bool second) const;
    /// Empty: not known.
    [[nodiscard]] std::string partName(const PlaceRun& drawn) const;

    /// Whether a decision speaks of a triangle of which nothing was cut off.
    [[nodiscard]] bool isWhole(const Decision& decision, size_t number) const;

    std::shared_ptr<const PolygonsInHand> m_inHand;  ///< null: the frame has none
    std::set<uint32_t> m_cut;                        ///< triangles that are drawn in parts
    std::vector<std::string> m_partNames;            ///< by own triangle; empty: none is named
    std::vector<std::string> m_objects;              ///< with part names: by instance
    std::vector<uint64_t> m_firstTriangles;          ///< likewise
    RoleOfOperand m_role;
};

}  // namespace cullscope::ordering
