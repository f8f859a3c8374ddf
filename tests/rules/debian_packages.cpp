#include "tests/rules/debian_packages.h"

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

bool isDevelopment(const std::string& package) { return package.ends_with("-dev"); }

/// Whether a package is the compiler, one of its libraries or the C library.
bool isToolchain(const std::string& package) {
    static const std::regex kToolchain(
        R"(gcc-\d+|libgcc-(s1|\d+-dev)|libstdc\+\+(6|-\d+-dev)|libc6(-dev)?|linux-libc-dev|libclang-common-\d+-dev)");
    return std::regex_match(package, kToolchain);
}

/// "libfoo1 (>= 2.0) | libbar:any" → "libfoo1", "libbar".
std::vector<std::string> namesIn(const std::string& relations) {
    static const std::regex kName(R"((?:^|[,|])\s*([a-z0-9][a-z0-9+.-]*))");
    std::vector<std::string> names;
    for (std::sregex_iterator match(relations.begin(), relations.end(), kName), end; match != end; ++match)
        names.push_back((*match)[1]);
    return names;
}

std::string sentence(const Use& use, const std::string& what) { return use.user + " uses " + use.file.string() + what; }

/// A sentence for each use whose owner is not among `allowed`.
std::vector<std::string> usesOutside(const std::set<std::string>& allowed, const PackageDatabase& database,
                                     const std::vector<Use>& uses, const std::string& because) {
    std::vector<std::string> wrong;
    for (const Use& use : uses) {
        const std::optional<std::string> owner = database.owner(use.file);
        if (!owner) {
            wrong.push_back(sentence(use, ", which belongs to no Debian package"));
        } else if (!allowed.contains(*owner) && !isToolchain(*owner)) {
            wrong.push_back(sentence(use, " of the package " + *owner + ", " + because));
        }
    }
    return wrong;
}

}  // namespace

PackageList readPackageList(const fs::path& file) {
    static const std::regex kSection(R"(^# \[([a-z]+)\] .+)");
    static const std::regex kPackage(R"(^([a-z0-9][a-z0-9+.-]+) +\S.*)");
    PackageList list;
    std::set<std::string> seen;
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    std::string section;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        std::smatch match;
        if (std::regex_match(line, match, kSection)) {
            section = match[1];
            list[section];
        } else if (std::regex_match(line, match, kPackage) && !section.empty()) {
            if (!seen.insert(match[1]).second)
                throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": listed twice: " + match[1].str());
            list[section].push_back(match[1]);
        } else if (!line.empty() && line[0] != '#') {
            throw std::runtime_error(file.string() + ":" + std::to_string(number) +
                                     ": neither a comment nor a package and its reason");
        }
    }
    return list;
}

std::set<std::string> namesOf(const PackageList& list) {
    std::set<std::string> names;
    for (const auto& [section, packages] : list) names.insert(packages.begin(), packages.end());
    return names;
}

PackageDatabase::PackageDatabase(const fs::path& folder) {
    readStatus(folder / "status");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "info")) {
        if (entry.path().extension() == ".list") readFiles(entry.path());
    }
}

void PackageDatabase::readStatus(const fs::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    std::string package;
    std::string line;
    while (std::getline(stream, line)) {
        const size_t colon = line.find(": ");
        if (colon == std::string::npos) continue;
        const std::string field = line.substr(0, colon);
        const std::string value = line.substr(colon + 2);
        if (field == "Package") package = value;
        if (field == "Status" && value == "install ok installed") m_depends[package];
        if (!m_depends.contains(package)) continue;
        if (field == "Depends" || field == "Pre-Depends") {
            for (const std::string& name : namesIn(value)) m_depends[package].push_back(name);
        } else if (field == "Provides") {
            for (const std::string& name : namesIn(value)) m_providers[name].insert(package);
        }
    }
}

void PackageDatabase::readFiles(const fs::path& list) {
    const std::string stem = list.stem().string();
    const std::string package = stem.substr(0, stem.find(':'));
    if (!installed(package)) return;
    std::ifstream stream(list);
    std::string file;
    while (std::getline(stream, file)) {
        if (file.starts_with("/usr/include/") || file.starts_with("/usr/lib/") || file.starts_with("/lib"))
            m_owners[file] = package;
    }
}

std::optional<std::string> PackageDatabase::ownerOfName(const std::string& file) const {
    const std::string other = file.starts_with("/usr/") ? file.substr(4) : "/usr" + file;
    for (const std::string& name : {file, other}) {
        const auto found = m_owners.find(name);
        if (found != m_owners.end()) return found->second;
    }
    return std::nullopt;
}

std::optional<std::string> PackageDatabase::owner(const fs::path& file) const {
    if (const std::optional<std::string> named = ownerOfName(file.lexically_normal().string())) return named;
    std::error_code unresolved;
    const fs::path real = fs::canonical(file, unresolved);
    return unresolved ? std::nullopt : ownerOfName(real.string());
}

std::set<std::string> PackageDatabase::dependencies(const std::string& package) const {
    std::set<std::string> found;
    const auto entry = m_depends.find(package);
    if (entry == m_depends.end()) return found;
    for (const std::string& name : entry->second) {
        if (installed(name)) found.insert(name);
        const auto providers = m_providers.find(name);
        if (providers != m_providers.end()) found.insert(providers->second.begin(), providers->second.end());
    }
    return found;
}

std::set<std::string> PackageDatabase::closure(const std::set<std::string>& packages) const {
    std::set<std::string> all;
    std::vector<std::string> pending(packages.begin(), packages.end());
    while (!pending.empty()) {
        const std::string package = pending.back();
        pending.pop_back();
        if (!all.insert(package).second) continue;
        for (const std::string& next : dependencies(package)) pending.push_back(next);
    }
    return all;
}

std::vector<std::string> unlistedUses(const std::set<std::string>& listed, const PackageDatabase& database,
                                      const std::vector<Use>& uses) {
    std::set<std::string> allowed = listed;
    for (const std::string& package : listed) {
        if (isDevelopment(package)) allowed.merge(database.dependencies(package));
    }
    return usesOutside(allowed, database, uses, "which packaging/packages.txt does not list");
}

std::vector<std::string> usesOutsideClosure(const std::set<std::string>& listed, const PackageDatabase& database,
                                            const std::vector<Use>& uses) {
    return usesOutside(database.closure(listed), database, uses,
                       "which does not come with any that packaging/packages.txt lists");
}

std::vector<std::string> unusedPackages(const std::vector<std::string>& listed, const PackageDatabase& database,
                                        const std::vector<Use>& uses) {
    std::set<std::string> owners;
    for (const Use& use : uses) owners.insert(database.owner(use.file).value_or(""));
    std::vector<std::string> unused;
    for (const std::string& package : listed) {
        if (!isDevelopment(package)) continue;
        bool used = owners.contains(package);
        // A runtime library counts for the development package of the same source that depends on it.
        for (const std::string& runtime : database.dependencies(package))
            used = used || (!isDevelopment(runtime) && owners.contains(runtime));
        if (!used) unused.push_back(package);
    }
    return unused;
}

}  // namespace cullscope::rules
