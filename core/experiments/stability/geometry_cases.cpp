// Cases of planes, boxes, angles and files.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "core/base/atomic_file.h"
#include "core/experiments/stability/case_findings.h"
#include "core/experiments/stability/lossless_check.h"
#include "core/geometry/separation.h"
#include "core/mesh/load.h"
#include "core/scene/gallery/gallery.h"
#include "core/spatial/spherical_search.h"
#include "core/spatial/spherical_triangle.h"

namespace cullscope::stability {
namespace {

constexpr const char* kStraddles = CULLSCOPE_TR("cut by a plane: not told apart");
constexpr const char* kOutside = CULLSCOPE_TR("outside");
constexpr const char* kInside = CULLSCOPE_TR("not outside");
constexpr const char* kSeparate = CULLSCOPE_TR("separate");
constexpr const char* kTouching = CULLSCOPE_TR("not separate");

Frustum usualFrustum() { return makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1, 1, 0.1, 10); }

EyeBox boxOf(const Vec3& min, const Vec3& max) { return {0.5 * (min + max), 0.5 * (max - min)}; }

Finding classified(std::string subject, Containment found, Containment expected) {
    const auto word = [](Containment containment) {
        return containment == Containment::Outside ? kOutside : containment == Containment::Inside ? kInside : kStraddles;
    };
    return holds(std::move(subject), word(expected), word(found), found == expected);
}

Finding separation(std::string subject, bool found, bool expected) {
    const auto word = [](bool separate) { return separate ? kSeparate : kTouching; };
    return holds(std::move(subject), word(expected), word(found), found == expected);
}

Vec3 direction(double zenith, double azimuth) {
    const double theta = Angle::fromDegrees(zenith).radians(), phi = Angle::fromDegrees(azimuth).radians();
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

std::set<uint32_t> columnsOf(const SphericalTriangle& triangle, uint32_t row) {
    std::set<uint32_t> columns;
    triangle.forEachCell(SphericalGrid(), [&](const SphericalGrid::Cell& cell) {
        if (cell.row == row) columns.insert(cell.column);
    });
    return columns;
}

std::string listed(const std::set<uint32_t>& columns) {
    std::string text;
    for (const uint32_t column : columns) text += (text.empty() ? "" : ", ") + std::to_string(column);
    return text;
}

double degreesOf(double radians) { return Angle::fromRadians(radians).degrees(); }

/// Writes a file in the folder for temporary ones, reads it, and removes it.
LoadedFile loaded(const std::string& text) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("cullscope-case-5-" + std::to_string(getpid()) + ".obj");
    writeFileAtomically(path, [&](std::ostream& out) { out << text; });
    struct Removed {
        std::filesystem::path path;
        ~Removed() {
            std::error_code ignored;
            std::filesystem::remove(path, ignored);
        }
    } const removed{path};
    return loadMeshFile(path);
}

/// What the scene's strategies do, behind the findings of the geometry.
Findings withStrategies(const Bench& bench, const StabilityCase& which, Findings findings) {
    for (Finding& finding : everyStrategyOnTheScene(bench, which)) findings.push_back(std::move(finding));
    return findings;
}

}  // namespace

Findings sphereBesideTheFrustum(const Bench& bench, const StabilityCase& which) {
    const Sphere sphere{{13, 13, -11}, 1.5};
    const double distance = std::sqrt(19.0);
    return withStrategies(
        bench, which,
        {asControl(classified("classify(sphere)", classify(usualFrustum(), sphere), Containment::Straddles)),
         separation("separated(sphere)", separated(usualFrustum(), sphere, conservativeMargin(30)), true),
         separation("separated(radius 4.36 - 1e-9)", separated(usualFrustum(), Sphere{sphere.centre, distance - 1e-9}, 0), true),
         separation("separated(radius 4.36)", separated(usualFrustum(), Sphere{sphere.centre, distance}, 0), false)});
}

