// Contour bands on bounding spheres, and the sizes S by which they were tested.

#include <numbers>

#include "core/geometry/angle.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::spherical {
namespace {

// Widths and radii in units.
constexpr float kContourWidth = 1.0f;
constexpr float kEquatorWidth = 2.5f;
constexpr float kAxisWidth = 1.5f;
constexpr float kSizeWidth = 1.0f;  // narrow, because many lie close together and would hide the model
constexpr float kMarkWidth = 2.0f;
constexpr double kMarkRadius = 5.0;

constexpr double kLeastGap = 4.0;      ///< pixels between neighbouring circles, at their largest distance
constexpr double kLeastRadius = 40.0;  ///< pixels; a smaller sphere shows no axis and no sizes

class BandLines {
public:
    explicit BandLines(const OverlayContext& context) : m_context(context) {}

    void add(const MapSnapshot& map) {
        const Object object{map, *map.decision.bands, MapPlace(m_context.scene, map), map.maps.sphere().radius,
                            pixelsOf(m_context.viewing, MapPlace(m_context.scene, map).world(Vec3(0.0)),
                                     m_context.scene.instanceSphere(map.decision.instance).radius)};
        const ContourBands& bands = object.bands;
        const uint32_t step =
            uint32_t(std::max(1.0, std::ceil(kLeastGap * m_context.style.unit / (object.pixels * bands.width))));
        for (uint32_t band = 1; band < bands.bands; ++band)
            if (band % step == 0 && std::abs(band * bands.width - kRightAngle) > 1e-9) addContour(object, band);
        addCircle(object, kRightAngle);
        if (object.pixels < kLeastRadius * m_context.style.unit) return;
        addAxis(object);
        addSizes(object, step);
    }

    [[nodiscard]] std::vector<OverlayLines> overlays() && {
        return {{std::move(m_contours), {kContourWidth, true}},
                {std::move(m_equators), {kEquatorWidth, true}},
                {std::move(m_sizes), {kSizeWidth, false}},
                {std::move(m_axes), {kAxisWidth, false}, true},
                {std::move(m_marks), {kMarkWidth, false}, true}};
    }

private:
    struct Object {
        const MapSnapshot& map;
        const ContourBands& bands;
        MapPlace place;
        double radius = 0.0;  ///< of the bounding sphere, mesh units
        double pixels = 0.0;  ///< the same in the picture

        [[nodiscard]] Vec3 onSphere(double alpha, double beta) const {
            return place.world(radius * bands.direction(alpha, beta));
        }
    };

    [[nodiscard]] const Vec3f& colourOf(const BandSector& sector) const {
        return m_context.palette[size_t(sector.drawn || sector.within ? TriangleState::Visible : TriangleState::Hidden)].colour;
    }

    /// The circle where a band begins, sector by sector.
    void addContour(const Object& object, uint32_t band) {
        const uint32_t sectors = object.bands.sectors;
        const uint32_t pieces = (uint32_t(piecesOfCircle(object.pixels)) + sectors - 1) / sectors;
        const double alpha = band * object.bands.width, turn = 2.0 * std::numbers::pi / (double(sectors) * pieces);
        for (uint32_t i = 0; i < sectors * pieces; ++i)
            m_contours.push_back({object.onSphere(alpha, i * turn), object.onSphere(alpha, (i + 1) * turn),
                                  colourOf(object.bands.at(band, i / pieces))});
    }

    void addCircle(const Object& object, double alpha) {
        const int pieces = piecesOfCircle(object.pixels);
        const double turn = 2.0 * std::numbers::pi / pieces;
        for (int i = 0; i < pieces; ++i)
            m_equators.push_back({object.onSphere(alpha, i * turn), object.onSphere(alpha, (i + 1) * turn), m_context.contrast});
    }

    void addAxis(const Object& object) {
        const Vec3 start = object.onSphere(0.0, 0.0), end = object.onSphere(std::numbers::pi, 0.0);
        m_axes.push_back({start, end, m_context.contrast});
        addMark(m_marks, m_context, start, kMarkRadius, MarkShape::Ring, m_context.contrast);
        addMark(m_marks, m_context, end, kMarkRadius, MarkShape::Dot, m_context.contrast);
    }

    /// The distance from the axis to which a band's size extends, at a position along the axis.
    [[nodiscard]] static double reach(const Object& object, const BandSector& sector, double along) {
        if (!object.bands.slopes) return sector.size;
        // The sight line with that slope: it leaves the axis at the eye.
        return sector.size * std::max(glm::length(object.map.decision.eye) - along, 0.0);
    }

    /// The two sectors in which the profile is best visible: on either side of the axis in the picture.
    [[nodiscard]] std::array<uint32_t, 2> sectorsAside(const Object& object) const {
        const Frustum& frustum = m_context.viewing.frustum();
        const Mat3 world(m_context.scene.instances()[object.map.decision.instance].worldFromMesh);
        const Vec3 axis = glm::normalize(world * object.bands.axis);
        Vec3 aside = glm::cross(axis, object.place.world(Vec3(0.0)) - m_context.viewing.eye());
        // Viewed along the axis, all sides are equally good.
        if (!(glm::length(aside) > 0.1 * object.radius)) aside = frustum.right - glm::dot(frustum.right, axis) * axis;
        const double beta = object.bands.anglesOf(glm::inverse(world) * aside).y;
        return {object.bands.sectorOf(beta), object.bands.sectorOf(std::fmod(beta + std::numbers::pi, 2.0 * std::numbers::pi))};
    }

    void addSizes(const Object& object, uint32_t step) {
        const ContourBands& bands = object.bands;
        const std::array<uint32_t, 2> sectors = sectorsAside(object);
        for (uint32_t band = 0; band < bands.bands; band += step)
            for (const uint32_t sector : sectors) {
                const double along = object.radius * std::cos(std::min((band + 0.5) * bands.width, std::numbers::pi));
                const double size = reach(object, bands.at(band, sector), along);
                // A band without triangles has no size or an infinite one.
                if (!(size > 0.0) || size > 2.0 * object.radius) continue;
                const Vec3 outward = bands.direction(kRightAngle, (sector + 0.5) * 2.0 * std::numbers::pi / bands.sectors);
                m_sizes.push_back({object.place.world(along * bands.axis),
                                   object.place.world(along * bands.axis + size * outward), colourOf(bands.at(band, sector))});
            }
    }

    const OverlayContext& m_context;
    std::vector<LineSegment> m_contours, m_equators, m_axes, m_sizes, m_marks;
};

}  // namespace

std::vector<OverlayLines> bandOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps) {
    BandLines lines(context);
    for (const MapSnapshot& map : maps)
        if (map.decision.bands) lines.add(map);
    return std::move(lines).overlays();
}

}  // namespace cullscope::spherical
