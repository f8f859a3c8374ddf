// The figures of Han & Hong 2008 as pages with their data.
#include "core/experiments/han_hong_figures.h"

#include <gmock/gmock.h>

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

size_t rowsOf(const ResultTable& table, const std::string& kind) {
    size_t count = 0;
    for (size_t row = 0; row < table.rows.size(); ++row) count += table.value(row, "kind") == CellValue(kind) ? 1 : 0;
    return count;
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
            EXPECT_EQ(picture.rgba.size(), size_t(picture.size.width) * size_t(picture.size.height) * 4);
        }
    }
    EXPECT_THAT(refusalOf([&] { (void)made(9, scene); }, ErrorKind::Usage), testing::HasSubstr("There is no Figure 9"));
}

TEST(HanHongFigures, fourHasTicksAxesLegendAndTheCaseOfEachMap) {
    const han_hong::Figure figure = made(4, body());
    const std::vector<std::string> words = wordsOf(figure.page);
    EXPECT_EQ(figure.page.pictures.size(), 3u);
    for (const char* wanted : {"0°", "180°", "360°", "θ", "φ", "visible region", "its box", "corner: hit"})
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

TEST(HanHongFigures, contoursLieOnTheSurfaceAtTheEdgesOfBands) {
    const ScenePointer scene = body();
    StructureStore structures;
    const StrategyRequest request = strategyFromText(han_hong::figureStrategy(7));
    const BuiltStrategyPointer strategy = buildStrategy(request.id, request.parameters, scene, structures);
    const View view(overviewCamera(*scene, 4.0 / 3.0), {640, 480});
    GpuFrame frame(GlEnvironment::renderer(), SceneBuffers(scene, Upload::Vbo), view, true);
    strategy->draw(frame, *strategy->begin());
    const FrameLog log = frame.take();
    const StructureSnapshot snapshot = strategy->snapshot(log);
    const spherical::MapSnapshot& map = spherical::mapsOf(snapshot).front();
    const DrawStyle style;
    const OverlayContext context{*scene, view, style, verdictPalette(style.background), Vec3f(1.0f)};
    const spherical::MapPlace place(*scene, map);
    const spherical::ContourBands& bands = *map.decision.bands;
    size_t lines = 0;
    for (const OverlayLines& overlay : han_hong::contoursOnSurface(context, map))
        for (const LineSegment& line : overlay.lines) {
            // Back from where it stands before the surface.
            const Vec3 point = place.local((line.from - 0.003 * view.eye()) / 0.997);
            const double alpha = bands.anglesOf(point).x / bands.width;
            // Straight between two corners of a triangle, α bends by less than a tenth of a band.
            ASSERT_NEAR(alpha, std::round(alpha), 0.1) << lines;
            ++lines;
        }
    EXPECT_GT(lines, 500u);
    // In the sector of Figure 6 no hidden band has an S larger than those before it, where there is such a sector.
    const uint32_t sector = han_hong::tellingSector(bands, Vec3(0, 0, 1));
    const auto larger = [&](uint32_t which) {
        return std::ranges::count_if(spherical::sizePlaces(map, which), &spherical::SizePlace::larger);
    };
    for (uint32_t other = 0; other < bands.sectors; ++other) EXPECT_LE(larger(sector), larger(other)) << other;
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
    PageLook look;
    look.style = svgStyle();
    look.say = [](const Words& words) { return "«" + words.english() + "»"; };
    for (const std::string& words : wordsOf(han_hong::figure(request, look).page))
        if (words.size() > 1)  // the rays' numbers are the same in every language
            EXPECT_THAT(words, testing::HasSubstr("«")) << "every word is said in the language";
}

}  // namespace
}  // namespace cullscope::test::han_hong_figures_test
