#include "core/visibility/baseline/baselines.h"

#include "core/base/message.h"

namespace cullscope::baseline {
namespace {

/// Submits all triangles for every view.
class Everything : public Strategy {
public:
    using Strategy::Strategy;

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        report.figures = {{"objects", double(scene.instances().size())}};
    }
    void decide(const View& /*view*/, Verdict& verdict, Trace* trace) override {
        const StageTimer stage(verdict, CULLSCOPE_TR("listing"));
        for (uint32_t i = 0; i < scene().instances().size(); ++i) {
            const size_t indices = scene().meshOf(i).indices().size();
            if (indices > 0) verdict.drawList.ranges.push_back({i, 0, static_cast<uint32_t>(indices)});
            if (trace != nullptr) trace->events.push_back({TraceEvent::Kind::Accepted, i});
        }
    }
};

bool contains(const Box3& box, const Vec3& point) {
    return glm::all(glm::greaterThanEqual(point, box.min)) && glm::all(glm::lessThanEqual(point, box.max));
}

class All final : public Everything {
public:
    using Everything::Everything;
    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
};

class Backface final : public Everything {
public:
    using Everything::Everything;
    [[nodiscard]] Promise promise() const override { return m_closed ? Promise::Conservative : Promise::Approximate; }
    /// Inside a closed mesh only back faces are visible; an eye in an object's box may be inside its mesh.
    [[nodiscard]] Promise promiseAt(const View& view) const override {
        for (size_t i = 0; i < scene().instances().size(); ++i)
            if (contains(scene().instanceBox(i), view.eye())) return Promise::Approximate;
        return promise();
    }
    [[nodiscard]] Facing facing() const override { return Facing::Front; }
    [[nodiscard]] Facing referenceFacing() const override { return Facing::TwoSided; }

protected:
    void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) override {
        Everything::buildStructures(scene, progress, report);
        m_closed = scene.frontFacesSuffice();
    }

private:
    bool m_closed = false;
};

}  // namespace

StrategyInfo allInfo() {
    return {"all",
            CULLSCOPE_TR("All triangles"),
            CULLSCOPE_TR("Draws every triangle, both sides: what the papers compare with."),
            "",
            {}};
}

StrategyPointer makeAll(ParameterSet parameters) { return std::make_unique<All>(std::move(parameters)); }

StrategyInfo backfaceInfo() {
    return {"backface",
            CULLSCOPE_TR("Back-face culling"),
            CULLSCOPE_TR("Draws every triangle and lets OpenGL drop those that face away: the strong baseline."),
            "",
            {}};
}

StrategyPointer makeBackface(ParameterSet parameters) { return std::make_unique<Backface>(std::move(parameters)); }

}  // namespace cullscope::baseline
