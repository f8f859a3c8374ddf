#include <unistd.h>

#include <fstream>
#include <regex>
#include <stdexcept>

#include "tests/rules/debian_packages.h"
#include "tests/rules/programs.h"
#include "tests/rules/source_rules.h"

namespace cullscope::rules::packages_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A simulated system of a few packages in a temporary folder, and a package list.
class PlantedSystem : public testing::Test {
protected:
    PlantedSystem() : m_folder(fs::temp_directory_path() / ("cullscope packages " + std::to_string(getpid()))) {
        fs::create_directories(m_folder / "info");
        package("libmesh-dev", "libmesh1 (= 2.0-1), libmath-dev | libmath-abi",
                {"/usr/include/mesh/mesh.h", "/usr/lib/libmesh.so"});
        package("libmesh1:amd64", "libc6 (>= 2.34), virtual-deep", {"/usr/lib/libmesh.so.1"});
        package("libmath-dev", "", {"/usr/include/math3d.h"});
        package("libdeep1", "", {"/usr/lib/libdeep.so.1"}, "virtual-deep (= 1), other-name");
        package("libstray-dev", "libstray1", {"/usr/include/stray.h"});
        package("libstray1", "", {"/lib/libstray.so.1"});
        package("libc6", "", {"/lib/libc.so.6"});
        std::ofstream(m_folder / "status", std::ios::app) << "Package: libgone-dev\nStatus: deinstall ok config-files\n\n";
        std::ofstream(m_folder / "info/libgone-dev.list") << "/usr/include/gone.h\n";
    }
    ~PlantedSystem() override {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }

    void package(const std::string& nameAndArchitecture, const std::string& depends, const std::vector<std::string>& files,
                 const std::string& provides = "") const {
        const std::string name = nameAndArchitecture.substr(0, nameAndArchitecture.find(':'));
        std::ofstream status(m_folder / "status", std::ios::app);
        status << "Package: " << name << "\nStatus: install ok installed\n";
        if (!provides.empty()) status << "Provides: " << provides << "\n";
        if (!depends.empty()) status << "Depends: " << depends << "\n";
        status << "Description: words\n Depends: no field\n\n";
        std::ofstream list(m_folder / "info" / (nameAndArchitecture + ".list"));
        for (const std::string& file : files) list << file << "\n";
    }
    [[nodiscard]] PackageDatabase database() const { return PackageDatabase(m_folder); }
    [[nodiscard]] fs::path write(const std::string& text) const {
        std::ofstream(m_folder / "list.txt") << text;
        return m_folder / "list.txt";
    }

private:
    fs::path m_folder;
};

TEST_F(PlantedSystem, sectionedListIsRead) {
    const PackageList list =
        readPackageList(write("# words\n\n# [build] programs\ng++   compiles\n# [run] data\nlibmesh-dev  meshes\n"));
    EXPECT_EQ(list, (PackageList{{"build", {"g++"}}, {"run", {"libmesh-dev"}}}));
}

TEST_F(PlantedSystem, packageTwiceOrWithoutReasonOrSectionIsRefused) {
    EXPECT_THROW((void)readPackageList(write("# [build] programs\ng++  compiles\ng++  again\n")), std::runtime_error);
    EXPECT_THROW((void)readPackageList(write("# [build] programs\ng++\n")), std::runtime_error);
    EXPECT_THROW((void)readPackageList(write("g++  before any section\n")), std::runtime_error);
}

TEST_F(PlantedSystem, ownersAndDependenciesAreFound) {
    const PackageDatabase system = database();
    EXPECT_EQ(system.owner("/usr/include/mesh/mesh.h"), "libmesh-dev");
    EXPECT_EQ(system.owner("/usr/lib/libstray.so.1"), "libstray1");
    EXPECT_EQ(system.owner("/usr/include/gone.h"), std::nullopt);
    EXPECT_THAT(system.dependencies("libmesh-dev"), UnorderedElementsAre("libmesh1", "libmath-dev"));
    EXPECT_THAT(system.closure({"libmesh-dev"}),
                UnorderedElementsAre("libmesh-dev", "libmesh1", "libmath-dev", "libdeep1", "libc6"));
}

