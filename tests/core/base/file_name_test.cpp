#include "core/base/file_name.h"

#include <unistd.h>

#include <fstream>

#include "tests/support/refusal.h"

namespace cullscope::file_name_test {
namespace {

class FileName : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(m_folder); }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    /// The file name without its folder, which is the test's own.
    [[nodiscard]] std::string next(std::string_view pattern, std::string_view scene = "bunny",
                                   std::string_view strategy = "frustum") const {
        const std::filesystem::path path = nextFileName(m_folder, pattern, scene, strategy);
        EXPECT_EQ(path.parent_path(), m_folder);
        return path.filename().string();
    }
    void touch(const std::string& name) const { std::ofstream(m_folder / name) << "taken"; }
    [[nodiscard]] std::string refusal(std::string_view pattern) const {
        return test::refusalOf([&] { (void)nextFileName(m_folder, pattern, "bunny", "frustum"); }, ErrorKind::Usage);
    }
    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }

private:
    std::filesystem::path m_folder = std::filesystem::temp_directory_path() / ("cullscope-names-" + std::to_string(getpid()));
};

TEST_F(FileName, smallestFreeNumberIsTaken) {
    EXPECT_EQ(next("{scene}-{strategy}-{n:04}.png"), "bunny-frustum-0001.png");
    touch("bunny-frustum-0001.png");
    touch("bunny-frustum-0003.png");
    EXPECT_EQ(next("{scene}-{strategy}-{n:04}.png"), "bunny-frustum-0002.png");
    std::filesystem::create_symlink("nowhere", folder() / "bunny-frustum-0002.png");
    EXPECT_EQ(next("{scene}-{strategy}-{n:04}.png"), "bunny-frustum-0004.png") << "a link to nothing takes the name, too";
    EXPECT_EQ(next("{scene}-{strategy}-{n:04}.jpg"), "bunny-frustum-0001.jpg");
    for (int i = 1; i < 10; ++i) touch("p" + std::to_string(i));
    EXPECT_EQ(next("p{n}"), "p10");
    EXPECT_EQ(next("p{n:1}"), "p10");
    EXPECT_EQ(next("p{n:3}{n}"), "p0011");
}

TEST_F(FileName, patternWithoutANumberIsRefusedWhereTheFileExists) {
    EXPECT_EQ(next("{scene}.png"), "bunny.png");
    touch("bunny.png");
    EXPECT_THAT(refusal("{scene}.png"), testing::HasSubstr("put {n} into the file name"));
}

TEST_F(FileName, staysInTheFolderWhateverIsFilledIn) {
    EXPECT_EQ(next("{scene}-{n}.png", "field:mesh=/home/x/a?b.obj,n=3"), "field-mesh=-home-x-a-b.obj,n=3-1.png");
    EXPECT_EQ(next("{scene}{n}", "../../etc/"), "_.-..-etc-1");
    EXPECT_EQ(next("../{n}.png"), "_.-1.png");
    EXPECT_EQ(next("{scene}", ".."), "_.");
    EXPECT_EQ(next("{scene}{n}", std::string_view("a\0b\nc", 5)), "a-b-c1");
    EXPECT_EQ(next("{scene}{n}", "{n}{strategy}"), "{n}{strategy}1") << "what is filled in is not filled in again";
    EXPECT_EQ(next("토끼 {scene} {n}.png", "돌"), "토끼 돌 1.png");
}

TEST_F(FileName, longNameIsCutBetweenCharacters) {
    std::string korean;
    while (korean.size() < 400) korean += "가";
    const std::string name = next("{scene}-{strategy}-{n:04}.png", korean, korean);
    EXPECT_EQ(name, korean.substr(0, 99) + "-" + korean.substr(0, 99) + "-0001.png");
    touch(name);
    EXPECT_TRUE(std::filesystem::exists(folder() / name));
}

TEST_F(FileName, unknownFieldIsRefused) {
    for (const char* pattern :
         {"{sceen}.png", "{}.png", "{n:}.png", "{n:0}.png", "{n:00}", "{n:12}", "{n:x}", "{scene:4}", "{N}"})
        EXPECT_THAT(refusal(pattern), testing::HasSubstr("There are {scene}, {strategy}, {n} and {n:04}")) << pattern;
    EXPECT_THAT(refusal("a{scene"), testing::HasSubstr("{scene"));
}

}  // namespace
}  // namespace cullscope::file_name_test
