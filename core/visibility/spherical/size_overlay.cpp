// The sizes S of contour bands, by which they were tested.

#include <array>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/gpu/colour.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::spherical {
namespace {

// Widths and lengths in units.
constexpr float kSizeWidth = 2.0f;
constexpr float kSectorWidth = 1.0f;
constexpr float kLevelWidth = 1.0f;
constexpr float kAxisWidth = 1.5f;
constexpr double kMarkRadius = 5.0;
constexpr float kLetterWidth = 2.5f;
constexpr double kLetterHeight = 18.0;
constexpr double kLetterAway = 16.0;  ///< from the end of the labelled S to the letter's middle
constexpr double kDash = 5.0;
constexpr double kLeastRadius = 40.0;  ///< pixels; a smaller sphere shows no sizes
constexpr double kLeastBand = 12.0;    ///< on the sphere; edges of narrower bands are drawn on the sphere alone
constexpr float kPale = 0.65f;         ///< the background's share in the colour of bands' edges

constexpr uint32_t kOnDark = 0x46DC8C, kOnLight = 0x0A7A3C;

/// The letter S as a line, in a square from −1 to 1.
constexpr std::array<std::array<double, 2>, 15> kLetter{{{0.58, 0.68},
                                                         {0.38, 0.9},
                                                         {0.0, 1.0},
                                                         {-0.38, 0.9},
                                                         {-0.58, 0.62},
                                                         {-0.52, 0.32},
                                                         {-0.25, 0.12},
                                                         {0.0, 0.0},
                                                         {0.25, -0.12},
                                                         {0.52, -0.32},
                                                         {0.58, -0.62},
                                                         {0.38, -0.9},
                                                         {0.0, -1.0},
                                                         {-0.38, -0.9},
                                                         {-0.58, -0.68}}};

class SizeLines {
public:
    SizeLines(const OverlayContext& context, const std::optional<uint32_t>& sector)
        : m_context(context), m_colour(sizeColour(context.style.background)), m_sector(sector) {}

    void add(const MapSnapshot& map) {
        const MapPlace place(m_context.scene, map);
        const double radius = map.maps.sphere().radius;
        const double pixels =
            pixelsOf(m_context.viewing, place.world(Vec3(0.0)), m_context.scene.instanceSphere(map.decision.instance).radius);
        if (pixels < kLeastRadius * m_context.style.unit) return;
        const uint32_t sector = m_sector.value_or(shownSector(m_context, map));
        addSector(map, place, sector, radius, piecesOfCircle(pixels));
        addBandEdges(map, place, sector, radius, pixels);
        const Vec3 axis = radius * map.decision.bands->axis;
        m_axes.push_back({place.world(axis), place.world(-axis), m_context.contrast});
        addMark(m_marks, m_context, place.world(axis), kMarkRadius, MarkShape::Dot, m_context.contrast);
        addMark(m_marks, m_context, place.world(-axis), kMarkRadius, MarkShape::Ring, m_context.contrast);
        const std::vector<SizePlace> sizes = map.decision.bands->slopes ? heightsOf(map, sector) : sizePlaces(map, sector);
        for (const SizePlace& size : sizes) addSize(place.world(size.foot), place.world(size.surface), size);
        const auto largest =
            std::ranges::max_element(sizes, {}, [](const SizePlace& size) { return size.larger ? 0.0 : size.size; });
        if (largest == sizes.end()) return;
        if (!map.decision.bands->slopes) addLetter(place.world(largest->foot), place.world(largest->surface));
        // The level that hides: on from the largest S, as far as the sphere reaches. By S all within 90° is drawn.
        const Vec3& axisToEye = map.decision.bands->axis;
        const double from = glm::dot(largest->surface, axisToEye);
        const double along = map.decision.bands->slopes ? from : std::min(from, 0.0);
        const Vec3 top = largest->surface - largest->foot + along * axisToEye;
        if (std::ranges::any_of(sizes, [](const SizePlace& size) { return !size.drawn; }))
            addDashes(m_levels, place.world(top), place.world(top - (along + radius) * axisToEye), m_colour);
    }

