#pragma once

#include <optional>
#include <vector>

#include "core/frame/decision.h"
#include "core/frame/entry_words.h"
#include "core/scene/scene.h"

namespace cullscope {

struct StructureSnapshot;

/// Where the subject of a decision lies that only its strategy can place, such as a ray, a band or a cell of a map, in the kinds
/// of plain data that views and panels show.
struct SubjectPlace {
    /// An interval of x of one part (CurveParts) of the object's curve.
    struct OnCurve {
        uint32_t part = 0;
        double from = 0.0, to = 0.0;
    };

    std::vector<std::vector<Vec3>> lines;     ///< through points in world coordinates
    std::vector<std::vector<Vec3>> compared;  ///< the same of what the subject is compared with
    std::vector<std::vector<Vec2>> mapLines;  ///< over the object's map, as MapCurve::points (frame/cell_map.h)
    std::optional<OnCurve> onCurve;
    std::optional<uint32_t> triangle;  ///< of the object's mesh
    std::optional<uint32_t> node;      ///< the group that it lies in (SnapshotNode::number)
};

/// What only a strategy knows of the subjects of its decisions. Part of a StructureSnapshot; of the same frame.
class SubjectPlaces {
public:
    virtual ~SubjectPlaces() = default;
    /// None where the subject is known by its kind alone (subject_shape.h). `scene`: the strategy's.
    [[nodiscard]] virtual std::optional<SubjectPlace> of(const Scene& scene, const Decision& decision) const = 0;
    /// The same of a decision whose number in the frame is known.
    [[nodiscard]] virtual std::optional<SubjectPlace> at(const Scene& scene, const Decision& decision, size_t /*number*/) const {
        return of(scene, decision);
    }
    /// What a sentence calls what the decision speaks of. `snapshot`: the one that this is a part of.
    [[nodiscard]] virtual EntryNames names(const StructureSnapshot& /*snapshot*/, const Decision& /*decision*/,
                                           size_t /*number*/) const {
        return {};
    }
};

}  // namespace cullscope