TEST_F(PlantedSystem, useOfAnUnlistedPackageIsReported) {
    const std::vector<Use> uses = {{"/usr/include/mesh/mesh.h", "a.cpp"},
                                   {"/usr/include/math3d.h", "a.cpp"},
                                   {"/usr/lib/libmesh.so.1", "tool"},
                                   {"/lib/libc.so.6", "tool"}};
    EXPECT_THAT(unlistedUses({"libmesh-dev"}, database(), uses), IsEmpty());
    EXPECT_THAT(
        unlistedUses({"libmesh-dev"}, database(), {{"/usr/include/stray.h", "b.cpp"}}),
        ElementsAre("b.cpp uses /usr/include/stray.h of the package libstray-dev, which packaging/packages.txt does not list"));
    EXPECT_EQ(unlistedUses({"libmesh-dev"}, database(), {{"/usr/lib/libdeep.so.1", "tool"}}).size(), 1u);
    EXPECT_EQ(unlistedUses({"libmesh-dev"}, database(), {{"/usr/include/gone.h", "b.cpp"}}).size(), 1u);
}

TEST_F(PlantedSystem, useOfAPackageThatWouldNotBeInstalledIsReported) {
    EXPECT_THAT(usesOutsideClosure({"libmesh-dev"}, database(), {{"/usr/lib/libdeep.so.1", "tool"}}), IsEmpty());
    EXPECT_EQ(usesOutsideClosure({"libmesh-dev"}, database(), {{"/usr/include/stray.h", "the build"}}).size(), 1u);
}

TEST_F(PlantedSystem, packageThatNothingUsesIsReported) {
    const std::vector<std::string> listed = {"libmesh-dev", "libstray-dev", "glmark2-data"};
    EXPECT_THAT(unusedPackages(listed, database(), {{"/usr/lib/libmesh.so.1", "tool"}}), ElementsAre("libstray-dev"));
    EXPECT_THAT(unusedPackages(listed, database(), {{"/usr/include/stray.h", "a.cpp"}}), ElementsAre("libmesh-dev"));
}

const fs::path kProject = CULLSCOPE_SOURCE_DIR;
const fs::path kBuild = CULLSCOPE_BINARY_DIR;
const fs::path kModules = kBuild / "lib/cullscope";
const fs::path kDpkg = "/var/lib/dpkg";

/// The include folders for angle brackets, with those of Qt, which CMake adds.
std::vector<fs::path> includeFolders() {
    const std::string architecture = CULLSCOPE_LIBRARY_ARCHITECTURE;
    // FreeType's headers lie in a folder of their own, which its CMake module adds.
    std::vector<fs::path> folders = {"/usr/include", "/usr/include/" + architecture, "/usr/include/freetype2"};
    for (const fs::path& parent : {fs::path("/usr/include/c++"), fs::path("/usr/include") / architecture / "qt6",
                                   fs::path("/usr/lib/gcc") / architecture}) {
        folders.push_back(parent);
        if (!fs::is_directory(parent)) continue;
        for (const fs::directory_entry& entry : fs::directory_iterator(parent)) {
            folders.push_back(entry.path());
            folders.push_back(entry.path() / "include");
        }
    }
    return folders;
}

/// The file that an include in angle brackets refers to; empty where there is none.
fs::path resolved(const std::string& name) {
    static const std::vector<fs::path> kFolders = includeFolders();
    for (const fs::path& folder : kFolders) {
        if (fs::is_regular_file(folder / name)) return folder / name;
    }
    return {};
}

/// The headers and libraries that the project's sources and built programs use directly.
struct DirectUses {
    std::vector<Use> headers;
    std::vector<Use> libraries;
    std::vector<std::string> unresolved;  ///< includes whose file was not found
};

DirectUses directUses() {
    DirectUses uses;
    for (const Include& include : includesBelow(kProject, {"core", "ui", "app", "tests"})) {
        if (include.quoted) continue;
        const fs::path file = resolved(include.name);
        const std::string place = include.file.string() + ":" + std::to_string(include.line);
        if (file.empty()) {
            uses.unresolved.push_back(place + " includes <" + include.name + ">, which is nowhere");
        } else {
            uses.headers.push_back({file, place});
        }
    }
    for (const fs::path& folder : {kBuild / "bin", kModules})
        for (const fs::path& program : programsIn(folder))
            for (const fs::path& library : neededLibraries(program))
                uses.libraries.push_back({library, program.filename().string()});
    return uses;
}