    [[nodiscard]] std::vector<OverlayLines> overlays() && {
        return {{std::move(m_sectors), {kSectorWidth, true}},    {std::move(m_axes), {kAxisWidth, false}, true},
                {std::move(m_marks), {kSizeWidth, false}, true}, {std::move(m_levels), {kLevelWidth, false}},
                {std::move(m_sizes), {kSizeWidth, false}, true}, {std::move(m_letters), {kLetterWidth, false}, true}};
    }

private:
    /// The meridians on either side of the sector, on the sphere.
    void addSector(const MapSnapshot& map, const MapPlace& place, uint32_t sector, double radius, int pieces) {
        const ContourBands& bands = *map.decision.bands;
        for (const uint32_t side : {sector, sector + 1}) {
            const double beta = side * kTurn / bands.sectors;
            const auto at = [&](int i) { return place.world(radius * bands.direction(std::numbers::pi * i / pieces, beta)); };
            for (int i = 0; i < pieces; ++i) m_sectors.push_back({at(i), at(i + 1), m_colour});
        }
    }

    /// The edges of bands: on the sphere across the sector, and where they are wide enough from the centre to the sphere.
    void addBandEdges(const MapSnapshot& map, const MapPlace& place, uint32_t sector, double radius, double pixels) {
        constexpr int kPieces = 4;
        const ContourBands& bands = *map.decision.bands;
        const Vec3f pale = glm::mix(m_colour, m_context.style.background, kPale);
        const double step = kTurn / bands.sectors;
        for (uint32_t band = 1; band < bands.bands; ++band) {
            const auto at = [&](double share) {
                return place.world(radius * bands.direction(band * bands.width, (sector + share) * step));
            };
            for (int i = 0; i < kPieces; ++i)
                m_sectors.push_back({at(double(i) / kPieces), at(double(i + 1) / kPieces), m_colour});
            if (bands.width * pixels >= kLeastBand * m_context.style.unit)
                m_sectors.push_back({place.world(Vec3(0.0)), at(0.5), pale});
        }
    }

    /// Of slopes: the distance of the sight line with that slope from the axis, where the band lies.
    [[nodiscard]] static std::vector<SizePlace> heightsOf(const MapSnapshot& map, uint32_t sector) {
        const ContourBands& bands = *map.decision.bands;
        const double radius = map.maps.sphere().radius;
        const Vec3 outward = bands.direction(kRightAngle, (sector + 0.5) * kTurn / bands.sectors);
        std::vector<SizePlace> sizes;
        for (uint32_t band = 0; band < bands.bands; ++band) {
            const BandSector& entry = bands.at(band, sector);
            const double along = radius * std::cos(std::min((band + 0.5) * bands.width, std::numbers::pi));
            // The line leaves the axis at the eye. A band without triangles has an infinite slope.
            const double height = entry.size * std::max(glm::length(map.decision.eye) - along, 0.0);
            if (height > 0.0 && height <= 2.0 * radius)
                sizes.push_back({band, height, along * bands.axis, along * bands.axis + height * outward, entry.drawn});
        }
        return sizes;
    }

    void addSize(const Vec3& foot, const Vec3& surface, const SizePlace& size) {
        if (size.drawn)
            m_sizes.push_back({foot, surface, m_colour});
        else
            addDashes(m_sizes, foot, surface,
                      size.larger ? m_context.palette[size_t(TriangleState::WronglyCulled)].colour : m_colour);
    }

    void addDashes(std::vector<LineSegment>& lines, const Vec3& from, const Vec3& to, const Vec3f& colour) const {
        const double pixels = pixelsOf(m_context.viewing, from, glm::length(to - from));
        const int dashes = int(pixels / (2.0 * kDash * m_context.style.unit)) + 1;
        for (int dash = 0; dash < dashes; ++dash)
            lines.push_back({glm::mix(from, to, double(dash) / dashes), glm::mix(from, to, (dash + 0.5) / dashes), colour});
    }

