#include "core/image/picture_metadata.h"

#include "core/base/version.h"

namespace cullscope {
namespace {

std::string text(double number) { return toText(ParameterValue(number)); }
std::string text(const Vec3& v) { return text(v.x) + "," + text(v.y) + "," + text(v.z); }

std::string overlays(const ViewLook& look) {
    std::string names;
    for (const std::string& id : overlayIds(look)) names += (names.empty() ? "" : ",") + id;
    return names;
}

}  // namespace

std::string sizeText(const Viewport& size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

PictureMetadata subjectMetadata(const PictureSubject& subject, std::string_view prefix) {
    PictureMetadata pairs;
    const auto add = [&](const std::string& name, std::string value) {
        if (!value.empty()) pairs.emplace_back(std::string(prefix) + name, std::move(value));
    };
    const auto addCamera = [&](const std::string& role, const Camera& camera) {
        add(role + "eye", text(camera.eye));
        add(role + "target", text(camera.target));
        add(role + "up", text(camera.up));
        add(role + "fovy_deg", text(camera.fovy.degrees()));
        if (camera.projection == ProjectionKind::Parallel) {
            add(role + "projection", projectionId(camera.projection));
            add(role + "height", text(camera.height));
        }
        add(role + "near", text(camera.nearDistance));
        add(role + "far", text(camera.farDistance));
    };
    add("scene", subject.scene);
    add("hide", subject.hidden);
    add("strategy", subject.strategy);
    for (const ParameterDeclaration& declaration : subject.parameters.declarations())
        add("parameter:" + declaration.key, toText(subject.parameters.value(declaration.key)));
    addCamera("", subject.culling);
    if (!(subject.viewing == subject.culling)) addCamera("view_", subject.viewing);
    add("size", sizeText(subject.size));
    if (!(subject.cullingSize == subject.size)) add("culling_size", sizeText(subject.cullingSize));
    if (subject.section) add("section", sectionText(*subject.section));
    add("overlay", subject.picture.empty() ? overlays(subject.look) : subject.picture);
    add("map_colouring", subject.pictureColouring);
    for (const auto& [name, value] : unusualOf(subject.look))
        if (subject.picture.empty()) add(name, value);
    if (subject.submittedTriangles) add("submitted_triangles", std::to_string(*subject.submittedTriangles));
    if (subject.missedPixels) add("missed_pixels", std::to_string(*subject.missedPixels));
    if (subject.ratioToSameSides) {
        const auto& [ratio, interval, baseline] = *subject.ratioToSameSides;
        add("ratio_to_same_sides", text(ratio));
        add("ratio_to_same_sides_ci95", text(interval[0]) + "," + text(interval[1]));
        add("same_sides_baseline", baseline);
    }
    if (subject.figuresSize) add("figures_size", sizeText(*subject.figuresSize));
    return pairs;
}

PictureMetadata programMetadata(std::string_view glRenderer) {
    return {{"cullscope:version", CULLSCOPE_VERSION},
            {"cullscope:commit", buildCommit()},
            {"cullscope:gl_renderer", std::string(glRenderer)}};
}

}  // namespace cullscope
