#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace cullscope::rules {

/// An `#include` line.
struct Include {
    std::filesystem::path file;  ///< relative to the tree's root
    int line = 0;
    std::string name;  ///< the text between the quotes or the angle brackets
    bool quoted = false;
};

/// Every `#include` of the .h and .cpp files below the given folders of `root`, files in alphabetical order.
[[nodiscard]] std::vector<Include> includesBelow(const std::filesystem::path& root, const std::vector<std::string>& folders);

/// A violation of a rule, with its place.
struct Offence {
    std::filesystem::path file;  ///< relative to the tree's root
    int line = 0;                ///< 0: the file or folder as a whole
    std::string what;

    bool operator==(const Offence&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Offence& offence);

/// The layers of core, lowest first.
[[nodiscard]] const std::vector<std::string>& layers();

/// The folders of ui, from the ground up.
[[nodiscard]] const std::vector<std::string>& uiFolders();

/// Includes that point down the list of layers or of ui's folders, from core to ui or app, or from ui to app; folders of core and
/// ui that stand in neither list.
[[nodiscard]] std::vector<Offence> layeringOffences(const std::filesystem::path& root);

/// Includes of a family's headers (core/visibility/FAMILY) by another family, by the contract that all share, and by what stands
/// above, and names of a family's namespace (`FAMILY::`) there: only the registry and the experiments may know families. Sources
/// of a family outside its namespace.
[[nodiscard]] std::vector<Offence> familyOffences(const std::filesystem::path& root);

/// String literals that are the id of a strategy, outside core/visibility and core/experiments: lists of strategies come from
/// the registry. Texts of widgets, in tr(), are no ids.
[[nodiscard]] std::vector<Offence> strategyIdOffences(const std::filesystem::path& root, const std::vector<std::string>& ids);

/// String literals of ui, app, core/image and core/measure, those of tr() too, that contain the id of a strategy as a word, and
/// identifiers there that are named by one, as "ratioToBackface" is: sentences get the ids from the registry, and what is meant
/// is a strategy's role. Ids that are words of other things, such as "all", are reported where a literal is such an id alone,
/// with its parameters, or in a list of strategies.
[[nodiscard]] std::vector<Offence> strategyWordOffences(const std::filesystem::path& root, const std::vector<std::string>& ids);

/// String literals of app and ui that contain one of these words, whatever the case of their letters: what a strategy's shows are
/// called is said where it declares them, and nowhere else.
[[nodiscard]] std::vector<Offence> showWordOffences(const std::filesystem::path& root, const std::vector<std::string>& words);

/// Includes of Qt in core or in cullbench, of OpenGL outside core/gpu, and of OpenMesh outside core/mesh.
[[nodiscard]] std::vector<Offence> libraryOffences(const std::filesystem::path& root);

/// Includes of core/measure/render_frame.h, which times one frame, in what measures: core, ui, app and tests/benchmark. Frames
/// are timed by TimedRounds alone, the one protocol.
[[nodiscard]] std::vector<Offence> meteringOffences(const std::filesystem::path& root);

/// Violations of the same two rules in the CMakeLists.txt files of core and ui.
[[nodiscard]] std::vector<Offence> linkOffences(const std::filesystem::path& root);

/// Files and folders that do not belong at the top of the tree; build folders and dot-files are allowed.
[[nodiscard]] std::vector<Offence> topLevelOffences(const std::filesystem::path& root);

/// Errors in README, CONTRIBUTING and the pages of docs: lines of more than 120 characters (without URLs), a README of more than
/// 90 lines, links to files that do not exist. Links in resources/help are checked too. The help window contains only docs and
/// resources/help, so a link from there to any other file is a violation. C++ blocks whose first line names a file, as in
/// "// core/visibility/strategy.h", that are not that file.
[[nodiscard]] std::vector<Offence> pageOffences(const std::filesystem::path& root);

/// Aliases within a function that another source of the same library declares for its file. Sources are compiled a dozen at a
/// time, and a new file moves them: Clang then takes the one for hidden by the other, and stops.
[[nodiscard]] std::vector<Offence> aliasOffences(const std::filesystem::path& root);

/// Uses of what Clang 14 does not compile of GCC 12's library: sub-ranges, the algorithms of `std::ranges` that return
/// one, and views. GCC builds them, so that only the sanitizers' build, a quarter of an hour later, would stop at them.
[[nodiscard]] std::vector<Offence> rangesOffences(const std::filesystem::path& root);

/// Sources of more than 350 lines: they are split by subject.
[[nodiscard]] std::vector<Offence> longSourceOffences(const std::filesystem::path& root);

}  // namespace cullscope::rules
