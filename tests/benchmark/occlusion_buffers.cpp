#include <algorithm>
#include <span>

#include "core/raster/occlusion_buffer.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "core/visibility/facing.h"
#include "core/visibility/occlusion/occluders.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/in_turns.h"

namespace cullscope::benchmark {
namespace {

constexpr const char* kDepth = "depth_ms";
constexpr const char* kMasked = "masked_ms";
constexpr const char* kHiddenByDepth = "hidden_by_depth";
constexpr const char* kHiddenByMasked = "hidden_by_masked";
constexpr int kRounds = 5;

/// Both scenes and the path, of the first setting.
struct Scenes {
    ScenePointer occluders, objects;
    CameraPath path;
};

/// All instances, nearest first: by the nearest point of their boxes.
std::vector<uint32_t> nearestFirst(const Scene& scene, const View& view) {
    std::vector<std::pair<double, uint32_t>> byDistance;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const Box3& box = scene.instanceBox(i);
        const Vec3 beyond = glm::max(glm::max(box.min - view.eye(), view.eye() - box.max), Vec3(0.0));
        byDistance.emplace_back(glm::dot(beyond, beyond), i);
    }
    std::ranges::stable_sort(byDistance);
    std::vector<uint32_t> order;
    for (const auto& [distance, instance] : byDistance) order.push_back(instance);
    return order;
}

/// A picture of all occluders, in an order, and a question about every object. Returns how many are hidden.
size_t hiddenObjects(OcclusionBuffer& buffer, const Scenes& scenes, std::span<const uint32_t> order, Facing facing,
                     const View& view) {
    buffer.begin(view);
    for (const uint32_t i : order) {
        const TriangleMesh& mesh = scenes.occluders->meshOf(i);
        buffer.draw(*scenes.occluders, i, facing, mesh.positions(), mesh.indices());
    }
    size_t hidden = 0;
    for (uint32_t i = 0; i < scenes.objects->instances().size(); ++i) {
        const std::optional<BoxInPicture> place = occlusion::askedBox(buffer, scenes.objects->instanceBox(i), view).place;
        hidden += place && place->pixels() > 0 && buffer.hides(*place) ? 1 : 0;
    }
    return hidden;
}

std::optional<double> total(const ResultTable& table, const char* column) {
    double sum = 0.0;
    for (size_t row = 0; row < table.rows.size(); ++row) sum += numberOf(table.value(row, column)).value_or(0.0);
    return table.rows.empty() ? std::nullopt : std::optional(sum);
}

Check totalsCheck(std::string sentence, const char* dividend, const char* divisor, double least, double most) {
    return {std::move(sentence),
            [=](const ResultTable& table) -> std::optional<double> {
                const std::optional<double> above = total(table, dividend), below = total(table, divisor);
                return above && below && *below > 0.0 ? std::optional(*above / *below) : std::nullopt;
            },
            least, most};
}

}  // namespace

Experiment occlusionBuffers(const std::string& occluders, const std::string& objects, size_t poses, const Viewport& size) {
    Experiment experiment;
    experiment.id = "occlusion-buffers";
    experiment.title = "Occlusion buffers: a depth for each pixel, and masked";
    Axis pose{"pose", "pose", Axis::Kind::Label, {}};
    for (size_t i = 0; i < poses; ++i) pose.values.emplace_back(double(i));
    experiment.axes = {std::move(pose)};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    using enum ResultColumn::Origin;
    experiment.columns.insert(experiment.columns.end(), {{kDepth, "by pixel, ms", Measured, 3},
                                                         {kMasked, "masked, ms", Measured, 3},
                                                         {kHiddenByDepth, "hidden by pixel", Measured},
                                                         {kHiddenByMasked, "hidden masked", Measured},
                                                         {"masked_bytes", "masked, bytes", Measured}});
    experiment.plots = {{logPlot("Time of a picture and its questions", "pose", "ms"), "pose", {{kDepth}, {kMasked}}}};
    experiment.checks = {
        totalsCheck("objects hidden masked by those hidden by pixel", kHiddenByMasked, kHiddenByDepth, 0.98, 1.0),
        totalsCheck("time masked by time by pixel", kMasked, kDepth, 0.0, 1.0 / 3.0),
        everyRowCheck("bytes of the masked buffer", {}, "masked_bytes", {.most = 779'000})};
    auto scenes = std::make_shared<Scenes>();
    experiment.measured = [=](const Setting& setting, const ScenePointer&, const Progress&) {
        if (!scenes->objects) {
            *scenes = {openScene(occluders).scene, openScene(objects).scene, {}};
            scenes->path = cameraPath("tour:" + std::to_string(poses), *scenes->objects);
        }
        const View view(scenes->path.camera(size_t(setting.number("pose"))), size);
        const Facing facing = facingByObject(*scenes->occluders);
        OcclusionBuffer depth(OcclusionForm::Depth), masked(OcclusionForm::Masked);
        const std::vector<uint32_t> order = nearestFirst(*scenes->occluders, view);
        size_t byDepth = 0, byMasked = 0;
        const std::vector<std::vector<double>> times =
            inTurns({[&] { return timeOf([&] { byDepth = hiddenObjects(depth, *scenes, order, facing, view); }); },
                     [&] { return timeOf([&] { byMasked = hiddenObjects(masked, *scenes, order, facing, view); }); }},
                    kRounds, 1);
        return Rows{{{kDepth, medianOf(times[0])},
                     {kMasked, medianOf(times[1])},
                     {kHiddenByDepth, double(byDepth)},
                     {kHiddenByMasked, double(byMasked)},
                     {"masked_bytes", double(masked.bytes())}}};
    };
    return experiment;
}

}  // namespace cullscope::benchmark
