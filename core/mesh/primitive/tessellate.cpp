#include "core/mesh/primitive/tessellate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/mesh/primitive/turn.h"

namespace cullscope::primitive {
namespace {

Vec3 unit(const Vec3& vector, const Vec3& otherwise) {
    const double length = glm::length(vector);
    return length > 0.0 && std::isfinite(length) ? vector / length : otherwise;
}

/// A point of the section of a solid of revolution: distance from the axis and height, and the normal there.
struct SectionPoint {
    Vec2 at{0.0}, normal{0.0};
};
using Section = std::vector<SectionPoint>;

/// A straight edge of a section; the solid lies to its left.
Section edge(const Vec2& from, const Vec2& to) {
    const Vec2 along = to - from;
    const Vec3 normal = unit(Vec3(along.y, -along.x, 0.0), Vec3(1.0, 0.0, 0.0));
    return {{from, Vec2(normal)}, {to, Vec2(normal)}};
}

/// The directions around an axis at which a section stands.
struct Around {
    std::vector<Vec2> directions;
    bool whole = true;
};

Around fullCircle(uint32_t chords) {
    Around around;
    for (uint32_t i = 0; i < chords; ++i) around.directions.push_back(onCircle(i, chords));
    return around;
}

Around sweepOf(Angle sweep, uint32_t chordsOfFullCircle) {
    if (isWholeTurn(sweep)) return fullCircle(chordsOfFullCircle);
    const auto chords = uint32_t(std::max(1.0, std::ceil(chordsOfFullCircle * (sweep.radians() / kTurn) - 1e-9)));
    Around around{{}, false};
    for (uint32_t i = 0; i <= chords; ++i) around.directions.push_back(onCircle(sweep * (double(i) / chords)));
    return around;
}

Fineness halved(Fineness fineness) {
    fineness.chordError *= 0.5;
    return fineness;
}

class Tessellation {
public:
    Tessellation(Surface& surface, const Fineness& fineness, const Mat4& transform)
        : m_surface(surface),
          m_fineness(fineness),
          m_transform(transform),
          m_normals(glm::transpose(glm::inverse(Mat3(transform)))),
          m_mirrored(glm::determinant(Mat3(transform)) < 0.0) {}

    void add(const Sphere& s) {
        const uint32_t chords = doublyCurved(s.radius);
        Section section;
        const uint32_t rows = std::max(2U, chords / 2);
        for (uint32_t row = 0; row <= rows; ++row) {
            const Vec2 turn = onCircle(row, 2 * rows);  // from the lower pole
            section.push_back({s.radius * Vec2(turn.y, -turn.x), Vec2(turn.y, -turn.x)});
        }
        revolve(section, fullCircle(chords));
    }

    void add(const Cylinder& s) { add(Cone{s.radius, s.radius, s.height}); }
    void add(const Cone& s) {
        const Around around = fullCircle(chords(std::max(s.bottomRadius, s.topRadius)));
        revolve(edge({s.bottomRadius, -0.5 * s.height}, {s.topRadius, 0.5 * s.height}), around);
        cap(s.bottomRadius, -0.5 * s.height, around, false);
        cap(s.topRadius, 0.5 * s.height, around, true);
    }

    void add(const MitredCylinder& s) { add(asEccentricCone(s)); }
    void add(const EccentricCone& s) {
        const Around around = fullCircle(chords(std::max(s.bottomRadius, s.topRadius)));
        const Vec2 low = slopes(s.bottom), high = slopes(s.top);
        const Vec3 middle(0.5 * s.offset, 0.5 * s.height);
        std::vector<Vec3> bottom, top;
        const uint32_t first = size();
        for (const Vec2& u : around.directions) {
            bottom.push_back(Vec3(s.bottomRadius * u, s.bottomRadius * glm::dot(low, u)) - middle);
            top.push_back(Vec3(s.topRadius * u, s.topRadius * glm::dot(high, u)) + middle);
            const Vec3 rise = top.back() - bottom.back();
            const Vec2 along(-u.y, u.x);
            vertex(bottom.back(), unit(glm::cross(Vec3(along, glm::dot(low, along)), rise), Vec3(u, 0.0)));
            vertex(top.back(), unit(glm::cross(Vec3(along, glm::dot(high, along)), rise), Vec3(u, 0.0)));
        }
        for (uint32_t i = 0; i < bottom.size(); ++i) {
            const uint32_t here = first + 2 * i, next = first + 2 * uint32_t((i + 1) % bottom.size());
            quad(here, next, next + 1, here + 1);
        }
        std::ranges::reverse(bottom);
        polygon(bottom, Vec3(low, -1.0), 0);
        polygon(top, Vec3(-high, 1.0), 0);
    }

