#include <unistd.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope::atomic_file_test {
namespace {

class AtomicFile : public testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() / ("cullscope-atomic-" + std::to_string(getpid()));
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }
    [[nodiscard]] std::filesystem::path file(const char* name) const { return m_folder / name; }
    static std::string contents(const std::filesystem::path& path) {
        std::ifstream in(path);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] std::ptrdiff_t filesInFolder() const {
        return std::distance(std::filesystem::directory_iterator(m_folder), std::filesystem::directory_iterator());
    }

private:
    std::filesystem::path m_folder;
};

TEST_F(AtomicFile, failedWriteLeavesTheOldFile) {
    writeFileAtomically(file("a.txt"), [](std::ostream& out) { out << "old"; });
    EXPECT_THROW(writeFileAtomically(file("a.txt"),
                                     [](std::ostream& out) {
                                         out << "half of the n";
                                         throwInterrupted();
                                     }),
                 Error);
    EXPECT_EQ(contents(file("a.txt")), "old");
    EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFile, failedStreamLeavesNoFile) {
    EXPECT_THROW(writeFileAtomically(file("b.txt"), [](std::ostream& out) { out.setstate(std::ios::badbit); }), Error);
    EXPECT_EQ(filesInFolder(), 0);
}

TEST_F(AtomicFile, placeThatDoesNotExistIsNamed) {
    try {
        writeFileAtomically(file("none") / "c.txt", [](std::ostream& out) { out << 1; });
        FAIL() << "written into a folder that does not exist";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(error.what(), testing::HasSubstr("c.txt"));
    }
}

TEST_F(AtomicFile, deviceStaysADevice) {
    EXPECT_THROW(writeFileAtomically("/dev/full", [](std::ostream& out) { out << "no room"; }), Error);
    writeFileAtomically("/dev/null", [](std::ostream& out) { out << "gone"; });
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(AtomicFile, linkIsFollowedAndFolderRefused) {
    writeFileAtomically(file("real.txt"), [](std::ostream& out) { out << "old"; });
    std::filesystem::create_symlink(file("real.txt"), file("link.txt"));
    writeFileAtomically(file("link.txt"), [](std::ostream& out) { out << "new"; });
    EXPECT_TRUE(std::filesystem::is_symlink(file("link.txt")));
    EXPECT_EQ(contents(file("real.txt")), "new");
    std::filesystem::create_directory(file("folder"));
    EXPECT_THROW(writeFileAtomically(file("folder"), [](std::ostream& out) { out << 1; }), Error);
}

TEST_F(AtomicFile, writingAgainReplacesTheContents) {
    writeFileAtomically(file("d.txt"), [](std::ostream& out) { out << "old and long"; });
    writeFileAtomically(file("d.txt"), [](std::ostream& out) { out << "new"; });
    EXPECT_EQ(contents(file("d.txt")), "new");
    EXPECT_EQ(filesInFolder(), 1);
}

}  // namespace
}  // namespace cullscope::atomic_file_test
