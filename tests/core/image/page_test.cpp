// Pages: pictures with what is drawn and written over them, as files.
#include "core/image/page.h"

#include <gmock/gmock.h>

#include "core/image/drawing_svg.h"
#include "core/image/page_legend.h"

namespace cullscope::test::page_test {
namespace {

using testing::HasSubstr;

/// How many pixels of a canvas's part differ from its ground.
size_t inked(const Canvas& canvas, const Viewport& size) {
    const std::vector<uint8_t> rgba = canvas.rgba();
    size_t count = 0;
    for (size_t i = 0; i < size_t(size.width) * size_t(size.height); ++i) count += rgba[4 * i] < 128 ? 1 : 0;
    return count;
}

std::vector<uint8_t> written(const Letters& letters, const std::string& words, bool bold = false) {
    Canvas canvas({200, 40}, Vec3f(1.0f), 1.0f);
    letters.draw(canvas, {10.0, 30.0}, words, Vec3f(0.0f), bold);
    return canvas.rgba();
}

TEST(Letters, ofEveryLanguageOfTheProgramAreTheirOwn) {
    const Letters letters(20.0);
    // A letter that no font has is the same empty box for all: these differ from it and from each other.
    const std::vector<uint8_t> box = written(letters, "\U0010FFFD");
    std::vector<std::vector<uint8_t>> pictures{box};
    for (const char* word : {"θ", "φ", "S", "경", "우", "情", "形", "°"}) {
        pictures.push_back(written(letters, word));
        for (size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures.back(), pictures[i]) << word;
    }
}

TEST(Letters, charactersHaveTheFormsOfTheirLanguage) {
    const Letters letters(40.0);
    // The first letter alone, which is as wide as high.
    const auto firstOf = [&](const std::string& words) {
        Canvas canvas({60, 60}, Vec3f(1.0f), 1.0f);
        letters.draw(canvas, {20.0, 50.0}, words, Vec3f(0.0f));
        return canvas.rgba();
    };
    // 骨 turns its inner corner to the left in mainland China alone, 直 has an angle at its foot in Japan and Korea.
    for (const char* character : {"骨", "直"}) {
        const std::string same(character);
        EXPECT_EQ(firstOf(same), firstOf(same + "形")) << character;
        EXPECT_NE(firstOf(same), firstOf(same + "の")) << character;
        EXPECT_NE(firstOf(same), firstOf(same + "경")) << character;
    }
}

TEST(Letters, wordsAreAsWideAsTheirLetters) {
    const Letters letters(20.0), small(10.0);
    EXPECT_EQ(letters.width(""), 0.0);
    EXPECT_NEAR(letters.width("경우") + letters.width(" 1"), letters.width("경우 1"), 1e-9);
    EXPECT_NEAR(letters.width("azimuth"), 2.0 * small.width("azimuth"), 0.1);
    EXPECT_GT(letters.width("azimuth", true), letters.width("azimuth"));
    // Bytes that are no UTF-8 are question marks, as on a terminal.
    EXPECT_EQ(written(letters, "a\xff"), written(letters, "a?"));
}

TEST(Letters, standOnTheirLineWithinTheirWidth) {
    const Letters letters(20.0);
    constexpr Viewport kSize{200, 40};
    Canvas canvas(kSize, Vec3f(1.0f), 1.0f);
    letters.draw(canvas, {10.0, 30.0}, "HEM", Vec3f(0.0f));
    const std::vector<uint8_t> rgba = canvas.rgba();
    int left = kSize.width, right = 0, top = kSize.height, bottom = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            if (rgba[4 * (size_t(kSize.height - 1 - y) * size_t(kSize.width) + size_t(x))] > 128) continue;
            left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
        }
    EXPECT_EQ(bottom, 29) << "capitals stand on the base line";
    EXPECT_GT(top, 30 - int(letters.ascent()) - 1);
    EXPECT_GE(left, 10);
    EXPECT_LE(right, 10 + int(letters.width("HEM")) + 1);
    EXPECT_GT(inked(canvas, kSize), 100u);
}

/// A page of a red picture with a green square, a line and words over it.
Page samplePage() {
    Page page;
    page.width = 120.0;
    page.height = 80.0;
    PagePicture picture{{10.0, 20.0}, {40, 30}, {}};
    for (int i = 0; i < 40 * 30; ++i) picture.rgba.insert(picture.rgba.end(), {255, 0, 0, 255});
    // The lowest row is blue: rows count from the bottom.
    for (size_t i = 0; i < 40; ++i) picture.rgba[4 * i] = 0, picture.rgba[4 * i + 2] = 255;
    page.pictures.push_back(std::move(picture));
    page.drawing.items.emplace_back(DrawnPath{{{20, 25}, {30, 25}, {30, 35}, {20, 35}}, {}, 0xFF00FF00});
    page.drawing.items.emplace_back(DrawnPath{{{60, 10}, {110, 10}}, {0xFF000000, 2.0}});
    page.text({60.0, 60.0}, "경우 <2>", 0xFF000000);
    return page;
}

TEST(Page, asAPictureHasAllOfIt) {
    const Letters letters(13.0);
    const Picture picture = pagePicture(samplePage(), letters);
    ASSERT_EQ(picture.size, (Viewport{120, 80}));
    const auto at = [&](int x, int y) {
        const uint8_t* pixel = &picture.rgba[4 * (size_t(79 - y) * 120 + size_t(x))];
        return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
    };
    EXPECT_EQ(at(5, 5), (std::array{255, 255, 255}));
    EXPECT_EQ(at(12, 22), (std::array{255, 0, 0}));
    EXPECT_EQ(at(12, 49), (std::array{0, 0, 255}));
    EXPECT_EQ(at(25, 30), (std::array{0, 255, 0}));
    EXPECT_EQ(at(80, 10)[0], 0);
    size_t letterPixels = 0;
    for (int y = 48; y < 64; ++y)
        for (int x = 60; x < 118; ++x) letterPixels += at(x, y)[0] < 128 ? 1 : 0;
    EXPECT_GT(letterPixels, 40u);
}

TEST(Page, ofTwiceTheScaleHasTwiceThePixelsOfEverything) {
    Page page = samplePage();
    page.scale = 2.0;
    PagePicture& picture = page.pictures.front();
    const std::vector<uint8_t> once = std::exchange(picture.rgba, {});
    for (size_t y = 0; y < 60; ++y)
        for (size_t x = 0; x < 80; ++x)
            for (size_t c = 0; c < 4; ++c) picture.rgba.push_back(once[4 * (y / 2 * 40 + x / 2) + c]);
    const Letters letters(13.0), large(26.0);
    const Picture small = pagePicture(samplePage(), letters), sharp = pagePicture(page, large);
    ASSERT_EQ(sharp.size, (Viewport{240, 160}));
    const auto at = [](const Picture& from, int x, int y) {
        const uint8_t* pixel = &from.rgba[4 * (size_t(from.size.height - 1 - y) * size_t(from.size.width) + size_t(x))];
        return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
    };
    // Apart from the letters, whose outlines are sharper, and the line's ends.
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 218; ++x)
            if (x < 116 || x > 122 || y < 16 || y > 24) EXPECT_EQ(at(sharp, x, y), at(small, x / 2, y / 2)) << x << " " << y;
    EXPECT_NEAR(pageStyle(large, 2.0).height, pageStyle(letters).height, 1.0);
    EXPECT_NEAR(pageStyle(large, 2.0).width("words"), pageStyle(letters).width("words"), 2.0);
    EXPECT_THAT(pageSvg(page), HasSubstr("viewBox=\"0 0 120 80\"")) << "units do not change";
    EXPECT_THAT(pageSvg(page), HasSubstr("<image x=\"10\" y=\"20\" width=\"40\" height=\"30\""));
}

