// Values of options that mean nothing: refused with a short sentence, before the work.

#include "tests/support/cullbench_contract.h"

namespace cullbench_options_test {
namespace {

using cullscope::test::cullbench;
using cullscope::test::CullbenchContract;
using cullscope::test::expectRefusal;
using cullscope::test::ProcessResult;
using cullscope::test::runProcess;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

constexpr size_t kLongestSentence = 400;

class CullbenchContractOptions : public CullbenchContract {
protected:
    [[nodiscard]] ProcessResult render(const Words& more) const {
        Words words{"render", "sphere:triangles=20", "-o", file("a.png")};
        words.insert(words.end(), more.begin(), more.end());
        return cullbench(words);
    }
    void expectRefused(const Words& more, const std::string& mentions) const {
        const ProcessResult result = render(more);
        expectRefusal(result, 2, mentions);
        EXPECT_LT(result.err.size(), kLongestSentence);
        EXPECT_EQ(filesWritten(), 0u);
    }
};

TEST_F(CullbenchContractOptions, numbersThatMeanNothingAreRefusedInAFewWords) {
    for (const char* option : {"--near", "--far", "--view-near", "--view-far", "--view-fovy"})
        for (const char* value : {"nan", "inf", "0", "-1", "1x", "1e999"})
            expectRefused({"-s", "all", std::string(option) + "=" + value}, std::string(value) + " is not a number above 0");
    for (const char* value : {"nan", "0", "180"})
        expectRefused({"-s", "all", "--fovx", value}, "is not a number from 0.001 to 179");
    for (const char* value : {"-1", "1.5", "nan"})
        expectRefused({"-s", "all", "--path", "orbit:2", std::string("--pose=") + value}, "is not a whole number from 0");
}

TEST_F(CullbenchContractOptions, emptyValuesAreRefused) {
    for (const char* option : {"--eye", "--target", "--path", "--overlay", "--size"})
        for (const Words& empty : {Words{option, ""}, Words{std::string(option) + "="}}) {
            Words words{"-s", "all"};
            words.insert(words.begin(), empty.begin(), empty.end());
            expectRefused(words, std::string(option) + ": its value is empty");
        }
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--json", ""}), 2, "its value is empty");
}

TEST_F(CullbenchContractOptions, strategyListsWithGapsOrRepetitionsAreRefused) {
    for (const char* list : {"all,,frustum", "all,", ",all"}) expectRefused({"-s", list}, "");
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all,,frustum"}), 2, "lacks a strategy");
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "frustum:box=length,box=length"}), 2, "given twice");
    expectRefused({"-s", "frustum", "-p", "box=length", "-p", "frustum.box=length"}, "given twice");
    const Words sweep{"sweep", "sphere:triangles=20", "-s", "spherical", "--vary", "rows=45,45"};
    expectRefusal(cullbench(sweep), 2, "given twice");
}

TEST_F(CullbenchContractOptions, placesThatCannotBeWrittenAreRefusedBeforeTheWork) {
    // The work itself would take hours.
    const std::string unwritable = "cannot be written";
    for (const auto& [place, reason] : std::vector<std::pair<std::string, std::string>>{
             {".", "is a folder"}, {file("absent/a.json"), unwritable}, {file(std::string(300, 'a')), unwritable}})
        expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", "fibonacci:1000000", "--json", place}),
                      2, reason);
    const std::string folder = file("removed");
    const ProcessResult result = runProcess({"/bin/sh", "-c",
                                             "mkdir " + folder + " && cd " + folder + " && rmdir " + folder +
                                                 " && exec '" CULLBENCH "' render sphere:triangles=20 -s all -o a.png"});
    EXPECT_EQ(result.exitStatus, 2) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("filesystem error")));
}

TEST_F(CullbenchContractOptions, namesTooLongForAFileAreUnknownNames) {
    const std::string name(300, 'a');
    expectRefusal(cullbench({"measure", name, "-s", "all"}), 2, name);
    expectRefusal(cullbench({"measure", "./" + name + ".obj", "-s", "all"}), 3, name);
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", name}), 2, name);
    expectRefusal(cullbench({"measure", "sphere:triangles=20", "-s", "all", "--path", "./" + name}), 3, name);
}

}  // namespace
}  // namespace cullbench_options_test
