#include "core/visibility/parameters.h"

#include "tests/support/refusal.h"

namespace cullscope::parameters_test {
namespace {

std::vector<ParameterDeclaration> declarations() {
    ParameterDeclaration flag;
    flag.key = "flag";
    flag.type = ParameterType::Boolean;
    flag.defaultValue = true;
    ParameterDeclaration depth;
    depth.key = "depth";
    depth.type = ParameterType::Integer;
    depth.defaultValue = int64_t{4};
    depth.minimum = 1;
    depth.maximum = 12;
    ParameterDeclaration share;
    share.key = "share";
    share.type = ParameterType::Real;
    share.defaultValue = 0.5;
    share.minimum = -1.0;
    share.maximum = 1.0;
    return {flag, depth, share, choiceParameter("box", "p-vertex", "", {{"p-vertex", ""}, {"length", ""}})};
}

/// The error sentence for a value; empty where it is accepted.
std::string refusal(std::string_view key, std::string_view text) {
    ParameterSet set(declarations());
    const ParameterSet before = set;
    const std::string sentence = test::refusalOf([&] { set.setFromText(key, text); }, ErrorKind::Usage);
    EXPECT_TRUE(sentence.empty() || set == before) << "a refused value changed the set";
    return sentence;
}

TEST(ParameterSet, startsWithTheDefaults) {
    const ParameterSet set(declarations());
    EXPECT_TRUE(set.boolean("flag"));
    EXPECT_EQ(set.integer("depth"), 4);
    EXPECT_EQ(set.real("share"), 0.5);
    EXPECT_EQ(set.choice("box"), "p-vertex");
}

TEST(ParameterSet, textIsUnderstood) {
    ParameterSet set(declarations());
    for (const char* no : {"false", "0", "off", "no"}) {
        set.set("flag", true);
        set.setFromText("flag", no);
        EXPECT_FALSE(set.boolean("flag")) << no;
    }
    set.setFromText("depth", "12");
    EXPECT_EQ(set.integer("depth"), 12);
    set.setFromText("share", "-2.5e-1");
    EXPECT_EQ(set.real("share"), -0.25);
    set.setFromText("box", "length");
    EXPECT_EQ(set.choice("box"), "length");
}

TEST(ParameterSet, textOutOfRangeOrOfAnotherTypeIsRefused) {
    EXPECT_EQ(refusal("depth", "13"), "depth=13: depth is a whole number between 1 and 12.");
    EXPECT_EQ(refusal("depth", "0"), "depth=0: depth is a whole number between 1 and 12.");
    EXPECT_EQ(refusal("share", "1.5"), "share=1.5: share is a number between -1 and 1.");
    EXPECT_EQ(refusal("flag", "maybe"), "flag=maybe: flag is true or false.");
    EXPECT_EQ(refusal("box", "sphere"), "box=sphere: box is one of p-vertex, length.");
    for (const char* text : {"", "4.5", "4x", " 4", "0x4", "99999999999999999999"}) EXPECT_NE(refusal("depth", text), "") << text;
    for (const char* text : {"", "nan", "inf", "0,5", "0.5 ", "half"}) EXPECT_NE(refusal("share", text), "") << text;
}

TEST(ParameterSet, unknownKeyIsRefused) {
    EXPECT_EQ(refusal("dept", "4"), "There is no parameter \"dept\" here. Known: flag, depth, share, box.");
    EXPECT_EQ(
        test::refusalOf([] { ParameterSet(std::vector<ParameterDeclaration>{}).setFromText("dept", "4"); }, ErrorKind::Usage),
        "There is no parameter \"dept\" here, and no other one.");
    EXPECT_THROW((void)ParameterSet().value("depth"), Error);
}

TEST(ParameterSet, valueOfAnotherTypeIsRefused) {
    ParameterSet set(declarations());
    EXPECT_THROW(set.set("depth", 4.0), Error);
    EXPECT_THROW(set.set("share", int64_t{1}), Error);
    EXPECT_THROW(set.set("flag", std::string("true")), Error);
    EXPECT_THROW(set.set("box", std::string("no")), Error);
    EXPECT_NO_THROW(set.set("box", std::string("length")));
}

TEST(ParameterSet, textComesBackAsTheSameValue) {
    ParameterSet set(declarations());
    for (const double value : {0.1, 1.0 / 3.0, -1e-300, 1.0}) {
        set.set("share", value);
        ParameterSet other(declarations());
        other.setFromText("share", toText(set.value("share")));
        EXPECT_EQ(other, set) << toText(value);
    }
}

}  // namespace
}  // namespace cullscope::parameters_test
