#include "core/experiments/suite/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/experiments/result_file.h"
#include "core/geometry/separation.h"

namespace cullscope::suite {
namespace {

/// Whether an object's bounds are certainly outside the view.
bool outside(const Scene& scene, uint32_t instance, const View& view) {
    const EyeBox box = relativeToEye(scene.instanceBox(instance), view.eye());
    const double margin = conservativeMargin(glm::length(box.centre) + glm::length(box.halfExtent));
    if (classify(view.frustum(), box) == Containment::Outside || separated(view.frustum(), box, margin)) return true;
    Sphere sphere = scene.instanceSphere(instance);
    sphere.centre -= view.eye();
    return classify(view.frustum(), sphere) == Containment::Outside;
}

DrawList listOf(const Scene& scene, const DrawnSets::Triangles& triangles, Facing facing) {
    DrawList list{facing, {}};
    for (auto [first, end] : triangles)
        while (first < end) {
            const auto instance = uint32_t(scene.instanceOf(first));
            const uint64_t begin = scene.firstTriangle(instance);
            const uint64_t until = std::min(end, begin + scene.meshOf(instance).triangleCount());
            list.ranges.push_back({instance, uint32_t(3 * (first - begin)), uint32_t(3 * (until - first))});
            first = until;
        }
    return list;
}

bool holds(const DrawnSets::Triangles& triangles, uint64_t number) {
    const auto after = std::ranges::upper_bound(triangles, number, {}, &std::pair<uint64_t, uint64_t>::first);
    return after != triangles.begin() && number < std::prev(after)->second;
}

JudgedPose judgedPose(const JudgeRequest& request, size_t pose, Renderer& renderer, const SceneBuffers& buffers,
                      Framebuffer& target) {
    const Scene& scene = *request.scene;
    const View view(request.path.camera(pose), request.size);
    const Reference truth = itemBufferReference(renderer, buffers, view, request.facing);
    FrameLog log;
    log.camera = view.camera();
    log.size = request.size;
    log.facing = request.facing;
    const DrawnSets::Triangles& triangles = request.drawn.poses[pose];
    log.commands.emplace_back(listOf(scene, triangles, request.facing));
    JudgedPose judged;
    judged.accuracy = judge(renderer, buffers, log, truth, target).accuracy;
    std::set<uint32_t> visible, drawn;
    std::map<uint32_t, uint64_t> missing;  // by object: pixels of its visible triangles that are not drawn
    for (const uint32_t triangle : truth.visibleTriangles) visible.insert(uint32_t(scene.instanceOf(triangle)));
    for (const uint32_t item : truth.triangle)
        if (item != 0 && !holds(triangles, item - 1)) ++missing[uint32_t(scene.instanceOf(item - 1))];
    for (const DrawRange& range : std::get<DrawList>(log.commands.front()).ranges) drawn.insert(range.instance);
    judged.visibleObjects = visible.size();
    judged.drawnObjects = drawn.size();
    for (const auto& [instance, pixels] : missing) judged.missing.push_back({instance, pixels});
    std::ranges::stable_sort(judged.missing, std::greater{}, &SeenObject::pixels);
    for (uint32_t instance = 0; instance < scene.instances().size(); ++instance) {
        if (scene.meshOf(instance).triangleCount() == 0 || visible.contains(instance)) continue;
        const bool inView = !outside(scene, instance, view);
        if (drawn.contains(instance)) {
            ++judged.inVain;
            judged.inVainInView += inView ? 1 : 0;
        } else {
            judged.leftOutInView += inView ? 1 : 0;
        }
    }
    for (uint32_t instance = 0; instance < scene.instances().size(); ++instance)
        if (scene.meshOf(instance).triangleCount() > 0 && !drawn.contains(instance)) ++judged.leftOut;
    return judged;
}

double share(uint64_t part, uint64_t whole) { return whole == 0 ? 0.0 : double(part) / double(whole); }

const std::string& nameOf(const Scene& scene, uint32_t instance) { return scene.instances()[instance].name; }

}  // namespace

Accuracy Judgement::total() const {
    Accuracy sum;
    for (const JudgedPose& pose : poses) {
        const Accuracy& one = pose.accuracy;
        sum.coveredPixels += one.coveredPixels;
        sum.missedPixels += one.missedPixels;
        sum.extraPixels += one.extraPixels;
        sum.unresolvedPixels += one.unresolvedPixels;
        sum.largestHolePixels = std::max(sum.largestHolePixels, one.largestHolePixels);
        sum.visibleTriangles += one.visibleTriangles;
        sum.submittedTriangles += one.submittedTriangles;
        sum.falselyCulledTriangles += one.falselyCulledTriangles;
        sum.needlesslyDrawnTriangles += one.needlesslyDrawnTriangles;
    }
    return sum;
}

CullingKind Judgement::kind() const {
    uint64_t leftOut = 0, inView = 0;
    const Accuracy sum = total();
    for (const JudgedPose& pose : poses) {
        leftOut += pose.leftOut;
        inView += pose.leftOutInView;
    }
    if (sum.missedPixels > 0 || sum.falselyCulledTriangles > 0) return CullingKind::Lossy;
    if (sum.coveredPixels == 0) return CullingKind::Unseen;
    // By triangles, parts of objects are left out, too: what is not visible of those that are drawn.
    if (inView > 0 || !byObjects) return CullingKind::Occlusion;
    return leftOut > 0 ? CullingKind::Frustum : CullingKind::None;
}

std::optional<size_t> Judgement::worstPose() const {
    const auto worst = std::ranges::max_element(poses, {}, [](const JudgedPose& pose) { return pose.accuracy.missedPixels; });
    if (worst == poses.end() || worst->accuracy.missedPixels == 0) return std::nullopt;
    return size_t(worst - poses.begin());
}

Judgement judgeDrawn(const JudgeRequest& request, Renderer& renderer, const Progress& progress) {
    if (request.drawn.poses.size() != request.path.poses.size())
        throwInput(CULLSCOPE_TR("The drawn sets have %1 poses, and the camera path %2: give one set for each pose."),
                   {std::to_string(request.drawn.poses.size()), std::to_string(request.path.poses.size())});
    const SceneBuffers buffers(request.scene, Upload::Vbo);
    Framebuffer target(request.size);
    Judgement judgement;
    judgement.byObjects = request.drawn.byObjects;
    for (size_t pose = 0; pose < request.path.poses.size(); ++pose) {
        progress.check();
        progress.tell(double(pose) / double(request.path.poses.size()), CULLSCOPE_TR("judging"));
        judgement.poses.push_back(judgedPose(request, pose, renderer, buffers, target));
    }
    return judgement;
}

Message kindSentence(const Judgement& judgement) {
    uint64_t leftOut = 0, inVainInView = 0, missing = 0;
    for (const JudgedPose& pose : judgement.poses) {
        leftOut += pose.leftOut;
        inVainInView += pose.inVainInView;
        missing += pose.missing.size();
    }
    switch (judgement.kind()) {
        case CullingKind::None:
            return {CULLSCOPE_TR("No culling: nothing is left out, and %1 objects in view are drawn in vain."),
                    {std::to_string(inVainInView)}};
        case CullingKind::Frustum:
            return {
                CULLSCOPE_TR("View-frustum culling: all %1 objects that are left out lie outside the view, nothing that is seen "
                             "is missing, and %2 objects in view are drawn though they are hidden."),
                {std::to_string(leftOut), std::to_string(inVainInView)}};
        case CullingKind::Occlusion:
            return {CULLSCOPE_TR("Occlusion culling: what is left out in view is not seen, and nothing that is seen is missing."),
                    {}};
        case CullingKind::Unseen:
            return {CULLSCOPE_TR("Nothing of the scene is seen in any of these pictures: what is drawn cannot be judged by them. "
                                 "Give cameras that see it, or larger pictures."),
                    {}};
        case CullingKind::Lossy:
            break;
    }
    return {CULLSCOPE_TR("Something that is seen is missing: %1 times a visible object is not drawn whole."),
            {std::to_string(missing)}};
}

std::string judgementText(const Judgement& judgement, const JudgeRequest& request) {
    const Scene& scene = *request.scene;
    std::string text = fmt::format("{}: {} triangles in {} objects, {} poses, {}x{}, drawn {}\n", scene.name(),
                                   scene.triangleCount(), scene.instances().size(), judgement.poses.size(), request.size.width,
                                   request.size.height, judgement.byObjects ? "by objects" : "by triangles");
    text += fmt::format("{:>5} {:>10} {:>9} {:>9} {:>10} {:>10} {:>10} {:>9} {:>8}  {}\n", "pose", "covered px", "missed px",
                        "hole px", "visible", "drawn", "false cull", "in vain", "objects", "missing objects");
    constexpr size_t kNamed = 3;
    for (size_t i = 0; i < judgement.poses.size(); ++i) {
        const JudgedPose& pose = judgement.poses[i];
        std::string names;
        for (size_t object = 0; object < std::min(kNamed, pose.missing.size()); ++object)
            names += fmt::format("{}{} ({} px)", object == 0 ? "" : ", ", nameOf(scene, pose.missing[object].instance),
                                 pose.missing[object].pixels);
        if (pose.missing.size() > kNamed) names += fmt::format(", {} more", pose.missing.size() - kNamed);
        text += fmt::format("{:>5} {:>10} {:>9} {:>9} {:>10} {:>10} {:>10} {:>9} {:>8}  {}\n", i, pose.accuracy.coveredPixels,
                            pose.accuracy.missedPixels, pose.accuracy.largestHolePixels, pose.accuracy.visibleTriangles,
                            pose.accuracy.submittedTriangles, pose.accuracy.falselyCulledTriangles, pose.inVain,
                            pose.drawnObjects, names);
    }
    const Accuracy sum = judgement.total();
    text += fmt::format(
        "missed pixels {} of {} ({:.4g} %), falsely culled triangles {} of {} ({:.4g} %), waste {} of {} drawn ({:.4g} %)\n",
        sum.missedPixels, sum.coveredPixels, 100 * share(sum.missedPixels, sum.coveredPixels), sum.falselyCulledTriangles,
        sum.visibleTriangles, 100 * share(sum.falselyCulledTriangles, sum.visibleTriangles), sum.needlesslyDrawnTriangles,
        sum.submittedTriangles, 100 * share(sum.needlesslyDrawnTriangles, sum.submittedTriangles));
    return text + kindSentence(judgement).english() + "\n";
}

std::string judgementJson(const Judgement& judgement, const JudgeRequest& request, const GlInfo& gl) {
    constexpr std::array kKinds{"none", "frustum", "occlusion", "lossy", "nothing_seen"};
    const auto figures = [](const Accuracy& one) {
        return Json{{"covered_pixels", one.coveredPixels},
                    {"missed_pixels", one.missedPixels},
                    {"largest_hole_px", one.largestHolePixels},
                    {"visible_triangles", one.visibleTriangles},
                    {"submitted_triangles", one.submittedTriangles},
                    {"false_culled_triangles", one.falselyCulledTriangles},
                    {"needlessly_drawn_triangles", one.needlesslyDrawnTriangles}};
    };
    Json poses = Json::array();
    for (const JudgedPose& pose : judgement.poses) {
        Json one = figures(pose.accuracy);
        one["visible_objects"] = pose.visibleObjects;
        one["drawn_objects"] = pose.drawnObjects;
        one["objects_in_vain"] = pose.inVain;
        one["objects_in_vain_in_view"] = pose.inVainInView;
        one["objects_left_out"] = pose.leftOut;
        one["objects_left_out_in_view"] = pose.leftOutInView;
        one["missing_objects"] = Json::array();
        for (const SeenObject& object : pose.missing)
            one["missing_objects"].push_back(
                {{"number", object.instance}, {"name", nameOf(*request.scene, object.instance)}, {"pixels", object.pixels}});
        poses.push_back(std::move(one));
    }
    Json summary = figures(judgement.total());
    summary["missed_pixel_rate"] = share(judgement.total().missedPixels, judgement.total().coveredPixels);
    summary["false_negative_rate"] = share(judgement.total().falselyCulledTriangles, judgement.total().visibleTriangles);
    summary["waste"] = share(judgement.total().needlesslyDrawnTriangles, judgement.total().submittedTriangles);
    const Json root{
        {"tool", {{"name", "cullscope"}, {"version", toolVersion().version}, {"commit", toolVersion().commit}}},
        {"machine", {{"gl_renderer", gl.renderer}, {"gl_version", gl.version}}},
        {"scene",
         {{"name", request.scene->name()}, {"sha256", request.scene->sha256()}, {"triangles", request.scene->triangleCount()}}},
        {"drawn", request.drawn.file},
        {"path", request.path.name},
        {"size", {request.size.width, request.size.height}},
        {"by", judgement.byObjects ? "objects" : "triangles"},
        {"facing", facingId(request.facing)},
        {"kind", kKinds[size_t(judgement.kind())]},
        {"sentence", kindSentence(judgement).english()},
        {"right", judgement.right()},
        {"poses", std::move(poses)},
        {"summary", std::move(summary)}};
    return root.dump(2) + "\n";
}

}  // namespace cullscope::suite
