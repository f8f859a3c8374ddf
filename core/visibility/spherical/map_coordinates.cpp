#include "core/visibility/spherical/map_coordinates.h"

#include <algorithm>

#include "core/base/message.h"

namespace cullscope::spherical {
namespace {

Vec3 surfaceMiddle(const TriangleMesh& mesh) {
    Vec3 sum(0.0);
    double area = 0.0;
    for (size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
        const auto corner = [&](size_t i) { return Vec3(mesh.positions()[mesh.indices()[3 * triangle + i]]); };
        const Vec3 a = corner(0), b = corner(1), c = corner(2);
        const double size = glm::length(glm::cross(b - a, c - a));
        sum += size * (a + b + c) / 3.0;
        area += size;
    }
    return area > 0.0 ? sum / area : mesh.localSphere().centre;
}

}  // namespace

std::vector<ParameterDeclaration> coordinateParameters() {
    return {readWhenBuilding(choiceParameter("axis", "z", CULLSCOPE_TR("The mesh's axis to which the map's poles belong."),
                                             {{"z", CULLSCOPE_TR("z, as in equation (1)")},
                                              {"x", CULLSCOPE_TR("x")},
                                              {"y", CULLSCOPE_TR("y, which points up in many models")}})),
            readWhenBuilding(choiceParameter("origin", "sphere",
                                             CULLSCOPE_TR("The point from which R and the directions are measured."),
                                             {{"sphere", CULLSCOPE_TR("the centre of the bounding sphere")},
                                              {"box", CULLSCOPE_TR("the middle of the bounding box")},
                                              {"centroid", CULLSCOPE_TR("the centroid of the surface")}}))};
}

MapCoordinates coordinatesOf(const ParameterSet& parameters) {
    MapCoordinates coordinates;
    const std::string &axis = parameters.choice("axis"), &origin = parameters.choice("origin");
    if (axis != "z") coordinates.axis = axis == "x" ? PolarAxis::X : PolarAxis::Y;
    if (origin != "sphere") coordinates.origin = origin == "box" ? MapOrigin::Box : MapOrigin::Centroid;
    return coordinates;
}

MapFrame mapFrame(const TriangleMesh& mesh, const MapCoordinates& coordinates) {
    MapFrame frame{mesh.localSphere()};
    // The axes in another order, without a reflection.
    const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    if (coordinates.axis == PolarAxis::X) frame.meshFromMap = Mat3(y, z, x);
    if (coordinates.axis == PolarAxis::Y) frame.meshFromMap = Mat3(z, x, y);
    if (coordinates.origin == MapOrigin::Sphere) return frame;
    frame.sphere.centre = coordinates.origin == MapOrigin::Box ? mesh.localBounds().centre() : surfaceMiddle(mesh);
    double squared = 0.0;
    for (const uint32_t vertex : mesh.indices()) {
        const Vec3 offset = Vec3(mesh.positions()[vertex]) - frame.sphere.centre;
        squared = std::max(squared, glm::dot(offset, offset));
    }
    // Rounded outward.
    frame.sphere.radius = std::sqrt(squared) * (1.0 + 1e-12);
    return frame;
}

}  // namespace cullscope::spherical
