#include "core/base/message.h"
#include "core/base/error.h"

namespace cullscope::message_test {
namespace {

TEST(Message, placesAreFilledInAndArgumentsStayAsTheyAre) {
    EXPECT_EQ(fillIn("%1 and %2, %1 again", {"a", "b"}), "a and b, a again");
    // A value that looks like a placeholder is inserted as text.
    EXPECT_EQ(fillIn("%1 %2", {"%2", "b"}), "%2 b");
}

TEST(Message, placeWithoutArgumentAndLonePercentStay) {
    EXPECT_EQ(fillIn("%1 %2 100 % %", {"a"}), "a %2 100 % %");
    EXPECT_EQ(fillIn("", {"a"}), "");
}

TEST(Error, kindIsTheExitStatus) {
    try {
        throwInput("%1 is broken.", {"mesh.obj"});
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.kind()), 3);
        EXPECT_STREQ(error.what(), "mesh.obj is broken.");
        EXPECT_EQ(error.message().arguments, std::vector<std::string>{"mesh.obj"});
    }
    EXPECT_EQ(static_cast<int>(ErrorKind::Usage), 2);
    EXPECT_EQ(static_cast<int>(ErrorKind::OpenGl), 4);
    EXPECT_EQ(static_cast<int>(ErrorKind::Interrupted), 130);
}

}  // namespace
}  // namespace cullscope::message_test