    void add(const CircularTorus& s) {
        const uint32_t chords = doublyCurved(s.tubeRadius);
        Section section;
        for (uint32_t i = 0; i <= chords; ++i) {
            const Vec2 turn = onCircle(i, chords);
            section.push_back({Vec2(s.ringRadius, 0.0) + s.tubeRadius * turn, turn});
        }
        const Around around = sweepOf(s.sweep, doublyCurved(s.ringRadius + s.tubeRadius));
        revolve(section, around);
        section.pop_back();
        ends(section, around);
    }

    void add(const RectangularTorus& s) {
        const Around around = sweepOf(s.sweep, chords(s.outerRadius));
        const double low = -0.5 * s.height, high = 0.5 * s.height;
        std::vector<Vec2> corners{{s.innerRadius, low}, {s.outerRadius, low}, {s.outerRadius, high}, {s.innerRadius, high}};
        // Without a height, the lower side's edges across the ring must not be those of the upper side.
        if (s.height == 0.0) corners.insert(corners.begin() + 1, Vec2(0.5 * (s.innerRadius + s.outerRadius), 0.0));
        Section section;
        for (size_t i = 0; i < corners.size(); ++i) {
            revolve(edge(corners[i], corners[(i + 1) % corners.size()]), around);
            section.push_back({corners[i], {}});
        }
        ends(section, around);
    }

    void add(const EllipsoidalDish& s) {
        const uint32_t rows = std::max(1U, (doublyCurved(std::max(s.radius, s.height)) + 3) / 4);
        Section section;
        for (uint32_t row = 0; row <= rows; ++row) {
            const Vec2 turn = onCircle(row, 4 * rows);
            const Vec3 normal = unit(Vec3(s.height * turn.x, s.radius * turn.y, 0.0), Vec3(0.0, 1.0, 0.0));
            section.push_back({Vec2(s.radius, s.height) * turn, Vec2(normal)});
        }
        dish(section, s.radius);
    }

    void add(const SphericalDish& s) {
        if (s.height == 0.0) return add(Disc{s.radius});
        const double sphere = (s.radius * s.radius + s.height * s.height) / (2.0 * s.height), centre = s.height - sphere;
        Section section;
        for (const Vec2& point : arc(Vec2(s.radius, -centre) / sphere, {0.0, 1.0}, sphere))
            section.push_back({Vec2(0.0, centre) + sphere * point, point});
        // The ends are given, so that the flat side and the apex close exactly.
        section.front().at = {s.radius, 0.0};
        section.back().at = {0.0, s.height};
        dish(section, s.radius);
    }

    void add(const TorisphericalHead& s) {
        const Crown crown = crownOf(s);
        Section section;
        if (s.knuckleRadius > 0.0) {
            for (const Vec2& point : arc({1.0, 0.0}, crown.edge, s.knuckleRadius))
                section.push_back({Vec2(s.radius - s.knuckleRadius, 0.0) + s.knuckleRadius * point, point});
            section.pop_back();  // the crown begins there, with the same normal
        }
        for (const Vec2& point : arc(crown.edge, {0.0, 1.0}, s.crownRadius))
            section.push_back({Vec2(0.0, crown.centre) + s.crownRadius * point, point});
        section.front().at = {s.radius, 0.0};
        section.back().at.x = 0.0;
        dish(section, s.radius);
    }

    void add(const Box& s) { add(PyramidFrustum{Vec2(s.size), Vec2(s.size), s.size.z}); }

