#include "tests/support/mesh_files.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/sound_mesh.h"

namespace cullscope::test {
namespace {

constexpr rlim_t kChildMemory = rlim_t{2} << 30;

void limitMemory() {
#ifndef CULLSCOPE_SANITIZED
    const rlimit limit{kChildMemory, kChildMemory};
    setrlimit(RLIMIT_AS, &limit);
#endif
}

}  // namespace

MeshFiles::MeshFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "cullscope-mesh-XXXXXX").string();
    m_folder = mkdtemp(pattern.data());
}

MeshFiles::~MeshFiles() { std::filesystem::remove_all(m_folder); }

std::filesystem::path MeshFiles::write(const std::string& name, std::string_view bytes) const {
    std::ofstream(m_folder / name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return m_folder / name;
}

std::string MeshFiles::refusal(const std::string& name, std::string_view bytes) const { return refusalOf(write(name, bytes)); }

std::string refusalOf(const std::filesystem::path& path) {
    try {
        (void)loadMeshFile(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        EXPECT_THAT(error.what(), testing::HasSubstr(path.filename().string()));
        return error.what();
    }
    ADD_FAILURE() << path << " was not refused";
    return {};
}

Outcome tryLoading(const std::filesystem::path& path) {
    try {
        if (isSound(loadMeshFile(path))) return Outcome::Loaded;
        std::fprintf(stderr, "%s: the mesh is not sound\n", path.c_str());
        return Outcome::Wrong;
    } catch (const Error& error) {
        const std::string sentence = error.what();
        const bool good = error.kind() == ErrorKind::Input && sentence.find(path.filename().string()) != std::string::npos &&
                          sentence.back() == '.' && sentence.find('\n') == std::string::npos;
        if (!good) std::fprintf(stderr, "%s: refused with \"%s\"\n", path.c_str(), sentence.c_str());
        return good ? Outcome::Refused : Outcome::Wrong;
    } catch (const std::exception& other) {
        std::fprintf(stderr, "%s: %s\n", path.c_str(), other.what());
        return Outcome::Wrong;
    }
}

bool succeedsInChild(const std::function<bool()>& work, unsigned seconds) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        limitMemory();
        alarm(seconds);
        _exit(work() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::vector<Outcome> loadInChild(const std::vector<std::filesystem::path>& files, unsigned seconds) {
    const size_t bytes = std::max<size_t>(1, files.size()) * sizeof(Outcome);
    auto* shared = static_cast<Outcome*>(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    std::fill_n(shared, files.size(), Outcome::Wrong);
    const bool ended = succeedsInChild(
        [&] {
            for (size_t i = 0; i < files.size(); ++i) shared[i] = tryLoading(files[i]);
            return true;
        },
        seconds);
    EXPECT_TRUE(ended) << "crashed or took longer than " << seconds << " s";
    const std::vector<Outcome> outcomes(shared, shared + files.size());
    munmap(shared, bytes);
    return outcomes;
}

}  // namespace cullscope::test
