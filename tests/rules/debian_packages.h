#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace cullscope::rules {

/// packaging/packages.txt: package names by section.
using PackageList = std::map<std::string, std::vector<std::string>>;

/// Throws std::runtime_error naming the line that is neither a comment nor a package with its reason, or that names a package
/// twice.
[[nodiscard]] PackageList readPackageList(const std::filesystem::path& file);

/// All packages of a list.
[[nodiscard]] std::set<std::string> namesOf(const PackageList& list);

/// The installed packages of a Debian system: which file is whose, and who depends on whom.
class PackageDatabase {
public:
    /// `folder` is /var/lib/dpkg or a folder with a `status` file and `info/*.list` files like those there.
    explicit PackageDatabase(const std::filesystem::path& folder);

    [[nodiscard]] bool installed(const std::string& package) const { return m_depends.contains(package); }
    /// The package that a header or library belongs to, also by its path before /lib became a link to /usr/lib.
    [[nodiscard]] std::optional<std::string> owner(const std::filesystem::path& file) const;
    /// What a package depends upon directly, alternatives and provided names resolved to what is installed.
    [[nodiscard]] std::set<std::string> dependencies(const std::string& package) const;
    /// The packages and all that they depend upon, directly or not.
    [[nodiscard]] std::set<std::string> closure(const std::set<std::string>& packages) const;

private:
    void readStatus(const std::filesystem::path& file);
    void readFiles(const std::filesystem::path& list);
    [[nodiscard]] std::optional<std::string> ownerOfName(const std::string& file) const;

    std::map<std::string, std::vector<std::string>> m_depends;  ///< of installed packages: names as written
    std::map<std::string, std::set<std::string>> m_providers;   ///< of names that are no packages themselves
    std::unordered_map<std::string, std::string> m_owners;      ///< headers and libraries by path
};

/// A header or a shared library and who uses it.
struct Use {
    std::filesystem::path file;
    std::string user;
    bool operator<(const Use& other) const { return file < other.file; }
};

/// Uses of what belongs to no package, or to one that neither is listed nor comes directly with a listed development package
/// nor with the compiler; a sentence each.
[[nodiscard]] std::vector<std::string> unlistedUses(const std::set<std::string>& listed, const PackageDatabase& database,
                                                    const std::vector<Use>& uses);

/// Uses of what belongs to no package, or to one that would not be there if only the listed ones were installed; a sentence each.
[[nodiscard]] std::vector<std::string> usesOutsideClosure(const std::set<std::string>& listed, const PackageDatabase& database,
                                                          const std::vector<Use>& uses);

/// The development packages among `listed` of which neither a header nor a library is used.
[[nodiscard]] std::vector<std::string> unusedPackages(const std::vector<std::string>& listed, const PackageDatabase& database,
                                                      const std::vector<Use>& uses);

}  // namespace cullscope::rules
