// Contour bands on bounding spheres.

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
constexpr float kMarkWidth = 2.0f;
constexpr double kMarkRadius = 5.0;

constexpr double kLeastGap = 4.0;      ///< pixels between neighbouring circles, at their largest distance
constexpr double kLeastRadius = 40.0;  ///< pixels; a smaller sphere shows no axis

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
    }

    [[nodiscard]] std::vector<OverlayLines> overlays() && {
        return {{std::move(m_contours), {kContourWidth, true}},
                {std::move(m_equators), {kEquatorWidth, true}},
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
        addMark(m_marks, m_context, start, kMarkRadius, MarkShape::Dot, m_context.contrast);
        addMark(m_marks, m_context, end, kMarkRadius, MarkShape::Ring, m_context.contrast);
    }

    const OverlayContext& m_context;
    std::vector<LineSegment> m_contours, m_equators, m_axes, m_marks;
};

}  // namespace

std::vector<OverlayLines> bandOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps) {
    BandLines lines(context);
    for (const MapSnapshot& map : maps)
        if (map.decision.bands) lines.add(map);
    return std::move(lines).overlays();
}

}  // namespace cullscope::spherical