    void add(const Wedge& s) {
        const Vec3 h = 0.5 * s.size;
        const Vec3 a(-h.x, -h.y, -h.z), b(h.x, -h.y, -h.z), c(h.x, h.y, -h.z), d(-h.x, h.y, -h.z), e(h.x, -h.y, h.z),
            f(h.x, h.y, h.z);
        // The ramp's diagonal crosses that of the base and that of the back, so that a wedge without a height is closed too.
        face({a, e, f, d}, 0);
        face({a, d, c, b}, 1);
        face({b, c, f, e}, 1);
        face({a, b, e}, 0);
        face({d, f, c}, 0);
    }

    void add(const Pyramid& s) { add(PyramidFrustum{s.base, Vec2(0.0), s.height, s.apexOffset}); }

    void add(const PyramidFrustum& s) {
        const Vec3 middle(0.5 * s.offset, 0.5 * s.height);
        std::array<Vec3, 8> corners;
        for (size_t i = 0; i < 4; ++i) {
            const Vec2 side(i == 1 || i == 2 ? 0.5 : -0.5, i >= 2 ? 0.5 : -0.5);
            corners[i] = Vec3(side * s.bottom, 0.0) - middle;
            corners[4 + i] = Vec3(side * s.top, 0.0) + middle;
        }
        const auto& [a, b, c, d, e, f, g, h] = corners;
        // Opposite faces have crossing diagonals, so that a box without a height is closed too.
        face({a, d, c, b}, 0);
        face({e, f, g, h}, 1);
        face({a, b, f, e}, 0);
        face({c, d, h, g}, 0);
        face({b, c, g, f}, 0);
        face({d, a, e, h}, 0);
    }

    void add(const Prism& s) {
        std::vector<Vec3> bottom, top;
        for (uint32_t i = 0; i < s.sides; ++i) {
            const Vec2 corner = s.radius * onCircle(i, s.sides);
            bottom.emplace_back(corner, -0.5 * s.height);
            top.emplace_back(corner, 0.5 * s.height);
        }
        for (uint32_t i = 0; i < s.sides; ++i) {
            const uint32_t next = (i + 1) % s.sides;
            face({bottom[i], bottom[next], top[next], top[i]}, 0);
        }
        std::ranges::reverse(bottom);
        polygon(bottom, {0.0, 0.0, -1.0}, 0);
        polygon(top, {0.0, 0.0, 1.0}, 0);
    }

    void add(const Disc& s) {
        const Around around = fullCircle(chords(s.radius));
        cap(s.radius, 0.0, around, false);
        cap(s.radius, 0.0, around, true);
    }

    void add(const Ring& s) { add(HollowCylinder{s.innerRadius, s.outerRadius, 0.0}); }
    void add(const HollowCylinder& s) { add(RectangularTorus{s.innerRadius, s.outerRadius, s.height}); }

private:
    [[nodiscard]] uint32_t chords(double radius) const { return chordsOfCircle(radius, m_fineness); }
    /// Each of two curvatures takes half of the permitted distance.
    [[nodiscard]] uint32_t doublyCurved(double radius) const { return chordsOfCircle(radius, halved(m_fineness)); }
    [[nodiscard]] std::vector<Vec2> arc(const Vec2& from, const Vec2& to, double radius) const {
        return arcBetween(from, to, Angle::fromRadians(kTurn) / doublyCurved(radius));
    }
    [[nodiscard]] uint32_t size() const { return uint32_t(m_surface.positions.size()); }

    uint32_t vertex(const Vec3& position, const Vec3& normal) {
        m_surface.positions.emplace_back(m_transform * Vec4(position, 1.0));
        m_surface.normals.push_back(unit(m_normals * normal, Vec3(0.0, 0.0, 1.0)));
        return size() - 1;
    }

    void triangle(uint32_t a, uint32_t b, uint32_t c) {
        const std::vector<Vec3>& at = m_surface.positions;
        if (at[a] == at[b] || at[b] == at[c] || at[c] == at[a]) return;
        m_surface.triangles.insert(m_surface.triangles.end(), {a, m_mirrored ? c : b, m_mirrored ? b : c});
    }

    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    /// A convex planar polygon as a fan from one of its corners.
    void polygon(std::span<const Vec3> corners, const Vec3& normal, uint32_t from) {
        const uint32_t first = size(), count = uint32_t(corners.size());
        for (const Vec3& corner : corners) vertex(corner, normal);
        for (uint32_t i = 1; i + 1 < count; ++i)
            triangle(first + from % count, first + (from + i) % count, first + (from + i + 1) % count);
    }

