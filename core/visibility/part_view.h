#pragma once

#include <array>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What tests of parts of an object need of a view, in local coordinates: those of the object's mesh, relative to a centre and
/// perhaps turned. An affine transform maps sight lines to sight lines, so that all instances of a mesh share its structures.
struct PartView {
    /// The frustum's planes: normal · p + offset is the distance in world units; normals are not of unit length.
    std::array<Plane, 6> localPlanes{};
    double margin = 0.0;  ///< of these distances (geometry/frustum.h, conservativeMargin)
    Vec3 eye{0.0};
    bool eyeKnown = false;    ///< false: the object is flat, and the eye has no local coordinates
    double unevenness = 1.0;  ///< ratio of the longest to the shortest world length of a unit length
    double pixelSlope = 0.0;  ///< the width of a pixel divided by its distance
    double rounding = 0.0;    ///< upper bound on what the picture's rounding displaces besides (Scene::pictureRounding), in local
                              ///< units
};

/// The affine map from local coordinates to world axes with the origin at the eye: linear · p + centre.
struct EyeFromLocal {
    Mat3 linear{1.0};
    Vec3 centre{0.0};
    double margin = 0.0;    ///< of plane tests of what lies within the radius
    double rounding = 0.0;  ///< Scene::pictureRounding
    double stretch = 0.0;   ///< upper bound on the factor by which it lengthens a vector
};

/// Of an instance, in local coordinates around the middle of a sphere that is given relative to the mesh's origin and holds the
/// mesh. `meshFromLocal`: a rotation.
[[nodiscard]] EyeFromLocal eyeFromLocal(const Scene& scene, uint32_t instance, const Sphere& sphere, const Mat3& meshFromLocal,
                                        const Vec3& eye);

/// An object whose transform and its inverse lengthen vectors by more than this together is flat: directions within it are not
/// defined.
inline constexpr double kMostFlattened = 1e9;

/// An upper bound on the factor by which a vector is lengthened: the root of the sum of the squares.
[[nodiscard]] double frobenius(const Mat3& m);

/// Sets the planes, the margin, and what the picture's pixels are.
void setPlanes(PartView& seen, const View& view, const EyeFromLocal& object);
/// Sets the eye, where the object is not flat, and the unevenness. `inverse`: of `object.linear`.
void setEye(PartView& seen, const EyeFromLocal& object, const Mat3& inverse);

/// An instance as seen by a view, around the middle of its mesh's bounding sphere, in the mesh's axes.
[[nodiscard]] PartView partView(const Scene& scene, uint32_t instance, const View& view);

/// An upper bound on the displacement of a point in the picture, in local units for each unit of distance from the eye: by
/// snapping to 1/256 pixel (taken in full instead of half, once for x and y) and by OpenGL's float rounding.
[[nodiscard]] double snapping(const PartView& view);

}  // namespace cullscope
