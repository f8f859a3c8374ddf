#include "core/image/spherical_model.h"

#include <algorithm>
#include <numbers>

#include "core/gpu/colour.h"
#include "core/spatial/spherical_search.h"

namespace cullscope {
namespace {

// In units (DrawStyle::unit).
constexpr float kFrameWidth = 1.0f;
constexpr float kModelMargin = 40.0f;
constexpr double kModelTick = 3.5;
constexpr double kLongTick = 6.0;

/// Cividis, which can be read with every colour vision (Nuñez, Anderton & Renslow 2018), starting at a slightly lighter colour.
constexpr std::array<uint32_t, 5> kRelief{0x2C4478, 0x434E6C, 0x7D7C78, 0xBCAF6F, 0xFEE838};

/// The map's border with ticks at φ below and at θ on the left, as world lines at those pixels for the viewing camera.
std::vector<LineSegment> frameLines(const View& viewing, const MapArea& area, const DrawStyle& style) {
    const Vec3f colour = contrastTo(style.background);
    const auto at = [&](double right, double up) {
        return viewing.pointAt(area.left + right * area.width, area.bottom + up * area.height, viewing.camera().nearDistance);
    };
    const std::array corners{at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)};
    std::vector<LineSegment> lines;
    for (size_t i = 0; i < corners.size(); ++i) lines.push_back({corners[i], corners[(i + 1) % corners.size()], colour});
    for (int degrees = 0; degrees <= 360; degrees += 30) {
        const double length = double(style.unit) * (degrees % 90 == 0 ? kLongTick : kModelTick);
        lines.push_back({at(degrees / 360.0, -length / area.height), at(degrees / 360.0, 0.0), colour});
        if (degrees > 180) continue;
        lines.push_back({at(-length / area.width, 1.0 - degrees / 180.0), at(0.0, 1.0 - degrees / 180.0), colour});
    }
    return lines;
}

/// The direction shown at a pixel; none outside of the map.
std::optional<Vec3> directionAt(const MapArea& area, int x, int y) {
    const double phi = (x + 0.5 - area.left) / area.width * 2.0 * std::numbers::pi;
    const double theta = (1.0 - (y + 0.5 - area.bottom) / area.height) * std::numbers::pi;
    if (phi < 0.0 || phi > 2.0 * std::numbers::pi || theta < 0.0 || theta > std::numbers::pi) return std::nullopt;
    return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

}  // namespace

std::array<Vec3f, 5> reliefColours() {
    std::array<Vec3f, 5> colours;
    std::transform(kRelief.begin(), kRelief.end(), colours.begin(), colourFromHexadecimal);
    return colours;
}

Vec3f reliefColour(double share) { return colourFromRamp(kRelief, share); }

std::optional<uint32_t> sphericalModelInstance(const DrawList& list) {
    if (list.ranges.empty()) return std::nullopt;
    return list.ranges.front().instance;
}

bool hasWholeModel(const Scene& scene, const DrawList& list) {
    const std::optional<uint32_t> shown = sphericalModelInstance(list);
    if (!shown) return false;
    uint64_t submitted = 0;
    for (const DrawRange& range : list.ranges)
        if (range.instance == *shown) submitted += range.indexCount / 3;
    return submitted >= scene.meshOf(*shown).triangleCount();
}

MapArea sphericalModelArea(const Viewport& size, const DrawStyle& style) {
    return mapArea(size, double(kModelMargin * style.unit));
}

void drawSphericalModel(Renderer& renderer, const SceneBuffers& buffers, const View& viewing, const DrawList& list,
                        const DrawStyle& style, Framebuffer& target) {
    SphericalModel model;
    if (const std::optional<uint32_t> shown = sphericalModelInstance(list)) {
        model.instance = *shown;
        model.sphere = buffers.scene().meshOf(*shown).localSphere();
    }
    model.ramp = reliefColours();
    model.area = sphericalModelArea(viewing.viewport(), style);
    renderer.drawSpherical(buffers, viewing, list, model, target, style);
    renderer.drawLines(viewing, frameLines(viewing, model.area, style), {kFrameWidth * style.unit, false}, target);
}

std::optional<DirectionPick> pickSphericalModel(const Scene& scene, const DrawList& list, const Viewport& size,
                                                const DrawStyle& style, int x, int y) {
    const std::optional<uint32_t> shown = sphericalModelInstance(list);
    const std::optional<Vec3> direction = directionAt(sphericalModelArea(size, style), x, y);
    if (!shown || !direction) return std::nullopt;
    const Instance& instance = scene.instances()[*shown];
    const TriangleMesh& mesh = scene.meshOf(*shown);
    const Ray ray{Vec3(0.0), *direction};
    std::optional<TriangleHit> farthest;
    for (const DrawRange& range : list.ranges) {
        if (range.instance != *shown) continue;
        for (uint64_t place = range.firstIndex / 3; place < (uint64_t{range.firstIndex} + range.indexCount) / 3; ++place) {
            const auto triangle = uint32_t(list.triangleAt(instance.mesh, place));
            std::array<Vec3, 3> corners;
            for (size_t i = 0; i < 3; ++i)
                corners[i] = Vec3(mesh.positions()[mesh.indices()[size_t{3} * triangle + i]]) - mesh.localSphere().centre;
            const std::optional<double> t = hit(ray, corners);
            if (t && *t > 0.0 && (!farthest || *t > farthest->t)) farthest = TriangleHit{triangle, *t};
        }
    }
    if (!farthest) return std::nullopt;
    const Vec3 inMesh = mesh.origin() + mesh.localSphere().centre + ray.at(farthest->t);
    return DirectionPick{scene.firstTriangle(*shown) + farthest->triangle, Vec3(instance.worldFromMesh * Vec4(inMesh, 1.0))};
}

}  // namespace cullscope
