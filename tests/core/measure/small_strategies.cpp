#include "tests/core/measure/small_strategies.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/separation.h"
#include "core/measure/ray_reference.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"

namespace cullscope::test {
namespace {

struct Nothing : Structure {
    using Structure::Structure;
};

/// A strategy that builds nothing.
template <typename State = ViewState>
class SmallStrategy : public StrategyWith<Nothing, State> {
protected:
    void fill(Nothing& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    [[nodiscard]] Promise promiseOf(const Nothing& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
};

StrategyInfo infoOf(const char* id, GlRequirement requirement) {
    return {id, "A small strategy", "Proves what a frame can say.", "", {facingParameter()}, requirement};
}

/// The objects with triangles, nearest first.
std::vector<uint32_t> byDistance(const FrameContext& frame) {
    const Scene& scene = frame.scene();
    std::vector<uint32_t> order(scene.instances().size());
    std::iota(order.begin(), order.end(), 0u);
    std::erase_if(order, [&](uint32_t i) { return scene.meshOf(i).triangleCount() == 0; });
    std::ranges::stable_sort(order, {},
                             [&](uint32_t i) { return glm::length(scene.instanceSphere(i).centre - frame.view().eye()); });
    return order;
}

DrawRange wholeObject(const Scene& scene, uint32_t instance) {
    return {instance, 0, uint32_t(scene.meshOf(instance).indices().size())};
}

/// The boxes of objects, grown by a pixel; those that reach the near rectangle are to be drawn without a question.
struct Boxes {
    std::vector<EyeBox> boxes;
    std::vector<uint32_t> instances;  ///< of `boxes`
    std::vector<uint32_t> unasked;
};

Boxes boxesOf(const FrameContext& frame, const std::vector<uint32_t>& objects) {
    Boxes result;
    const Frustum& frustum = frame.view().frustum();
    for (const uint32_t instance : objects) {
        const EyeBounds bounds = boundsFromEye(frame.scene(), instance, frame.view().eye());
        EyeBox box = bounds.box;
        const double farthest = glm::dot(frustum.forward, box.centre) + glm::dot(glm::abs(frustum.forward), box.halfExtent);
        box.halfExtent +=
            Vec3(2.0 * frustum.tanHalfHeight / frame.view().viewport().height * std::max(farthest, 0.0) + bounds.margin);
        if (meetsNearRectangle(frustum, box, bounds.margin)) {
            result.unasked.push_back(instance);
            continue;
        }
        result.boxes.push_back(box);
        result.instances.push_back(instance);
    }
    return result;
}

/// Those whose boxes are visible in what was drawn so far.
std::vector<uint32_t> visibleOf(FrameContext& frame, const std::vector<uint32_t>& objects) {
    Boxes asked = boxesOf(frame, objects);
    std::vector<uint32_t> visible = std::move(asked.unasked);
    for (const uint32_t hit : frame.visibleBoxes(std::move(asked.boxes), BoxQuestion::DepthSoFar))
        visible.push_back(asked.instances[hit]);
    return visible;
}

void drawObjects(FrameContext& frame, const std::vector<uint32_t>& objects) {
    DrawList list{frame.facing(), {}};
    for (const uint32_t instance : objects) {
        list.ranges.push_back(wholeObject(frame.scene(), instance));
        if (frame.recording()) frame.say(ending(Subject::ofObject(instance), Decision::Outcome::Drawn));
    }
    frame.draw(std::move(list));
}

void leaveOutOthers(FrameContext& frame, std::vector<uint32_t> all, std::vector<uint32_t> drawn) {
    std::ranges::sort(all);
    std::ranges::sort(drawn);
    std::vector<uint32_t> others;
    std::ranges::set_difference(all, drawn, std::back_inserter(others));
    for (const uint32_t instance : others) {
        frame.counters().culledTriangles[size_t(Cause::Hidden)] += frame.scene().meshOf(instance).triangleCount();
        if (frame.recording()) frame.say(ending(Subject::ofObject(instance), Decision::Outcome::Culled, Cause::Hidden));
    }
}

class BackToFront final : public SmallStrategy<> {
protected:
    void decide(FrameContext& frame, const Nothing& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        const Scene& scene = frame.scene();
        auto own = std::make_shared<OwnTriangles>();
        own->facing = frame.facing();
        std::vector<uint32_t> order = byDistance(frame);
        std::ranges::reverse(order);
        for (const uint32_t instance : order) {
            const TriangleMesh& mesh = scene.meshOf(instance);
            own->runs.push_back({instance, uint32_t(own->triangles.size()), uint32_t(mesh.triangleCount())});
            for (const uint32_t index : mesh.indices()) {
                own->positions.push_back(mesh.positions()[index]);
                own->normals.push_back(mesh.normals()[index]);
            }
            for (uint32_t triangle = 0; triangle < mesh.triangleCount(); ++triangle)
                own->triangles.push_back(uint32_t(scene.firstTriangle(instance)) + triangle);
            if (frame.recording()) frame.say(ending(Subject::ofObject(instance), Decision::Outcome::Drawn));
        }
        frame.draw(std::move(own));
    }
};

class TracedPicture final : public SmallStrategy<> {
protected:
    void decide(FrameContext& frame, const Nothing& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        RayReference traced = rayReference(frame.scene(), frame.view(), frame.facing());
        auto picture = std::make_shared<FinishedPicture>();
        picture->size = traced.size;
        picture->triangle.assign(traced.triangle.begin(), traced.triangle.end());
        picture->depth.assign(traced.depth.begin(), traced.depth.end());
        if (frame.recording())
            for (const uint32_t instance : byDistance(frame))
                frame.say(ending(Subject::ofObject(instance), Decision::Outcome::PartlyDrawn, Cause::Hidden));
        frame.show(std::move(picture));
    }
};

class HalfThenAsk final : public SmallStrategy<> {
protected:
    void decide(FrameContext& frame, const Nothing& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        const std::vector<uint32_t> all = byDistance(frame);
        const auto half = all.begin() + std::ptrdiff_t(all.size() / 2);
        std::vector<uint32_t> drawn(all.begin(), half);
        drawObjects(frame, drawn);
        const std::vector<uint32_t> visible = visibleOf(frame, {half, all.end()});
        drawObjects(frame, visible);
        drawn.insert(drawn.end(), visible.begin(), visible.end());
        leaveOutOthers(frame, all, drawn);
    }
};

struct SeenObjects : ViewState {
    std::optional<std::vector<uint32_t>> visible;  ///< in the last frame; none: there was none

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<SeenObjects>(*this); }
};

class LastFrame final : public SmallStrategy<SeenObjects> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override {
        return std::make_unique<SeenObjects>();
    }

protected:
    void decide(FrameContext& frame, const Nothing& /*structure*/, SeenObjects& seen,
                const ParameterSet& /*parameters*/) const override {
        const std::vector<uint32_t> all = byDistance(frame);
        const std::vector<uint32_t> drawn = seen.visible.value_or(all);
        drawObjects(frame, drawn);
        leaveOutOthers(frame, all, drawn);
        seen.visible = visibleOf(frame, all);
    }
    [[nodiscard]] Promise promiseOf(const Nothing& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
};

class ChosenByGpu final : public SmallStrategy<> {
protected:
    void decide(FrameContext& frame, const Nothing& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        GpuChoice choice;
        choice.leftOut = Cause::OutsideFrustum;
        choice.candidates.facing = frame.facing();
        for (const Plane& plane : frame.view().frustum().planes)
            for (const double value : {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset})
                choice.data.push_back(float(value));
        for (const uint32_t instance : byDistance(frame)) {
            choice.candidates.ranges.push_back(wholeObject(frame.scene(), instance));
            const EyeBounds bounds = boundsFromEye(frame.scene(), instance, frame.view().eye());
            const Vec3& centre = bounds.sphere.centre;
            // The shader computes in float: the radius grows by the rounding of the largest number in it.
            const double margin = bounds.margin + (glm::length(centre) + bounds.sphere.radius) * 0x1p-20;
            for (const double value : {centre.x, centre.y, centre.z, bounds.sphere.radius + margin})
                choice.data.push_back(float(value));
        }
        choice.body = R"(
    uint sphere = 24u + 4u * candidate;
    for (uint plane = 0u; plane < 24u; plane += 4u) {
        float away = data[plane] * data[sphere] + data[plane + 1u] * data[sphere + 1u] + data[plane + 2u] * data[sphere + 2u];
        if (away + data[plane + 3u] < -data[sphere + 3u]) return false;
    }
    return true;)";
        frame.drawChosen(choice);
    }
};

}  // namespace

RegisteredStrategy backToFront() { return {infoOf("back-to-front", GlRequirement::None), std::make_shared<BackToFront>()}; }

RegisteredStrategy tracedPicture() { return {infoOf("traced-picture", GlRequirement::None), std::make_shared<TracedPicture>()}; }

RegisteredStrategy halfThenAsk() { return {infoOf("half-then-ask", GlRequirement::Context), std::make_shared<HalfThenAsk>()}; }

RegisteredStrategy lastFrame() {
    StrategyInfo info = infoOf("last-frame", GlRequirement::Context);
    info.remembers = true;
    return {std::move(info), std::make_shared<LastFrame>()};
}

RegisteredStrategy chosenByGpu() { return {infoOf("chosen-by-gpu", GlRequirement::Context), std::make_shared<ChosenByGpu>()}; }

}  // namespace cullscope::test