    /// The same with the normal of its corners (Newell).
    void face(std::initializer_list<Vec3> corners, uint32_t from) {
        const std::span<const Vec3> points(corners.begin(), corners.size());
        Vec3 normal(0.0);
        for (size_t i = 1; i + 1 < points.size(); ++i) normal += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
        polygon(points, unit(normal, Vec3(0.0, 0.0, 1.0)), from);
    }

    void revolve(const Section& section, const Around& around) {
        const uint32_t first = size(), points = uint32_t(section.size()), places = uint32_t(around.directions.size());
        for (const Vec2& direction : around.directions)
            for (const SectionPoint& point : section)
                vertex({point.at.x * direction, point.at.y}, {point.normal.x * direction, point.normal.y});
        for (uint32_t place = 0; place + (around.whole ? 0 : 1) < places; ++place)
            for (uint32_t point = 0; point + 1 < points; ++point) {
                const uint32_t here = first + place * points + point, next = first + (place + 1) % places * points + point;
                quad(here, next, next + 1, here + 1);
            }
    }

    /// The flat ends of a solid of revolution by less than a turn; its section is convex.
    void ends(const Section& section, const Around& around) {
        if (around.whole) return;
        const Vec2 first = around.directions.front(), last = around.directions.back();
        std::vector<Vec3> corners;
        for (const SectionPoint& point : section) corners.emplace_back(point.at.x * first, point.at.y);
        polygon(corners, {first.y, -first.x, 0.0}, 0);
        corners.clear();
        for (const SectionPoint& point : section) corners.emplace_back(point.at.x * last, point.at.y);
        std::ranges::reverse(corners);
        polygon(corners, {-last.y, last.x, 0.0}, 0);
    }

    /// A disc that faces up or down. The fans of the two begin at neighbouring corners, so that a solid without a height has no
    /// edge of four triangles.
    void cap(double radius, double height, const Around& around, bool up) {
        std::vector<Vec3> corners;
        for (const Vec2& direction : around.directions) corners.emplace_back(radius * direction, height);
        if (!up) std::ranges::reverse(corners);
        polygon(corners, {0.0, 0.0, up ? 1.0 : -1.0}, 0);
    }

    void dish(const Section& section, double radius) {
        const Around around = fullCircle(doublyCurved(std::max(radius, section.back().at.y)));
        revolve(section, around);
        cap(radius, 0.0, around, false);
    }

    Surface& m_surface;
    Fineness m_fineness;
    Mat4 m_transform;
    Mat3 m_normals;
    bool m_mirrored;
};

}  // namespace

uint32_t chordsOfCircle(double radius, const Fineness& fineness) {
    if (fineness.segments > 0) return std::max(3U, fineness.segments);
    // The sagitta is radius (1 − cos(π/n)), which is less than radius (π/n)²/2. A square root is the same on every machine.
    const double wanted = kPi * std::sqrt(radius / (2.0 * fineness.chordError));
    return uint32_t(std::ceil(std::clamp(wanted, 8.0, 1024.0) / 4.0)) * 4;
}

void appendSurface(Surface& surface, const Primitive& primitive, const Fineness& fineness, const Mat4& transform) {
    assert(!whyImpossible(primitive) && (fineness.segments > 0 || fineness.chordError > 0.0));
    Tessellation tessellation(surface, fineness, transform);
    std::visit([&](const auto& solid) { tessellation.add(solid); }, primitive);
}

MeshPointer meshOf(const Surface& surface, std::string name) {
    Box3 box;
    for (const Vec3& position : surface.positions) box.add(position);
    TriangleMesh::Data data;
    data.name = std::move(name);
    if (!box.empty()) data.origin = box.centre();
    data.positions.reserve(surface.positions.size());
    for (const Vec3& position : surface.positions) data.positions.emplace_back(position - data.origin);
    data.normals.assign(surface.normals.begin(), surface.normals.end());
    data.indices = surface.triangles;
    return std::make_shared<const TriangleMesh>(std::move(data));
}

}  // namespace cullscope::primitive
