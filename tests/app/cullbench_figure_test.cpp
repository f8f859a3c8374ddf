// The command line's contract (docs/command-line.md) for the figures of Han & Hong 2008.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/image/picture_file.h"
#include "tests/support/cullbench_contract.h"

namespace cullscope::test::cullbench_figure_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kBody = "star:seed=3,triangles=5000";

std::string textOf(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(CullbenchContract, figureWritesPictureAndDataTogether) {
    const ProcessResult result = cullbench({"figure", "6", kBody, "-o", file("f.png"), "--json", file("f.json"), "--csv", "-"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    const Picture picture = readPicture(file("f.png"));
    EXPECT_EQ(picture.size.width, 1280);
    EXPECT_THAT(picture.metadata, testing::Contains(testing::Pair("cullscope:figure", HasSubstr("Figure 6"))));
    const json table = json::parse(textOf(file("f.json")))["experiments"][0];
    EXPECT_EQ(size_t(std::ranges::count(result.out, '\n')), table["rows"].size() + 1);
    EXPECT_THAT(result.out, testing::StartsWith("view,case,object,kind,"));
    EXPECT_EQ(table["rows"][0]["kind"], "band");
    EXPECT_THAT(result.err, HasSubstr("Han & Hong 2008, Figure 6"));
}

TEST_F(CullbenchContract, figureAsSvgSpeaksTheDesktopsLanguages) {
    for (const auto& [language, words] : {std::pair("en", "visible region"), {"ko", "가시 영역"}, {"zh_CN", "可见区域"}}) {
        const ProcessResult result =
            cullbench({"figure", "4", kBody, "--case", "3", "--language", language, "-o", file("f.svg")});
        ASSERT_EQ(result.exitStatus, 0) << result.err;
        const std::string svg = textOf(file("f.svg"));
        EXPECT_THAT(svg, HasSubstr(words)) << language;
        EXPECT_THAT(svg, HasSubstr("data:image/png;base64,"));
        EXPECT_THAT(svg, HasSubstr(">θ</text>"));
    }
}

TEST_F(CullbenchContract, figureFourSaysTheCasesOnStandardOutput) {
    const ProcessResult result = cullbench({"figure", "4", kBody, "-o", file("f.svg")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    for (const char* words :
         {"view 1, object 0: case 1; 4 of 4 corner rays hit; boxes θ", "view 2, object 0: case 2;", "view 3, object 0: case 3;"})
        EXPECT_THAT(result.out, HasSubstr(words));
}

TEST_F(CullbenchContract, figureRefusesWhatIsNone) {
    expectRefusal(cullbench({"figure", "9", kBody, "-o", file("f.png")}), 2, "9");
    expectRefusal(cullbench({"figure", "1", kBody}), 2, "-o");
    expectRefusal(cullbench({"figure", "1", kBody, "-o", file("f.bmp")}), 2, ".png");
    expectRefusal(cullbench({"figure", "1", kBody, "-o", "-", "--csv", "-"}), 2, "standard output");
    expectRefusal(cullbench({"figure", "3", kBody, "--pose", "12", "-o", file("f.png")}), 2, "--pose 12");
    expectRefusal(cullbench({"figure", "1", kBody, "--step", "100000", "-o", file("f.png")}), 2, "--step 100000");
    expectRefusal(cullbench({"figure", "4", kBody, "--language", "fr", "-o", file("f.png")}), 2, "fr");
    expectRefusal(cullbench({"figure", "4", kBody, "-p", "colour=red", "-o", file("f.png")}), 2, "colour");
    EXPECT_EQ(filesWritten(), 0u);
}

}  // namespace
}  // namespace cullscope::test::cullbench_figure_test
