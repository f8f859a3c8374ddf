#include "core/base/terminal_text.h"

#include <gtest/gtest.h>

namespace cullscope::terminal_text_test {
namespace {

TEST(TerminalText, textsOfAllLanguagesStayAsTheyAre) {
    for (const std::string text : {"", "a b\tc\n", "가나다 – “x”", "é", "𝄞", "\xC2\xA0"}) EXPECT_EQ(terminalText(text), text);
}

TEST(TerminalText, whatATerminalWouldObeyIsAQuestionMark) {
    EXPECT_EQ(terminalText("\x1B[2Jhello"), "?[2Jhello");
    EXPECT_EQ(terminalText("\x1B]0;title\x07"), "?]0;title?");
    EXPECT_EQ(terminalText("a\rb\bc\x7F"), "a?b?c?");
    EXPECT_EQ(terminalText(std::string("a\0b", 3)), "a?b");
    EXPECT_EQ(terminalText("\xC2\x9B"
                           "31m"),
              "?31m")
        << "one of the controls above U+0080";
}

TEST(TerminalText, bytesThatAreNoUtf8AreQuestionMarks) {
    EXPECT_EQ(terminalText("\x9B"
                           "31m"),
              "?31m");
    EXPECT_EQ(terminalText("\xC0\x9B"), "??") << "longer than needed";
    EXPECT_EQ(terminalText("\xE0\x82\x9B"), "???") << "longer than needed";
    EXPECT_EQ(terminalText("\xED\xA0\x80"), "???") << "half of a pair";
    EXPECT_EQ(terminalText("\xF4\x90\x80\x80"), "????") << "beyond Unicode";
    EXPECT_EQ(terminalText("a\xE3\x81"), "a??") << "cut off";
}

TEST(TerminalText, aLineHasNoOtherOne) { EXPECT_EQ(terminalLine("a\nb\tc\x1B[0m가"), "a?b?c?[0m가"); }

TEST(TerminalText, aPlainNameKeepsTheLettersOfOtherEncodings) {
    EXPECT_EQ(plainName("a b\nc\x1B[0m\x7F\xC2\x9B가"), "a b_c_[0m__가");
    EXPECT_EQ(plainName("T\xFCr \x9B"
                        "31m"),
              "T\xFCr _31m")
        << "a letter of Latin-1, and its control sequence introducer";
}

TEST(TerminalText, aPlainJsonSaysTheSame) {
    EXPECT_EQ(plainJson("{\"a\": \"\\u001b 가\"}\n"), "{\"a\": \"\\u001b 가\"}\n");
    EXPECT_EQ(plainJson("\"\x7F\xC2\x9B\""), "\"\\u007f\\u009b\"");
}

}  // namespace
}  // namespace cullscope::terminal_text_test