Findings boxBesideTheFrustum(const Bench& bench, const StabilityCase& which) {
    const EyeBox box = boxOf({15, -5, -30}, {40, 5, -9.5});
    return withStrategies(
        bench, which,
        {asControl(classified("classify(box)", classify(usualFrustum(), box), Containment::Straddles)),
         separation("separated(box)", separated(usualFrustum(), box, conservativeMargin(60)), true),
         separation("separated(box, 5 wider)", separated(usualFrustum(), boxOf({10, -5, -30}, {40, 5, -9.5}), 0), false)});
}

Findings flatBox(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    const Plane below{{0, -1, 0}, 0};
    const EyeBox box{{0, 10, 0}, {60, 1, 1}};
    const double byLength = below.distance(box.centre) + glm::length(box.halfExtent);
    return {asControl(holds("extent length", kInside, byLength >= 0 ? kInside : kOutside, byLength >= 0)),
            holds("p-vertex", kOutside, pVertexDistance(below, box) < 0 ? kOutside : kInside, pVertexDistance(below, box) < 0),
            classified("classify(plane)", classify(below, box, conservativeMargin(70)), Containment::Outside)};
}

Findings planeFarFromTheOrigin(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    const Vec3 normal(.6, 0, -.8), on(1e7 + 5.5, 0, -1e7 + 6.5), centre(1e7 + 8.5, 0, -1e7 + 7.5);
    const Plane inWorld{normal, -glm::dot(normal, on)};
    const Plane fromEye{normal, 0.0};  // as the library has it: relative to a point of the plane
    const Vec3f normalF(normal), onF(on), centreF(centre);
    const float byFloat = glm::dot(normalF, centreF) + -glm::dot(normalF, onF);
    return {number("double", 1.0, inWorld.distance(centre), 1e-6),
            number("relative to the eye", 1.0, fromEye.distance(centre - on), 1e-12),
            asControl(number("float", -2.0, double(byFloat), 0.5))};
}

Findings brokenFiles(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const LoadedFile clean = loaded(good);
    const LoadedFile broken = loaded(good +
                                     "v nan 0 0\nv 1 inf 0\nv 3 3 3\nf 1 2 4\nf 1 5 3\nf 6 6 6\nf 1 2 99\nf 2 3 1000000000\nv 5 "
                                     "0 0\nv 6 0 0\nv 7 0 0\nf 7 8 9\n");
    Box3 inverted;
    inverted.min = Vec3(1.0);
    inverted.max = Vec3(-1.0);
    const auto count = [](size_t value) { return double(value); };
    return {
        number("clean file, triangles", 1, count(clean.report.trianglesMade), 0),
        number("broken file, triangles", 1, count(broken.report.trianglesMade), 0),
        number("broken file, vertices that are not finite", 2, count(broken.report.nonFiniteVertices), 0),
        number("broken file, faces without area", 2, count(broken.report.degenerateFaces), 0),
        number("broken file, faces out of range", 2, count(broken.report.outOfRangeFaces), 0),
        holds("box with min > max", CULLSCOPE_TR("empty"), inverted.empty() ? CULLSCOPE_TR("empty") : kInside, inverted.empty())};
}

Findings triangleOverTheSeam(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    const Vec3 a = direction(89.2, 359.5), b = direction(89.5, 0.2), c = direction(89.8, 0.5);
    const std::set<uint32_t> columns = columnsOf({a, b, c}, 89);
    return {{"columns", {"0, 359", {}}, {listed(columns), {}}, columns == std::set<uint32_t>{0, 359}},
            number("centroid, degrees", 0.0667, degreesOf(sphericalPoint((a + b + c) / 3.0).phi), 1e-3)};
}

Findings triangleOverThePole(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    const SphericalTriangle triangle(direction(1, 0), direction(1, 120), direction(1, 240));
    return {number("columns of the polar row", 360, double(columnsOf(triangle, 0).size()), 0)};
}

