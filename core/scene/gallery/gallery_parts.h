#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope::gallery {

/// What a scene of the gallery consists of.
struct Parts {
    std::vector<MeshPointer> meshes;
    std::vector<Instance> instances;
    std::vector<Camera> cameras;  ///< the first one is the one that a window shows

    /// Adds a mesh with an instance of it.
    Parts& add(MeshPointer mesh, const Mat4& place = Mat4(1.0));
    /// Adds one more instance of the newest mesh.
    Parts& copy(const Mat4& place);
    Parts& from(const Camera& camera);
    Parts& from(const std::vector<Camera>& all);
};

// The parts of one scene each: solids and maps of directions.
[[nodiscard]] Parts sphereBesideTheCorner();
[[nodiscard]] Parts boxBesideTheCorner();
[[nodiscard]] Parts cornersAtTheCentre();
[[nodiscard]] Parts latitudes();
[[nodiscard]] Parts pole();
[[nodiscard]] Parts missedByCornerRays();
[[nodiscard]] Parts ballInItsSphere();
[[nodiscard]] Parts torus();
[[nodiscard]] Parts bowl();
[[nodiscard]] Parts insideAStar();
[[nodiscard]] Parts narrowField();
[[nodiscard]] Parts wideField();
[[nodiscard]] Parts mirrored();
[[nodiscard]] Parts partlyInsideOut();

// Depths, sizes and places.
[[nodiscard]] Parts twoDepths();
[[nodiscard]] Parts tiny();
[[nodiscard]] Parts huge();
[[nodiscard]] Parts mixedSizes();
[[nodiscard]] Parts atTheOrigin();
[[nodiscard]] Parts movedByTransforms();
[[nodiscard]] Parts movedByCoordinates();
[[nodiscard]] Parts boxAroundTheEye();
[[nodiscard]] Parts turningBehindWalls();
[[nodiscard]] Parts boxAroundTheView();
[[nodiscard]] Parts smallAbuttingParts();
[[nodiscard]] Parts oneRoundingApart();
[[nodiscard]] Parts acrossTheNearPlane();
[[nodiscard]] Parts nothingBesideSomething();

// What cases compute with that draw nothing.
[[nodiscard]] Parts flatBoxAboveAPlane();
[[nodiscard]] Parts sphereAtAFarPlane();
[[nodiscard]] Parts whatIsLeftOfABrokenFile();
[[nodiscard]] Parts triangleOverTheSeam();
[[nodiscard]] Parts triangleOverThePole();
[[nodiscard]] Parts azimuthsOfOtherQuadrants();
[[nodiscard]] Parts azimuthThatRoundsToATurn();
[[nodiscard]] Parts smallZenithAngle();
[[nodiscard]] Parts boxesToBeNamed();

// Order and pixels.
[[nodiscard]] Parts barsInACycle();
[[nodiscard]] Parts pixelRule();
[[nodiscard]] Parts coplanar();
[[nodiscard]] Parts sharedEdges();
[[nodiscard]] Parts slivers();
[[nodiscard]] Parts randomTriangles();

// Helpers that they share.
[[nodiscard]] Mat4 moved(const Vec3& by);
[[nodiscard]] Mat4 scaled(const Vec3& by);
[[nodiscard]] Mat4 turned(const Vec3& axis, double radians);
/// A mesh from positions and three indices a triangle, its float coordinates about `origin`.
[[nodiscard]] MeshPointer meshOf(std::vector<Vec3f> positions, std::vector<uint32_t> indices, const Vec3& origin = Vec3(0.0));
/// Three corners a triangle.
[[nodiscard]] MeshPointer soup(std::vector<Vec3f> corners);
/// A closed box that faces outward.
[[nodiscard]] MeshPointer box(const Vec3& min, const Vec3& max);
/// A square at height z that faces +z.
[[nodiscard]] MeshPointer square(float half, float z);
/// The camera of the battery: at the origin, looking down −z, 90°, near 0.1, far 10.
[[nodiscard]] Camera usualCamera();
/// A camera at `eye`, with the usual axis up a little off the coordinate axes, so that no edge falls on pixel centres by chance.
[[nodiscard]] Camera cameraAt(const Vec3& eye, double fovyDegrees, const Vec3& target = Vec3(0.0), double far = 1000.0);

}  // namespace cullscope::gallery
