// The figures of Han & Hong 2008 as pages with their data.
#include "core/experiments/han_hong_figures.h"

#include <gmock/gmock.h>

#include "core/image/drawing_svg.h"
#include "core/visibility/spherical/contour_bands.h"
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
        EXPECT_THAT(words, testing::HasSubstr("«")) << "every word is said in the language";
}

}  // namespace
}  // namespace cullscope::test::han_hong_figures_test
