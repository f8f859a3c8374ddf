#pragma once

#include <optional>
#include <vector>

#include "core/frame/decision.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Where the subject of a decision lies that only its strategy can place, such as a ray, a band or a cell of a map, in the kinds
/// of plain data that views and panels show.
struct SubjectPlace {
    /// An interval of x of one part (CurveParts) of the object's curve.
    struct OnCurve {
        uint32_t part = 0;
        double from = 0.0, to = 0.0;
    };

    std::vector<std::vector<Vec3>> lines;     ///< through points in world coordinates
    std::vector<std::vector<Vec2>> mapLines;  ///< over the object's map, as MapCurve::points (frame/cell_map.h)
    std::optional<OnCurve> onCurve;
    std::optional<uint32_t> triangle;  ///< of the object's mesh
};

/// Part of a StructureSnapshot; of the same frame.
class SubjectPlaces {
public:
    virtual ~SubjectPlaces() = default;
    /// None where the subject is known by its kind alone (subject_shape.h). `scene`: the strategy's.
    [[nodiscard]] virtual std::optional<SubjectPlace> of(const Scene& scene, const Decision& decision) const = 0;
};

}  // namespace cullscope
