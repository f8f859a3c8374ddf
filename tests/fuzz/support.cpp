#include "tests/fuzz/support.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "core/mesh/load.h"
#include "core/scene/scene_source.h"
#include "tests/support/sound_mesh.h"

namespace cullscope::fuzz {
namespace {

/// A folder that goes with the process.
class Scratch {
public:
    Scratch() {
        std::string pattern = (std::filesystem::temp_directory_path() / "cullscope-fuzz-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no scratch folder: " + pattern);
        m_folder = pattern;
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }

private:
    std::filesystem::path m_folder;
};

bool finite(const Vec3& point) { return std::isfinite(glm::dot(point, Vec3(1.0))); }

}  // namespace

void require(bool holds, const char* what) {
    if (!holds) throw std::logic_error(what);
}

bool accepted(std::initializer_list<ErrorKind> kinds, const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const Error& error) {
        const bool expected = std::find(kinds.begin(), kinds.end(), error.kind()) != kinds.end();
        if (!expected) throw std::logic_error(std::string("refused by an error of another kind: ") + error.what());
        require(!error.message().empty(), "refused without a sentence");
        return false;
    }
}

bool acceptedFile(const std::filesystem::path& file, const std::function<void()>& work) {
    return accepted({ErrorKind::Input}, [&] {
        try {
            work();
        } catch (const Error& error) {
            const std::string sentence = error.what();
            const bool good = sentence.find(file.filename().string()) != std::string::npos && sentence.ends_with('.') &&
                              sentence.find('\n') == std::string::npos;
            if (!good) throw std::logic_error("the sentence is not one line that names the file: " + sentence);
            throw;
        }
    });
}

const std::filesystem::path& scratchFolder() {
    static const Scratch kScratch;
    return kScratch.folder();
}

std::filesystem::path fileOf(std::string_view content, const std::string& name) {
    const std::filesystem::path file = scratchFolder() / name;
    std::ofstream(file, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
    return file;
}

void readMeshFile(std::string_view content, const std::string& name) {
    const std::filesystem::path file = fileOf(content, name);
    acceptedFile(file, [&] {
        LoadOptions options;
        options.memoryLimitBytes = kMemory;
        require(test::isSound(loadMeshFile(file, options)), "a mesh that was read is not sound");
    });
}

void readSceneFile(std::string_view content, const std::string& name, const std::function<void(const Scene& scene)>& check) {
    const std::filesystem::path file = fileOf(content, name);
    acceptedFile(file, [&] {
        SceneSourceOptions options;
        options.load.memoryLimitBytes = kMemory;
        const ScenePointer scene = openScene(file.string(), options).scene;
        requireSound(*scene);
        check(*scene);
    });
}

void requireSound(const Scene& scene) {
    for (const MeshPointer& mesh : scene.meshes())
        require(mesh->triangleCount() == 0 || test::isSound(*mesh), "a mesh of the scene is not sound");
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        require(scene.instances()[i].mesh < scene.meshes().size(), "an instance has no mesh");
        const Mat4& place = scene.instances()[i].worldFromMesh;
        for (int column = 0; column < 4; ++column) require(finite(Vec3(place[column])), "an instance's place is not finite");
        if (scene.meshOf(i).triangleCount() > 0) require(finite(scene.instanceBox(i).min), "an instance's box is not finite");
    }
    require(std::isfinite(scene.boundingSphere().radius), "the scene's bounding sphere is not finite");
}

}  // namespace cullscope::fuzz
