#include "core/visibility/baseline/baselines.h"

#include "core/base/message.h"
#include "core/geometry/separation.h"
#include "core/visibility/displaced_surfaces.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"

namespace cullscope::baseline {
namespace {

enum class BaselineLine : uint8_t { Objects = 1, Draw };

struct SceneFacts : Structure {
    using Structure::Structure;
    bool closed = false;  ///< no back face of any mesh can be seen from outside
};

/// Submits all triangles for every view.
class Everything : public StrategyWith<SceneFacts> {
protected:
    void fill(SceneFacts& structure, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        structure.report.figures = {{"objects", double(structure.scene().instances().size())}};
    }
    void decide(FrameContext& frame, const SceneFacts& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("listing"));
            for (uint32_t i = 0; i < frame.scene().instances().size(); ++i) {
                const size_t indices = frame.scene().meshOf(i).indices().size();
                if (indices > 0) list.ranges.push_back({i, 0, static_cast<uint32_t>(indices)});
                if (frame.recording())
                    frame.say(atLine(BaselineLine::Draw, ending(Subject::ofObject(i), Decision::Outcome::Drawn)));
            }
        }
        frame.draw(std::move(list));
    }
};

bool contains(const Box3& box, const Vec3& point) {
    return glm::all(glm::greaterThanEqual(point, box.min)) && glm::all(glm::lessThanEqual(point, box.max));
}

class All final : public Everything {
protected:
    [[nodiscard]] Promise promiseOf(const SceneFacts& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
};

class Backface final : public Everything {
public:
    /// Inside a closed mesh only back faces are visible; an eye in an object's box may be inside its mesh, and a near plane that
    /// cuts the box may open the mesh to the eye. Where rounding displaces surfaces, a back face may come before the front one.
    /// `cullbench certify` found the latter two.
    [[nodiscard]] Promise promiseAt(const Structure& structure, const ParameterSet& parameters, Facing facing,
                                    const View& view) const override {
        const Scene& scene = structure.scene();
        for (uint32_t i = 0; i < scene.instances().size(); ++i) {
            if (!view.frustum().parallel() && contains(scene.instanceBox(i), view.eye())) return Promise::Approximate;
            const EyeBounds bounds = boundsFromEye(scene, i, view.eye());
            if (meetsNearRectangle(view.frustum(), bounds.box, bounds.margin)) return Promise::Approximate;
        }
        return promiseWhereSurfacesStandStill(promiseOf(own(structure), parameters, facing), scene, view);
    }
    [[nodiscard]] Facing facing(const Scene& /*scene*/, const ParameterSet& /*parameters*/) const override {
        return Facing::Front;
    }
    [[nodiscard]] Facing referenceFacing(const Scene& /*scene*/, const ParameterSet& /*parameters*/) const override {
        return Facing::TwoSided;
    }

protected:
    void proveFor(SceneFacts& structure, const Progress& progress) const override {
        structure.closed = structure.scene().frontFacesSuffice() && structure.scene().hasNoPockets(progress);
    }
    [[nodiscard]] Promise promiseOf(const SceneFacts& structure, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return structure.closed ? Promise::Conservative : Promise::Approximate;
    }
};

Show listingOfAll() { return listingShow({{CULLSCOPE_TR("for each object"), 0}, {CULLSCOPE_TR("draw all its triangles"), 1}}); }

Show listingOfFrontFaces() {
    return listingShow({{CULLSCOPE_TR("for each object"), 0}, {CULLSCOPE_TR("draw it: OpenGL drops back faces"), 1}});
}

}  // namespace

RegisteredStrategy all() {
    StrategyInfo info{
        "all", CULLSCOPE_TR("All triangles"),  CULLSCOPE_TR("Draws every triangle, both sides: what the papers compare with."),
        "",    {facingParameter("two-sided")}, GlRequirement::None,
        false, BaselineRole::Triangles};
    info.shows = {listingOfAll()};
    return {std::move(info), std::make_shared<All>()};
}

RegisteredStrategy backface() {
    StrategyInfo info{"backface",
                      CULLSCOPE_TR("Back-face culling"),
                      CULLSCOPE_TR("Draws every triangle and lets OpenGL drop those that face away: the strong baseline."),
                      "",
                      {},
                      GlRequirement::None,
                      false,
                      BaselineRole::FrontFaces};
    info.shows = {listingOfFrontFaces()};
    return {std::move(info), std::make_shared<Backface>()};
}

}  // namespace cullscope::baseline