/// The CMake modules that the configured build found.
std::vector<Use> modulesFound(const fs::path& buildFolder) {
    static const std::regex kFolder(R"(^(\w+)_DIR:PATH=(/usr/.*)$)");
    std::vector<Use> modules;
    std::ifstream cache(buildFolder / "CMakeCache.txt");
    std::string line;
    while (std::getline(cache, line)) {
        std::smatch match;
        if (std::regex_match(line, match, kFolder))
            modules.push_back({match[2].str() + "/" + match[1].str() + "Config.cmake", "CMake"});
    }
    return modules;
}

std::vector<Use> all(const DirectUses& uses) {
    std::vector<Use> joined = uses.headers;
    joined.insert(joined.end(), uses.libraries.begin(), uses.libraries.end());
    return joined;
}

/// The package list, checked against the system that the project was built on.
class Packages : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(kDpkg / "status")) FAIL() << "no Debian system: the list is Debian's";
    }
    const PackageList list = readPackageList(kProject / "packaging/packages.txt");
};

TEST_F(Packages, listHasTheSectionsThatTheScriptsName) {
    for (const char* section : {"build", "libraries", "desktop", "modules", "run", "tests", "clang", "slurm", "deb"})
        EXPECT_TRUE(list.contains(section)) << section;
}

TEST_F(Packages, sourcesAndProgramsUseListedPackagesOnly) {
    const DirectUses uses = directUses();
    EXPECT_THAT(uses.unresolved, IsEmpty());
    EXPECT_GT(uses.headers.size(), 100u);
    EXPECT_GT(uses.libraries.size(), 10u);
    EXPECT_THAT(unlistedUses(namesOf(list), PackageDatabase(kDpkg), all(uses)), IsEmpty());
}

TEST_F(Packages, everyHeaderThatTheBuildReadComesWithTheList) {
    if (!fs::exists(kBuild / "build.ninja")) FAIL() << "not built by Ninja, as the presets do";
    std::vector<Use> uses;
    for (const fs::path& header : headersReadByBuild(kBuild)) uses.push_back({header, "the build"});
    EXPECT_GT(uses.size(), 500u);
    EXPECT_THAT(usesOutsideClosure(namesOf(list), PackageDatabase(kDpkg), uses), IsEmpty());
}

TEST_F(Packages, everyListedLibraryIsUsed) {
    const PackageDatabase database(kDpkg);
    const std::vector<Use> uses = all(directUses());
    // [build], [clang] and [deb] list programs and CMake modules, among them development packages that are no libraries.
    for (const char* section : {"libraries", "desktop", "tests"}) {
        EXPECT_THAT(unusedPackages(list.at(section), database, uses), IsEmpty()) << "in section " << section;
    }
}

TEST_F(Packages, everyListedModuleIsAskedForByCMake) {
    EXPECT_THAT(unusedPackages(list.at("modules"), PackageDatabase(kDpkg), modulesFound(kBuild)), IsEmpty());
}

/// The libraries of a program that belong to Qt.
std::vector<std::string> qtLibraries(const fs::path& program) {
    std::vector<std::string> qt;
    for (const std::string& library : loadedLibraries(program)) {
        if (library.starts_with("libQt")) qt.push_back(library);
    }
    return qt;
}

TEST(Programs, qtOfTheDesktopIsSeen) {
    EXPECT_THAT(qtLibraries(CULLSCOPE_DESKTOP_PROGRAM), Contains(HasSubstr("libQt6Widgets")));
}
TEST(Programs, cullbenchLoadsNoQt) {
    EXPECT_THAT(qtLibraries(CULLSCOPE_BENCH_PROGRAM), IsEmpty());
    EXPECT_THAT(qtLibraries(kModules / "picture_formats.so"), IsEmpty());
}
// They take a quarter of a second to load.
TEST(Programs, librariesOfPictureFormatsAreLoadedByTheirModuleAlone) {
    const auto hasSubject = Contains(HasSubstr("libOpenImageIO"));
    EXPECT_THAT(loadedLibraries(kModules / "picture_formats.so"), hasSubject);
    EXPECT_THAT(loadedLibraries(CULLSCOPE_BENCH_PROGRAM), testing::Not(hasSubject));
    EXPECT_THAT(loadedLibraries(CULLSCOPE_DESKTOP_PROGRAM), testing::Not(hasSubject));
}

}  // namespace
}  // namespace cullscope::rules::packages_test
