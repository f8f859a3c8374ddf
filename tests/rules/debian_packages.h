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

/// Throws std::runtime_error naming a line that is neither a comment nor a package with its reason, or that repeats a package.
[[nodiscard]] PackageList readPackageList(const std::filesystem::path& file);

/// All packages of a list.
[[nodiscard]] std::set<std::string> namesOf(const PackageList& list);

/// The installed packages of a Debian system: the owner of each file, and the dependencies of each package.
class PackageDatabase {
public:
    /// `folder` is /var/lib/dpkg or a folder with a `status` file and `info/*.list` files like those there.
    explicit PackageDatabase(const std::filesystem::path& folder);

    [[nodiscard]] bool installed(const std::string& package) const { return m_depends.contains(package); }
    /// The package that a header or library belongs to, also by its path before /lib became a link to /usr/lib.
    [[nodiscard]] std::optional<std::string> owner(const std::filesystem::path& file) const;
    /// The direct dependencies of a package, with alternatives and virtual names resolved to installed packages.
    [[nodiscard]] std::set<std::string> dependencies(const std::string& package) const;
    /// The packages and all their dependencies, direct and indirect.
    [[nodiscard]] std::set<std::string> closure(const std::set<std::string>& packages) const;

private:
    void readStatus(const std::filesystem::path& file);
    void readFiles(const std::filesystem::path& list);
    [[nodiscard]] std::optional<std::string> ownerOfName(const std::string& file) const;

    std::map<std::string, std::vector<std::string>> m_depends;  ///< of installed packages: names as written in `status`
    std::map<std::string, std::set<std::string>> m_providers;   ///< of virtual names
    std::unordered_map<std::string, std::string> m_owners;      ///< packages of headers and libraries, by path
};

/// A header or a shared library, and the file that uses it.
struct Use {
    std::filesystem::path file;
    std::string user;
    bool operator<(const Use& other) const { return file < other.file; }
};

/// One sentence for each use of a file that belongs to no package, or to one that is neither listed, nor a direct dependency of a
/// listed development package, nor part of the compiler.
[[nodiscard]] std::vector<std::string> unlistedUses(const std::set<std::string>& listed, const PackageDatabase& database,
                                                    const std::vector<Use>& uses);

/// One sentence for each use of a file that belongs to no package, or to one that would be missing if only the listed ones were
/// installed.
[[nodiscard]] std::vector<std::string> usesOutsideClosure(const std::set<std::string>& listed, const PackageDatabase& database,
                                                          const std::vector<Use>& uses);

/// The development packages in `listed` of which no header and no library is used.
[[nodiscard]] std::vector<std::string> unusedPackages(const std::vector<std::string>& listed, const PackageDatabase& database,
                                                      const std::vector<Use>& uses);

}  // namespace cullscope::rules
