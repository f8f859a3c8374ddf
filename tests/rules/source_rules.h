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
    std::string name;  ///< what stands between the quotes or the angle brackets
    bool quoted = false;
};

/// Every `#include` of the .h and .cpp files below the given folders of `root`, files in alphabetical order.
[[nodiscard]] std::vector<Include> includesBelow(const std::filesystem::path& root, const std::vector<std::string>& folders);

/// A place that breaks a rule.
struct Offence {
    std::filesystem::path file;  ///< relative to the tree's root
    int line = 0;                ///< 0: the file or folder as a whole
    std::string what;

    bool operator==(const Offence&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Offence& offence);

/// The layers of core, from the ground up.
[[nodiscard]] const std::vector<std::string>& layers();

/// The folders of ui, from the ground up.
[[nodiscard]] const std::vector<std::string>& uiFolders();

/// Includes that point down the list of layers or of ui's folders, from core to ui or app, or from ui to app; folders of core and
/// ui that stand in neither list.
[[nodiscard]] std::vector<Offence> layeringOffences(const std::filesystem::path& root);

/// Includes of a family's headers (core/visibility/FAMILY) by another family, by the contract that all share, and by what
/// stands above: only the registry, the experiments and ui/families may know families. Sources of a family outside its namespace.
/// `stillKnowFamilies`: files that do today; one that does not any more is an offence, so that the list only gets shorter.
[[nodiscard]] std::vector<Offence> familyOffences(const std::filesystem::path& root,
                                                  const std::vector<std::string>& stillKnowFamilies = {});

/// Includes of Qt in core or in cullbench, of OpenGL outside core/gpu, and of OpenMesh outside core/mesh.
[[nodiscard]] std::vector<Offence> libraryOffences(const std::filesystem::path& root);

/// The same two rules in what the CMakeLists.txt files of core and ui name.
[[nodiscard]] std::vector<Offence> linkOffences(const std::filesystem::path& root);

/// Files and folders at the top of the tree that have no place there; build folders and dot-files may be there.
[[nodiscard]] std::vector<Offence> topLevelOffences(const std::filesystem::path& root);

/// What is wrong with README, CONTRIBUTING and the pages of docs: lines of more than 120 characters (addresses of the web apart),
/// a README of more than 90 lines, links to files that are not there. Links are read in resources/help, too. The help window has
/// docs and resources/help alone: a link of theirs to anything else is an offence.
[[nodiscard]] std::vector<Offence> pageOffences(const std::filesystem::path& root);

}  // namespace cullscope::rules