Findings azimuths(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    return {number("(-1, -1, 0), degrees", 225, degreesOf(sphericalPoint({-1, -1, 0}).phi), 1e-12),
            number("(0, 1, 0), degrees", 90, degreesOf(sphericalPoint({0, 1, 0}).phi), 1e-12)};
}

Findings azimuthThatRoundsToATurn(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    Findings findings;
    for (const double y : {-1e-17, -1e-30, -std::numeric_limits<double>::denorm_min(), -0.0, 1e-17}) {
        const uint32_t column = SphericalGrid().cellOf({1, y, 0}).column;
        findings.push_back(
            {fmt::format("(1, {:g}, 0)", y), {"0, 359", {}}, {std::to_string(column), {}}, column == 0 || column == 359});
    }
    return findings;
}

Findings smallZenith(const Bench& /*bench*/, const StabilityCase& /*which*/) {
    // acos of the normalised z gives 0.
    const double byCosine = std::acos(1.0 / std::sqrt(1.0 + 1e-18));
    return {number("atan2, degrees", 5.72957795e-8, degreesOf(sphericalPoint({1e-9, 0, 1}).theta), 1e-15),
            asControl(number("acos, degrees", 0, degreesOf(byCosine), 0))};
}

Findings cornersAtTheCentre(const Bench& bench, const StabilityCase& which) {
    const ScenePointer scene = galleryScene(which.scene);
    const SphericalMaps maps(scene->meshes().front(), SphericalGrid(36, 18));
    size_t hit = 0, rays = 0, infinite = 0;
    for (uint32_t cell = 0; cell < maps.grid().cellCount(); ++cell)
        if (!maps.extent(cell).empty() &&
            !(std::isfinite(maps.extent(cell).nearest) && std::isfinite(maps.extent(cell).farthest)))
            ++infinite;
    // They are candidates in every direction: rays from all sides hit them.
    for (int i = 0; i < 36; ++i) {
        const Vec3 eye = 3.0 * direction(20.0, 10.0 * i + 1.0);
        for (const Vec3& target : {Vec3(0.1, 0.1, 0.0), Vec3(-0.05, 0.02, 0.0)}) {
            ++rays;
            hit += searchTriangle(maps, {eye, target - eye}) ? 1 : 0;
        }
    }
    return withStrategies(
        bench, which,
        {number("rays that hit", double(rays), double(hit), 0), number("cells without a finite extent", 0, double(infinite), 0)});
}

Findings rayOfImpact(const Bench& bench, const StabilityCase& which) {
    const ScenePointer scene = galleryScene(which.scene);
    const SphericalMaps maps(scene->meshes().front(), SphericalGrid());
    const Ray ray{{-3, 0.45, 0}, {1, 0, 0}};
    const auto hit = searchTriangle(maps, ray);
    double turn = 0.0, radius = 0.0;
    if (hit) {
        const Vec3 entry = ray.at(throughSphere(ray, maps.sphere().radius)->from), surface = ray.at(hit->t);
        turn = degreesOf(std::acos(glm::dot(glm::normalize(entry), glm::normalize(surface))));
        radius = glm::length(surface);
    }
    return withStrategies(bench, which,
                          {number("radius of the surface that is hit", 0.5, radius, 5e-3),
                           number("degrees from entry to surface", 37.4, turn, 1.5)});
}

Findings boxesAroundTheEye(const Bench& bench, const StabilityCase& which) {
    const EyeBox near{{0, 0, 0}, {1, 1, 3}}, far{{0, 0, 0}, Vec3(1000)};
    Findings findings;
    for (const auto& [name, box] : {std::pair("box around the eye", near), std::pair("box beyond far", far)}) {
        const bool outside = classify(usualFrustum(), box) == Containment::Outside || separated(usualFrustum(), box, 0.0);
        findings.push_back(holds(name, kInside, outside ? kOutside : kInside, !outside));
    }
    return withStrategies(bench, which, std::move(findings));
}

}  // namespace cullscope::stability