    void addLetter(const Vec3& foot, const Vec3& surface) {
        const Frustum& frustum = m_context.viewing.frustum();
        const double distance = glm::dot(surface - m_context.viewing.eye(), frustum.forward);
        if (!(distance > 0.0) || foot == surface) return;
        const double unit = m_context.style.unit * 2.0 * frustum.halfHeightAt(distance) / m_context.viewing.viewport().height;
        const Vec3 outward = surface - foot;
        Vec2 aside(glm::dot(outward, frustum.right), glm::dot(outward, frustum.up));
        aside = glm::length(aside) > 0.0 ? glm::normalize(aside) : Vec2(0.0, 1.0);
        const auto at = [&](size_t i) {
            const Vec2 point = kLetterAway * aside + 0.5 * kLetterHeight * Vec2(kLetter[i][0], kLetter[i][1]);
            return surface + unit * (point.x * frustum.right + point.y * frustum.up);
        };
        for (size_t i = 1; i < kLetter.size(); ++i) m_letters.push_back({at(i - 1), at(i), m_colour});
    }

    const OverlayContext& m_context;
    Vec3f m_colour;
    std::optional<uint32_t> m_sector;
    std::vector<LineSegment> m_sectors, m_axes, m_marks, m_levels, m_sizes, m_letters;
};

}  // namespace

Vec3f sizeColour(const Vec3f& background) { return colourFromHexadecimal(isLight(background) ? kOnLight : kOnDark); }

std::vector<SizePlace> sizePlaces(const MapSnapshot& map, uint32_t sector) {
    const ContourBands& bands = *map.decision.bands;
    const SphericalGrid& grid = map.maps->grid();
    const CellDirections directions(grid);
    std::vector<SizePlace> largest(bands.bands);
    for (uint32_t number = 0; number < grid.cellCount(); ++number) {
        const std::span<const uint32_t> owned = map.maps->centroids(number);
        if (owned.empty()) continue;
        const Vec3 middle = directions.middle(grid.cell(number));
        const uint32_t entry = sectorOfCell(bands, middle);
        if (entry % bands.sectors != sector) continue;
        const double farthest = map.maps->centroidRadius(owned.back()), along = glm::dot(middle, bands.axis);
        const double size = farthest * std::sqrt(std::max(1.0 - along * along, 0.0));
        SizePlace& place = largest[entry / bands.sectors];
        if (size > place.size) place = {entry / bands.sectors, size, farthest * along * bands.axis, farthest * middle};
    }
    std::erase_if(largest, [](const SizePlace& place) { return place.size <= 0.0; });
    for (SizePlace& place : largest) {
        const BandSector& entry = bands.at(place.band, sector);
        place.drawn = entry.drawn || entry.within;
        place.larger = !place.drawn && entry.size > entry.horizon;
    }
    return largest;
}

uint32_t shownSector(const OverlayContext& context, const MapSnapshot& map) {
    const ContourBands& bands = *map.decision.bands;
    const Frustum& frustum = context.viewing.frustum();
    const Mat3 world = MapPlace(context.scene, map).linear();
    const Vec3 axis = glm::normalize(world * bands.axis);
    Vec3 aside = glm::cross(axis, MapPlace(context.scene, map).world(Vec3(0.0)) - context.viewing.eye());
    // Viewed along the axis, all sides are equally good.
    if (!(glm::length(aside) > 0.1 * map.maps.sphere().radius)) aside = frustum.right - glm::dot(frustum.right, axis) * axis;
    const double beta = bands.anglesOf(glm::inverse(world) * aside).y;
    // Of the two sides that are seen in full, the one on which the object extends farther.
    const std::array sectors{bands.sectorOf(beta), bands.sectorOf(std::fmod(beta + std::numbers::pi, kTurn))};
    const auto extent = [&](uint32_t sector) {
        double most = 0.0;
        for (uint32_t band = 0; band < bands.bands; ++band) most = std::max(most, bands.at(band, sector).size);
        return most;
    };
    return extent(sectors[0]) >= extent(sectors[1]) ? sectors[0] : sectors[1];
}

std::vector<OverlayLines> sizeOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps,
                                      const std::optional<uint32_t>& sector) {
    SizeLines lines(context, sector);
    for (const MapSnapshot& map : maps)
        if (map.decision.bands) lines.add(map);
    return std::move(lines).overlays();
}

}  // namespace cullscope::spherical
