#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "core/base/message.h"
#include "core/geometry/angle.h"
#include "core/geometry/bounds.h"

/// The 18 basic solids of which process plants are modelled (Du et al. 2017, Figure 1), as data. Lengths are in one unit, the
/// scene's or a file's. Each stands about its own origin and is placed by a transform. All are closed surfaces, also those
/// without a volume: a disc and a ring have two sides, and any solid may have the length 0.
namespace cullscope::primitive {

struct Sphere {
    double radius = 1.0;
};
/// About z, from −height/2 to height/2, as cones are.
struct Cylinder {
    double radius = 1.0, height = 1.0;
};
/// One of the radii may be 0.
struct Cone {
    double bottomRadius = 1.0, topRadius = 0.0, height = 1.0;
};
/// A slanted end of a pipe: its plane rises by the tangent of these angles along x and y.
struct Mitre {
    Angle x{}, y{};
};
/// A cone whose top is shifted against its bottom: bottom circle about −offset/2, top circle about offset/2. Its ends may be
/// mitred, each about its circle's centre.
struct EccentricCone {
    double bottomRadius = 1.0, topRadius = 0.5, height = 1.0;
    Vec2 offset{0.0};
    Mitre bottom{}, top{};
};
/// A cylinder whose ends are cut obliquely; `height` is the length of its axis.
struct MitredCylinder {
    double radius = 1.0, height = 1.0;
    Mitre bottom{}, top{};
};
/// A pipe's bend about z, in the plane z = 0: from the x axis by `sweep` (up to a turn) towards y. `ringRadius` is that of the
/// tube's middle line.
struct CircularTorus {
    double ringRadius = 1.0, tubeRadius = 0.25;
    Angle sweep = Angle::fromRadians(kTurn);
};
/// The same with a rectangle as its section, from −height/2 to height/2.
struct RectangularTorus {
    double innerRadius = 0.5, outerRadius = 1.0, height = 0.5;
    Angle sweep = Angle::fromRadians(kTurn);
};
/// Half an ellipsoid of revolution: its flat side is a disc in z = 0, its top at z = height. Dishes and heads end vessels.
struct EllipsoidalDish {
    double radius = 1.0, height = 0.5;
};
/// A spherical cap over a disc in z = 0, its top at z = height.
struct SphericalDish {
    double radius = 1.0, height = 0.5;
};
/// A spherical crown that passes into the vessel's wall by a knuckle, as in DIN 28011 (crown 2 radius, knuckle 0.2 radius), over
/// a disc in z = 0. Its height follows: torisphericalHeight.
struct TorisphericalHead {
    double radius = 1.0, crownRadius = 2.0, knuckleRadius = 0.2;
};
/// About the origin.
struct Box {
    Vec3 size{1.0};
};
/// Half a box: a ramp that rises along x from z = −size.z/2 to size.z/2.
struct Wedge {
    Vec3 size{1.0};
};
/// Over a rectangle in z = −height/2 about −apexOffset/2, its apex at z = height/2 above apexOffset/2.
struct Pyramid {
    Vec2 base{1.0};
    double height = 1.0;
    Vec2 apexOffset{0.0};
};
/// Between two rectangles, bottom about −offset/2 and top about offset/2. Sides of either may be 0, not both areas.
struct PyramidFrustum {
    Vec2 bottom{1.0}, top{0.5};
    double height = 1.0;
    Vec2 offset{0.0};
};
/// Over a regular polygon with one corner on the x axis; `radius` is that of the corners.
struct Prism {
    uint32_t sides = 6;
    double radius = 1.0, height = 1.0;
};
/// Flat, in z = 0, with two sides.
struct Disc {
    double radius = 1.0;
};
/// A disc with a hole.
struct Ring {
    double innerRadius = 0.5, outerRadius = 1.0;
};
struct HollowCylinder {
    double innerRadius = 0.5, outerRadius = 1.0, height = 1.0;
};

using Primitive =
    std::variant<Sphere, Cylinder, Cone, EccentricCone, MitredCylinder, CircularTorus, RectangularTorus, EllipsoidalDish,
                 SphericalDish, TorisphericalHead, Box, Wedge, Pyramid, PyramidFrustum, Prism, Disc, Ring, HollowCylinder>;

/// A kind of primitive is its place in the variant.
inline constexpr size_t kKinds = std::variant_size_v<Primitive>;
/// The kind's name in English, marked for translation: "cylinder".
[[nodiscard]] const char* kindName(size_t kind);

/// Why no such solid exists (a negative or infinite length, a hole wider than its ring, an angle of more than a turn, ends that
/// cut each other, nothing but a point or a line), as a sentence; none where it does.
[[nodiscard]] std::optional<Message> whyImpossible(const Primitive& primitive);

/// Of the exact solid, not of its tessellation, in cubes and squares of its unit; `area` is that of the whole closed surface.
/// The area of an eccentric or mitred cone is not known in closed form: it is integrated, to 1e-9 of it.
[[nodiscard]] double volume(const Primitive& primitive);
[[nodiscard]] double area(const Primitive& primitive);
/// The smallest axis-aligned box, up to rounding.
[[nodiscard]] Box3 bounds(const Primitive& primitive);

[[nodiscard]] double torisphericalHeight(const TorisphericalHead& head);
/// A mitred cylinder as the eccentric cone that it is.
[[nodiscard]] EccentricCone asEccentricCone(const MitredCylinder& cylinder);
/// Whether a sweep is a whole turn, within the rounding of files that keep angles in single precision: the torus has no ends.
[[nodiscard]] bool isWholeTurn(Angle sweep);
/// The slopes of a mitred end: the rise of its plane per unit of x and y.
[[nodiscard]] Vec2 slopes(const Mitre& mitre);
/// The crown's half angle as (sine, cosine), and its centre on the axis.
struct Crown {
    Vec2 edge{0.0};
    double centre = 0.0;
};
[[nodiscard]] Crown crownOf(const TorisphericalHead& head);

}  // namespace cullscope::primitive
