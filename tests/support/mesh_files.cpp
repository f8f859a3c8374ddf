#include "tests/support/mesh_files.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "core/base/error.h"

namespace cullscope::test {
namespace {

constexpr rlim_t kChildMemory = rlim_t{2} << 30;

void limitMemory() {
#ifndef CULLSCOPE_SANITIZED
    const rlimit limit{kChildMemory, kChildMemory};
    setrlimit(RLIMIT_AS, &limit);
#endif
}

bool isSound(const TriangleMesh& mesh) {
    if (mesh.triangleCount() == 0 || mesh.normals().size() != mesh.vertexCount()) return false;
    for (const uint32_t index : mesh.indices())
        if (index >= mesh.vertexCount()) return false;
    for (size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        const double length = glm::length(Vec3(mesh.normals()[vertex]));
        if (!std::isfinite(glm::dot(mesh.position(vertex), Vec3(1.0))) || std::abs(length - 1.0) > 1e-3) return false;
    }
    return std::isfinite(mesh.localSphere().radius) && mesh.topology().boundaryEdges < 3 * mesh.triangleCount() + 1;
}

bool isSound(const LoadedFile& file) {
    size_t triangles = 0;
    for (const LoadedObject& object : file.objects) {
        if (object.name.empty() || !isSound(*object.mesh)) return false;
        triangles += object.mesh->triangleCount();
    }
    return triangles > 0 && triangles == file.report.trianglesMade && file.sha256.size() == 64;
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
