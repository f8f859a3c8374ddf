// S of contour bands as lines in the world (Han & Hong 2008, Figure 6).

#include "core/gpu/colour.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/verdict_palette.h"
#include "tests/support/hand_made_map.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::size_overlay_test {
namespace {

using namespace spherical;

const DrawStyle kLight{Vec3f(1.0f)};

/// A bumpy body with the bands that drawByS made of it, seen from a direction.
struct Banded {
    explicit Banded(const Vec3& axis) : scene(sceneOf({bumpyMesh(5, 20'000, 0.3)})) {
        map.maps = std::make_shared<SphericalMaps>(scene->meshes().front(), SphericalGrid(180, 90));
        map.decision.relation = SphereRelation::Within;
        map.decision.eye = 4.0 * map.maps.sphere().radius * axis;
        ContourBands bands = makeBands(map.decision.eye, 5.0 * kDegree, 36);
        map.decision.drawn = drawnByS(BandCells(*map.maps), bands, Cut::ForGood);
        map.decision.bands = bands;
    }

    [[nodiscard]] std::vector<OverlayLines> overlay(const View& viewing) const {
        return sizeOverlay({*scene, viewing, kLight, verdictPalette(kLight.background), contrastTo(kLight.background)}, {map});
    }

    ScenePointer scene;
    MapSnapshot map;
};

View viewFrom(const Vec3& eye) {
    return {Camera{eye, Vec3(0.0), {0.1, 0.2, 0.9}, Angle::fromDegrees(45), 0.05, 100.0}, {640, 480}};
}

TEST(SizePlaces, beginAtTheFootOfTheSurfaceAndAreAsLongAsS) {
    Random random(11);
    size_t checked = 0;
    for (int i = 0; i < 6; ++i) {
        const Vec3 axis = random.direction();
        const Banded seen(axis);
        const ContourBands& bands = *seen.map.decision.bands;
        for (uint32_t sector = 0; sector < bands.sectors; ++sector)
            for (const SizePlace& place : sizePlaces(seen.map, sector)) {
                SCOPED_TRACE(testing::Message() << "axis " << i << ", sector " << sector << ", band " << place.band);
                const BandSector& entry = bands.at(place.band, sector);
                EXPECT_NEAR(place.size, entry.size, 1e-9);
                EXPECT_NEAR(glm::length(place.surface - place.foot), place.size, 1e-9);
                EXPECT_NEAR(glm::dot(place.surface - place.foot, axis), 0.0, 1e-9) << "perpendicular to the axis";
                EXPECT_NEAR(glm::length(place.foot - glm::dot(place.foot, axis) * axis), 0.0, 1e-9) << "on the axis";
                EXPECT_EQ(place.drawn, entry.drawn || entry.within);
                // The surface is there: the cell's farthest centroid has that distance.
                const uint32_t cell = seen.map.maps->grid().number(seen.map.maps->grid().cellOf(place.surface));
                ASSERT_FALSE(seen.map.maps->centroids(cell).empty());
                EXPECT_NEAR(seen.map.maps->centroidRadius(seen.map.maps->centroids(cell).back()), glm::length(place.surface),
                            1e-6);
                ++checked;
            }
    }
    EXPECT_GT(checked, 2000u);
}

TEST(SizeOverlay, showsOneSectorInAColourOfItsOwnDashedWhereHidden) {
    const Banded seen({0.0, 1.0, 0.0});
    const View viewing = viewFrom({6.0, 0.5, 1.0});
    const std::vector<OverlayLines> overlays = seen.overlay(viewing);
    const OverlayContext context{*seen.scene, viewing, kLight, verdictPalette(kLight.background), contrastTo(kLight.background)};
    const std::vector<SizePlace> places = sizePlaces(seen.map, shownSector(context, seen.map));
    const Vec3f green = sizeColour(kLight.background);
    for (const PaletteEntry& entry : context.palette) EXPECT_GT(glm::distance(entry.colour, green), 0.2f);
    // The sizes are the only wide lines in that colour that begin on the axis or lie between it and the surface.
    const auto sizes = std::ranges::find_if(overlays, [&](const OverlayLines& overlay) {
        return overlay.cased && overlay.style.width == 2.0f && !overlay.lines.empty() && overlay.lines.front().colour == green;
    });
    ASSERT_NE(sizes, overlays.end());
    const size_t drawn = size_t(std::ranges::count_if(places, &SizePlace::drawn)), hidden = places.size() - drawn;
    ASSERT_GT(drawn, 10u);
    ASSERT_GT(hidden, 3u);
    size_t whole = 0, dashes = 0;
    const Vec3 centre = seen.map.maps.sphere().centre;
    for (const LineSegment& line : sizes->lines) {
        const bool complete = std::ranges::any_of(places, [&](const SizePlace& place) {
            return glm::distance(line.from, centre + place.foot) < 1e-9 && glm::distance(line.to, centre + place.surface) < 1e-9;
        });
        (complete ? whole : dashes) += 1;
    }
    EXPECT_EQ(whole, drawn);
    EXPECT_GE(dashes, hidden);
}

TEST(SizeOverlay, slopesAreHeightsOfTheSightLine) {
    Banded seen({0.0, 1.0, 0.0});
    seen.map.decision.bands->slopes = true;
    for (BandSector& entry : seen.map.decision.bands->table) entry.size = 0.1;
    const std::vector<OverlayLines> overlays = seen.overlay(viewFrom({6.0, 0.5, 1.0}));
    const double eye = glm::length(seen.map.decision.eye);
    size_t heights = 0;
    const Vec3 centre = seen.map.maps.sphere().centre;
    for (const OverlayLines& overlay : overlays)
        if (overlay.style.width == 2.0f && overlay.cased)
            for (const LineSegment& line : overlay.lines) {
                const double along = (line.from - centre).y;
                if (glm::length(Vec2((line.from - centre).x, (line.from - centre).z)) > 1e-9) continue;
                const double height = glm::length(line.to - line.from);
                if (std::abs(height - 0.1 * (eye - along)) < 1e-9) ++heights;
            }
    EXPECT_GT(heights, 10u);
}

TEST(SizeOverlay, smallObjectsHaveNone) {
    const Banded seen({0.0, 1.0, 0.0});
    for (const OverlayLines& overlay : seen.overlay(viewFrom({300.0, 5.0, 10.0}))) EXPECT_TRUE(overlay.lines.empty());
}

}  // namespace
}  // namespace cullscope::test::size_overlay_test
