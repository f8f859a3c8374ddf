// The figures of Han & Hong 2008 as pages with their data.
#include "core/experiments/han_hong_figures.h"

#include <gmock/gmock.h>

#include "core/experiments/han_hong_band_lines.h"
#include "core/experiments/han_hong_figure_data.h"
#include "core/experiments/han_hong_figure_lines.h"
#include "core/gpu/gpu_frame.h"
#include "core/image/drawing_svg.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/map_details.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"
#include "core/visibility/verdict_palette.h"
#include "tests/support/gl_environment.h"
#include "tests/support/refusal.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::han_hong_figures_test {
namespace {

using testing::Contains;

ScenePointer body() { return sceneOf({bumpyMesh(4, 20'000, 0.2)}); }

han_hong::Figure made(int number, const ScenePointer& scene, const std::function<void(han_hong::FigureRequest&)>& change = {}) {
    GlEnvironment::renderer();
    han_hong::FigureRequest request;
    request.number = number;
    request.scene = scene;
    request.strategy = strategyFromText("spherical");
    request.width = 600.0;
    request.scale = 1.0;
    if (change) change(request);
    PageLook look;
    look.style = svgStyle();
    return han_hong::figure(request, look);
}

std::vector<std::string> wordsOf(const Page& page) {
    std::vector<std::string> words;
    for (const auto& item : page.drawing.items)
        if (const auto* text = std::get_if<DrawnText>(&item)) words.push_back(text->words);
    return words;
}

View wholeViewOf(const Scene& scene) { return {overviewCamera(scene, 4.0 / 3.0), {640, 480}}; }

/// What the strategy of a figure finds with all of the scene in view.
StructureSnapshot bandsOf(const ScenePointer& scene, int number) {
    StructureStore structures;
    const StrategyRequest request = strategyFromText(han_hong::figureStrategy(number));
    const BuiltStrategyPointer strategy = buildStrategy(request.id, request.parameters, scene, structures);
    GpuFrame frame(GlEnvironment::renderer(), SceneBuffers(scene, Upload::Vbo), wholeViewOf(*scene), true);
    strategy->draw(frame, *strategy->begin());
    return strategy->snapshot(frame.take());
}

size_t rowsOf(const ResultTable& table, const std::string& kind) {
    size_t count = 0;
    for (size_t row = 0; row < table.rows.size(); ++row) count += table.value(row, "kind") == CellValue(kind) ? 1 : 0;
    return count;
}

TEST(HanHongFigures, fiveToEightShowTheSameBands) {
    for (const int number : {6, 7, 8}) EXPECT_EQ(han_hong::figureStrategy(number), han_hong::figureStrategy(5)) << number;
    EXPECT_NE(han_hong::figureStrategy(5), han_hong::figureStrategy(4));
    // Where nothing is asked for, as in a report: there the command below a figure draws the same.
    for (int number = 1; number <= han_hong::kFigures; ++number) {
        const han_hong::FigureRequest request = han_hong::figureRequest(number, nullptr);
        const StrategyRequest strategy = strategyFromText(han_hong::figureStrategy(number));
        EXPECT_EQ(request.number, number);
        EXPECT_EQ(request.strategy.id, strategy.id);
        EXPECT_EQ(request.strategy.parameters, strategy.parameters) << number;
    }
}

TEST(HanHongFigures, eachHasATitleAndStaysOnItsPage) {
    const ScenePointer scene = body();
    for (int number = 1; number <= han_hong::kFigures; ++number) {
        SCOPED_TRACE(number);
        const han_hong::Figure figure = made(number, scene);
        EXPECT_EQ(figure.page.width, 600.0);
        EXPECT_GT(figure.page.height, 200.0);
        EXPECT_THAT(wordsOf(figure.page).front(), testing::StartsWith("Figure " + std::to_string(number)));
        EXPECT_EQ(figure.page.pictures.empty(), number == 1);
        for (const PagePicture& picture : figure.page.pictures) {
            EXPECT_LE(picture.corner.x + picture.size.width, figure.page.width);
            EXPECT_LE(picture.corner.y + picture.size.height, figure.page.height);
            const Viewport pixels = figure.page.pixelsOf(picture.size);
            EXPECT_EQ(picture.rgba.size(), size_t(pixels.width) * size_t(pixels.height) * 4);
        }
    }
    EXPECT_THAT(refusalOf([&] { (void)made(9, scene); }, ErrorKind::Usage), testing::HasSubstr("There is no Figure 9"));
}

TEST(HanHongFigures, sharperOnesHaveTheSameWordsAtTheSamePlaces) {
    const ScenePointer scene = body();
    for (int number = 1; number <= han_hong::kFigures; ++number) {
        SCOPED_TRACE(number);
        const auto ofScale = [&](double scale) {
            return made(number, scene, [&](han_hong::FigureRequest& request) { request.scale = scale; }).page;
        };
        const Page coarse = ofScale(0.5), sharp = ofScale(1.5);
        EXPECT_EQ(coarse.height, sharp.height);
        std::vector<const DrawnText*> texts[2];
        for (const Page* page : {&coarse, &sharp})
            for (const auto& item : page->drawing.items)
                if (const auto* text = std::get_if<DrawnText>(&item)) texts[page == &sharp].push_back(text);
        ASSERT_EQ(texts[0].size(), texts[1].size());
        for (size_t i = 0; i < texts[0].size(); ++i) {
            // Which pixels show a loss depends on how many there are.
            if (!texts[0][i]->words.starts_with("visible, but hidden by S")) EXPECT_EQ(texts[0][i]->words, texts[1][i]->words);
            EXPECT_NEAR(texts[0][i]->at.x, texts[1][i]->at.x, 3.0) << texts[0][i]->words;
            EXPECT_NEAR(texts[0][i]->at.y, texts[1][i]->at.y, 3.0) << texts[0][i]->words;
        }
    }
}

TEST(HanHongFigures, fourHasTicksAxesLegendAndTheCaseOfEachMap) {
    const han_hong::Figure figure = made(4, body());
    const std::vector<std::string> words = wordsOf(figure.page);
    EXPECT_EQ(figure.page.pictures.size(), 3u);
    for (const char* wanted : {"0°", "180°", "360°", "θ", "φ", "visible region", "box of the region", "corner: hit"})
        EXPECT_EQ(std::ranges::count(words, wanted), wanted == std::string("0°") || wanted == std::string("180°") ? 6 : 3)
            << wanted;
    for (const char* number : {"Case 1", "Case 2", "Case 3"}) EXPECT_THAT(words, Contains(testing::StartsWith(number)));
    // Of all three: four rays, their boxes (two where the seam splits the region), and outlines.
    EXPECT_EQ(rowsOf(figure.data, "ray"), 12u);
    EXPECT_EQ(rowsOf(figure.data, "box"), 4u);
    EXPECT_GE(rowsOf(figure.data, "outline"), 12u);
    EXPECT_EQ(rowsOf(figure.data, "band"), 0u);
    const han_hong::Figure one = made(4, body(), [](han_hong::FigureRequest& request) { request.onlyCase = 3; });
    EXPECT_EQ(one.page.pictures.size(), 1u);
    EXPECT_EQ(rowsOf(one.data, "box"), 2u);
}

TEST(HanHongFigures, dataOfBandsAreTheStrategysS) {
    const ScenePointer scene = body();
    const han_hong::Figure figure = made(6, scene);
    const ResultTable& data = figure.data;
    ASSERT_GT(rowsOf(data, "band"), 500u);
    std::map<double, double> largest;
    for (size_t row = 0; row < data.rows.size(); ++row) {
        const auto number = [&](const char* key) { return *numberOf(data.value(row, key)); };
        SCOPED_TRACE(row);
        // S² + foot² = R², and the largest S before it is that of the rows before in the same sector.
        EXPECT_NEAR(std::hypot(number("s"), number("foot")), number("r"), 1e-9);
        if (!largest.contains(number("sector"))) largest[number("sector")] = 0.0;
        EXPECT_NEAR(number("largest_before"), largest[number("sector")], 1e-9);
        largest[number("sector")] = std::max(largest[number("sector")], number("s"));
        if (number("alpha_to") <= 90.0) EXPECT_EQ(data.value(row, "state"), CellValue(std::string("drawn")));
    }
}

TEST(HanHongFigures, flowChartIsLitAtTheStep) {
    const ScenePointer scene = body();
    const han_hong::Figure first = made(1, scene, [](han_hong::FigureRequest& request) { request.step = 1; });
    const han_hong::Figure last = made(1, scene);
    EXPECT_NE(pageSvg(first.page), pageSvg(last.page));
    const auto beyond = [&] { (void)made(1, scene, [](han_hong::FigureRequest& request) { request.step = 1'000'000; }); };
    EXPECT_THAT(refusalOf(beyond, ErrorKind::Usage), testing::HasSubstr("--step 1000000"));
}

TEST(HanHongFigures, sevenHasOneLegendForObjectAndMap) {
    const han_hong::Figure figure = made(7, body());
    const std::vector<std::string> words = wordsOf(figure.page);
    for (const char* wanted : {"drawn and visible", "drawn in vain", "hidden"})
        EXPECT_EQ(std::ranges::count(words, wanted), 1) << wanted << ": in the map, too, and once on the page";
}

TEST(HanHongFigures, sevenTellsBandsApartByLightnessWithoutLinesAcrossTheObject) {
    const StructureSnapshot snapshot = bandsOf(body(), 7);
    const spherical::ContourBands& bands = *spherical::mapsOf(snapshot).front().decision.bands;
    for (uint32_t band = 0; band < bands.bands; ++band)
        for (const double share : {0.01, 0.5, 0.99})
            for (const double beta : {0.3, 4.0}) {
                const double light = han_hong::lightnessOfBand(bands, 7.0 * bands.direction((band + share) * bands.width, beta));
                EXPECT_EQ(light == 1.0, band % 2 == 0) << band << ", " << share;
                EXPECT_GT(light, 0.5);
            }
    // Lines over a picture have a casing of the background's white, and are black.
    const han_hong::Figure figure = made(7, body());
    const PagePicture& picture = figure.page.pictures.front();
    size_t dark = 0, covered = 0;
    for (size_t i = 0; i < picture.rgba.size(); i += 4) {
        const int most = std::max({picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
        dark += most < 30 ? 1 : 0;
        covered += most < 250 ? 1 : 0;
    }
    EXPECT_GT(covered, 10'000u);
    EXPECT_EQ(dark, 0u);
}

TEST(HanHongFigures, sixShowsTheSectorWithTheFewestBandsCutForGood) {
    const StructureSnapshot snapshot = bandsOf(body(), 6);
    const spherical::MapSnapshot& map = spherical::mapsOf(snapshot).front();
    const spherical::ContourBands& bands = *map.decision.bands;
    // In the sector of Figure 6 no hidden band has an S larger than those before it, where there is such a sector.
    const uint32_t sector = han_hong::tellingSector(bands, Vec3(0, 0, 1));
    const auto larger = [&](uint32_t which) {
        return std::ranges::count_if(spherical::sizePlaces(map, which), &spherical::SizePlace::larger);
    };
    for (uint32_t other = 0; other < bands.sectors; ++other) EXPECT_LE(larger(sector), larger(other)) << other;
}

TEST(HanHongFigures, flowChartWithoutAStepHasNoStepInHand) {
    const std::vector<std::string> words =
        wordsOf(made(1, body(), [](han_hong::FigureRequest& request) { request.width = 1000.0; }).page);
    EXPECT_THAT(words, Contains(testing::StartsWith("Case 2")));
    for (const char* wanted : {"Once for each mesh", "For each object, in every frame", "the way of the view in this figure"})
        EXPECT_THAT(words, Contains(wanted));
    EXPECT_THAT(words, testing::Not(Contains(testing::StartsWith("the step in hand"))));
}

TEST(HanHongFigures, twoHasAxesAndOnePointInBothPictures) {
    const std::vector<std::string> words = wordsOf(made(2, body()).page);
    for (const char* wanted : {"O", "R", "P", "x, φ = 0°", "y, φ = 90°", "z, θ = 0°"}) EXPECT_THAT(words, Contains(wanted));
    EXPECT_THAT(words, Contains(testing::StartsWith("P: R = ")));
}

TEST(HanHongFigures, dataOfTwoAreThePointAndTheCellsOfTheMap) {
    const ScenePointer scene = body();
    const ResultTable data = made(2, scene).data;
    EXPECT_EQ(rowsOf(data, "point"), 1u);
    // A map has no more cells than the mesh has triangles.
    const auto rows = uint32_t(std::lround(180.0 / std::get<double>(data.value(1, "theta_to"))));
    const SphericalMaps maps(scene->meshes().front(), SphericalGrid(2 * rows, rows));
    uint64_t entries = 0;
    for (size_t row = 0; row < data.rows.size(); ++row) {
        if (data.value(row, "kind") != CellValue(std::string("cell"))) continue;
        const auto number = [&](const char* key) { return std::get<double>(data.value(row, key)); };
        EXPECT_LE(number("nearest_r"), number("r"));
        entries += uint64_t(number("entries"));
        ASSERT_EQ(number("entries"), double(maps.triangles(uint32_t(number("number"))).size()));
    }
    EXPECT_EQ(entries, maps.indexEntries());
    EXPECT_THAT(han_hong::figureSentences(data), testing::ElementsAre(testing::HasSubstr("cells hold triangles")));
}

/// S² + its foot² = R², on an axis perpendicular to the sight ray, for the largest S that is not hidden for good.
TEST(HanHongFigures, projectionOfRIsS) {
    const ScenePointer scene = body();
    const StructureSnapshot snapshot = bandsOf(scene, 6);
    const spherical::MapSnapshot& map = spherical::mapsOf(snapshot).front();
    for (uint32_t sector = 0; sector < map.decision.bands->sectors; ++sector) {
        const std::vector<spherical::SizePlace> sizes = spherical::sizePlaces(map, sector);
        const std::optional<han_hong::Projection> found = han_hong::projectionOf(*scene, map, sizes);
        ASSERT_TRUE(found) << sector;
        const Vec3 toEye = glm::normalize(found->start - found->origin), r = found->place - found->origin;
        const Vec3 projected = found->onPerpendicular - found->origin;
        EXPECT_NEAR(glm::dot(projected, toEye), 0.0, 1e-9) << sector;
        EXPECT_NEAR(glm::length(projected), glm::length(r - glm::dot(r, toEye) * toEye), 1e-9) << sector;
        for (const spherical::SizePlace& size : sizes)
            if (!size.larger) EXPECT_LE(size.size, glm::length(projected) + 1e-9) << sector;
    }
    EXPECT_FALSE(han_hong::projectionOf(*scene, map, {}));
}

TEST(HanHongFigures, sixSaysWhatIsProjectedAndWhere) {
    const std::vector<std::string> words = wordsOf(made(6, body()).page);
    for (const char* wanted : {"O", "R", "α", "perpendicular axis", "S = R · sin α", "to the eye"})
        EXPECT_THAT(words, Contains(wanted));
    EXPECT_THAT(words, Contains(testing::HasSubstr("beyond α = 90°")));
    for (const char* band : {"1", "6", "12"}) EXPECT_EQ(std::ranges::count(words, band), 1) << "the number of a band";
}

TEST(HanHongFigures, threeComparesTheRayWithItsCells) {
    const std::vector<std::string> words = wordsOf(made(3, body()).page);
    for (const char* wanted : {"R of the ray", "R of the triangles of a cell", "hit"}) EXPECT_THAT(words, Contains(wanted));
}

TEST(HanHongFigures, eightSaysOfWhatAShareIsLost) {
    EXPECT_THAT(wordsOf(made(8, body()).page),
                Contains(testing::ContainsRegex("hidden by S: .* of the pixels that the object covers")));
}

TEST(HanHongFigures, threeSaysTheCaseTheEyeAndTheNumbersOfTheRays) {
    const han_hong::Figure figure = made(3, body(), [](han_hong::FigureRequest& request) { request.onlyCase = 3; });
    const std::vector<std::string> words = wordsOf(figure.page);
    EXPECT_THAT(words, Contains(testing::StartsWith("Case 3")));
    for (const char* wanted : {"eye", "1", "2", "3", "4"}) EXPECT_THAT(words, Contains(wanted));
}

TEST(HanHongFigures, wordsAreThoseOfTheLanguage) {
    han_hong::FigureRequest request;
    GlEnvironment::renderer();
    request.number = 3;
    request.scene = body();
    request.strategy = strategyFromText("spherical");
    request.width = 1800.0;  // no words are broken into lines
    PageLook look;
    look.style = svgStyle();
    look.say = [](const Words& words) { return "«" + words.english() + "»"; };
    for (const std::string& words : wordsOf(han_hong::figure(request, look).page))
        if (words.find_first_not_of("0123456789.-R ") != std::string::npos)  // numbers are the same in every language
            EXPECT_THAT(words, testing::HasSubstr("«")) << "every word is said in the language";
}

}  // namespace
}  // namespace cullscope::test::han_hong_figures_test
