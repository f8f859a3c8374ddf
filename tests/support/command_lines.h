#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cullscope::test {

/// Where a standard stream leads.
enum class Stream {
    Usual,      ///< input: nothing; output: a file
    Closed,     ///< no such descriptor
    Full,       ///< a device without space
    ReaderGone  ///< a pipe whose reader has gone
};

/// A command line with its surroundings.
struct CommandLine {
    std::vector<std::string> words;  ///< without the program
    Stream in = Stream::Usual, out = Stream::Usual, err = Stream::Usual;
    bool folderGone = false;   ///< the working folder is removed before the program starts
    uint64_t mostThreads = 0;  ///< of a user of its own without privileges, where the test has those; 0: as many as the test has
    uint64_t mostMemory = 0;   ///< bytes of address space; 0: as many as the test has
    std::vector<std::pair<std::string, std::string>> set;  ///< environment; empty value: removed

    /// As a shell would take it.
    [[nodiscard]] std::string text(const std::string& program) const;
};

/// What became of it.
struct CommandEnd {
    bool tooLong = false;  ///< it was ended for that
    int signal = 0;        ///< that ended it
    int status = -1;
    std::string out, err;
    std::filesystem::path folder;  ///< its working folder, with what it left there
};

/// Runs a program once for each line, `together` at once, each in a working folder of its own below `folder` which is empty
/// before and removed afterwards. `done` gets the number of a line and its end, on any thread, one call at a time.
void runCommandLines(const std::string& program, const std::vector<CommandLine>& lines, const std::filesystem::path& folder,
                     int together, double mostSeconds, const std::function<void(size_t, const CommandEnd&)>& done);

/// Who writes to a program's standard error.
enum class Said {
    ByProgram,   ///< it alone
    ByLibraries  ///< its libraries, too
};

/// What is wrong with the end of a command line by the rules for all of them: it ends in time, by itself, with a status of the
/// table, and an error says itself on lines that begin with the program's name and have a reasonable length. Neither stream has a
/// control character or a word of the C++ runtime (binary data on standard output aside); no temporary file is left. Empty:
/// nothing.
[[nodiscard]] std::string faultOf(const std::string& program, const CommandLine& line, const CommandEnd& end,
                                  Said said = Said::ByProgram);

}  // namespace cullscope::test