TEST(Page, asSvgKeepsWordsAsWordsAndThePictureAsOne) {
    const std::string svg = pageSvg(samplePage());
    EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 120 80\""));
    EXPECT_THAT(svg, HasSubstr(">경우 &lt;2&gt;</text>"));
    EXPECT_THAT(svg, HasSubstr("<image x=\"10\" y=\"20\" width=\"40\" height=\"30\" href=\"data:image/png;base64,iVBORw0KGgo"));
    EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
}

TEST(Page, legendsAndTextsBreakWithinTheirWidth) {
    const PlotStyle style = svgStyle();
    Page page;
    const std::vector<PageLegendEntry> entries(5, {{PageSign::Shape::Area, 0xFF112233}, "ten letters"});
    const double wide = addLegend(page, entries, {0.0, 0.0}, 2000.0, style);
    const double narrow = addLegend(page, entries, {0.0, 100.0}, 260.0, style) - 100.0;
    EXPECT_NEAR(narrow, 3.0 * wide, 1e-9) << "two in a row";
    for (const auto& item : page.drawing.items)
        if (const auto* text = std::get_if<DrawnText>(&item); text != nullptr && text->at.y > 100.0)
            EXPECT_LE(text->at.x + style.width(text->words), 260.0);
    const double one = addText(page, "some words", {0.0, 0.0}, 1000.0, style, 0xFF000000);
    EXPECT_NEAR(addText(page, "some words", {0.0, 0.0}, style.width("words") + 1.0, style, 0xFF000000), 2.0 * one, 1e-9);
    EXPECT_EQ(addLegend(page, {}, {0.0, 7.0}, 100.0, style), 7.0);
}

}  // namespace
}  // namespace cullscope::test::page_test
