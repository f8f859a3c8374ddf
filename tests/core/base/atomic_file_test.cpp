#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
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

TEST_F(AtomicFile, modeAndLinksSurviveARewrite) {
    const auto mode = [&](const char* name) { return std::filesystem::status(file(name)).permissions(); };
    for (const auto wanted : {std::filesystem::perms(0600), std::filesystem::perms(0751), std::filesystem::perms(0664)}) {
        writeFileAtomically(file("a.txt"), [](std::ostream& out) { out << "old"; });
        std::filesystem::permissions(file("a.txt"), wanted);
        writeFileAtomically(file("a.txt"), [](std::ostream& out) { out << "new"; });
        EXPECT_EQ(mode("a.txt"), wanted);
    }
    // A link may lead to a file that is not there yet, and over other links.
    std::filesystem::create_symlink("second", file("first"));
    std::filesystem::create_symlink(file("absent.txt"), file("second"));
    writeFileAtomically(file("first"), [](std::ostream& out) { out << "through"; });
    EXPECT_TRUE(std::filesystem::is_symlink(file("first")));
    EXPECT_TRUE(std::filesystem::is_symlink(file("second")));
    EXPECT_EQ(contents(file("absent.txt")), "through");
    std::filesystem::create_symlink("round", file("round"));
    EXPECT_THROW(writeFileAtomically(file("round"), [](std::ostream& out) { out << 1; }), Error);
    EXPECT_TRUE(std::filesystem::is_symlink(file("round")));
}

TEST_F(AtomicFile, longestNamesAreWritten) {
    const std::string ascii(255, 'x'), extension = "a." + std::string(253, 'y');
    std::string korean;
    while (korean.size() + 3 <= 255) korean += "\xEA\xB0\x80";
    for (const std::string& name : {ascii, extension, korean}) {
        writeFileAtomically(file(name.c_str()), [](std::ostream& out) { out << "whole"; });
        EXPECT_EQ(contents(file(name.c_str())), "whole");
    }
    const std::string tooLong(256, 'x');
    EXPECT_THROW(requireWritable(file(tooLong.c_str())), Error);
    EXPECT_EQ(filesInFolder(), 3);
}

TEST_F(AtomicFile, whatAKilledProgramLeftIsRemovedAndWhatOneStillWritesIsNot) {
    std::filesystem::create_directories(file(""));
    const pid_t killed = fork();
    if (killed == 0)
        writeFileAtomically(file("a.txt"), [](std::ostream& out) {
            out << "half" << std::flush;
            raise(SIGKILL);
        });
    int status = 0;
    ASSERT_EQ(waitpid(killed, &status, 0), killed);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(filesInFolder(), 1) << "the half file";
    writeFileAtomically(file("b.txt"), [&](std::ostream& out) {
        out << "outer";
        // Another file is finished in the same folder meanwhile.
        writeFileAtomically(file("c.txt"), [](std::ostream& inner) { inner << "inner"; });
    });
    EXPECT_EQ(contents(file("b.txt")), "outer");
    EXPECT_EQ(contents(file("c.txt")), "inner");
    EXPECT_EQ(filesInFolder(), 2);
}

TEST_F(AtomicFile, placesThatCannotBeWrittenAreKnownBefore) {
    writeFileAtomically(file("old.txt"), [](std::ostream& out) { out << "old"; });
    std::filesystem::create_directory(file("folder"));
    for (const std::filesystem::path& path :
         {file("folder"), file("folder/"), file("none/a.txt"), file("old.txt/a.txt"), std::filesystem::path(".")})
        EXPECT_THROW(requireWritable(path), Error) << path;
    for (const std::filesystem::path& path : {file("old.txt"), file("new.txt"), std::filesystem::path("-"),
                                              std::filesystem::path(), std::filesystem::path("/dev/null")})
        EXPECT_NO_THROW(requireWritable(path)) << path;
    EXPECT_EQ(contents(file("old.txt")), "old");
    EXPECT_EQ(filesInFolder(), 2);
}

TEST_F(AtomicFile, writingAgainReplacesTheContents) {
    writeFileAtomically(file("d.txt"), [](std::ostream& out) { out << "old and long"; });
    writeFileAtomically(file("d.txt"), [](std::ostream& out) { out << "new"; });
    EXPECT_EQ(contents(file("d.txt")), "new");
    EXPECT_EQ(filesInFolder(), 1);
}

}  // namespace
}  // namespace cullscope::atomic_file_test
