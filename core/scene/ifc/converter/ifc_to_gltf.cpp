// Reads an IFC file from standard input and writes it as binary glTF to standard output, an object for each element of the
// building that has a surface. What was left out stands on standard error, a line each. The first argument is the memory that it
// may take, in bytes. A program of its own, because Assimp trusts what stands in a file: where it crashes, no window closes.
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr int kNotRead = 1, kTooLittleMemory = 2;

/// The warnings of the importer as lines.
class Warnings final : public Assimp::LogStream {
public:
    void write(const char* message) override { std::cerr << message; }
};

void limitMemory(const char* bytes) {
#ifdef CULLSCOPE_SANITIZED
    (void)bytes;  // the address sanitizer reserves terabytes
#else
    const rlim_t most = std::strtoull(bytes, nullptr, 10);
    const rlimit limit{most, most};
    if (most > 0) setrlimit(RLIMIT_AS, &limit);
#endif
}

bool hasTriangles(const aiMesh& mesh) { return (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0; }

/// The surfaces of several meshes as one: the importer makes a mesh for each material of an element.
std::unique_ptr<aiMesh> merged(const aiScene& scene, const std::vector<unsigned>& numbers) {
    auto mesh = std::make_unique<aiMesh>();
    for (const unsigned number : numbers) {
        mesh->mNumVertices += scene.mMeshes[number]->mNumVertices;
        mesh->mNumFaces += scene.mMeshes[number]->mNumFaces;
    }
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mVertices = new aiVector3D[mesh->mNumVertices];
    mesh->mFaces = new aiFace[mesh->mNumFaces];
    unsigned vertices = 0, faces = 0;
    for (const unsigned number : numbers) {
        const aiMesh& part = *scene.mMeshes[number];
        std::copy_n(part.mVertices, part.mNumVertices, mesh->mVertices + vertices);
        for (unsigned i = 0; i < part.mNumFaces; ++i) {
            aiFace& face = mesh->mFaces[faces++] = part.mFaces[i];
            for (unsigned corner = 0; corner < face.mNumIndices; ++corner) face.mIndices[corner] += vertices;
        }
        vertices += part.mNumVertices;
    }
    return mesh;
}

/// Gives each element one mesh, elements with the same meshes the same one, and each node with a surface the name of its element.
class ElementsOfScene {
public:
    explicit ElementsOfScene(aiScene& scene) : m_scene(scene) {}

    void unite() {
        visit(*m_scene.mRootNode, m_scene.mRootNode->mName);
        for (unsigned i = 0; i < m_scene.mNumMeshes; ++i) {
            if (!hasTriangles(*m_scene.mMeshes[i])) ++m_withoutSurface;
            delete m_scene.mMeshes[i];
        }
        delete[] std::exchange(m_scene.mMeshes, nullptr);
        m_scene.mNumMeshes = 0;
        m_scene.mMeshes = new aiMesh*[m_meshes.size()];
        for (std::unique_ptr<aiMesh>& mesh : m_meshes) m_scene.mMeshes[m_scene.mNumMeshes++] = mesh.release();
    }

    [[nodiscard]] unsigned withoutSurface() const { return m_withoutSurface; }
    [[nodiscard]] bool empty() const { return m_meshes.empty(); }

private:
    /// `element`: of the nearest node above that is one; relations and shapes that elements share are none.
    void visit(aiNode& node, aiString element) {
        const std::string name = node.mName.C_Str();
        if (!name.starts_with('$') && !name.starts_with("IfcMappedItem")) element = node.mName;
        std::vector<unsigned> surfaces;
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            if (hasTriangles(*m_scene.mMeshes[node.mMeshes[i]])) surfaces.push_back(node.mMeshes[i]);
        delete[] node.mMeshes;
        node.mMeshes = nullptr;
        node.mNumMeshes = 0;
        if (!surfaces.empty()) {
            std::sort(surfaces.begin(), surfaces.end());
            const auto [place, isNew] = m_numbers.try_emplace(surfaces, unsigned(m_meshes.size()));
            if (isNew) {
                m_meshes.push_back(merged(m_scene, surfaces));
                m_meshes.back()->mName = element;
            }
            node.mMeshes = new unsigned[1]{place->second};
            node.mNumMeshes = 1;
        }
        node.mName = nameOf(element.C_Str(), !surfaces.empty());
        for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], element);
    }

    /// The exporter has each name once and changes others. So what has no surface, such as the element of a mapped shape, takes
    /// no name from what has one.
    std::string nameOf(const std::string& element, bool hasSurface) {
        if (!hasSurface) return "$" + std::to_string(++m_withoutName);
        const unsigned number = ++m_named[element];
        return number == 1 ? element : element + " (" + std::to_string(number) + ")";
    }

    aiScene& m_scene;
    std::map<std::vector<unsigned>, unsigned> m_numbers;
    std::vector<std::unique_ptr<aiMesh>> m_meshes;
    std::map<std::string, unsigned> m_named;
    unsigned m_withoutSurface = 0, m_withoutName = 0;
};

int convert() {
    const std::string content(std::istreambuf_iterator<char>(std::cin), {});
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Warnings, Assimp::Logger::Warn);
    Assimp::Importer importer;
    importer.ReadFileFromMemory(content.data(), content.size(), aiProcess_Triangulate | aiProcess_SortByPType, "ifc");
    if (importer.GetException()) std::rethrow_exception(importer.GetException());
    const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
    if (!scene) {
        std::cerr << "error " << importer.GetErrorString() << '\n';
        return kNotRead;
    }
    ElementsOfScene elements(*scene);
    elements.unite();
    if (elements.empty()) {
        std::cerr << "error no element has a surface\n";
        return kNotRead;
    }
    if (elements.withoutSurface() > 0) std::cerr << "lines " << elements.withoutSurface() << '\n';
    Assimp::Exporter exporter;
    const aiExportDataBlob* const file = exporter.ExportToBlob(scene.get(), "glb2");
    if (file == nullptr) {
        std::cerr << "error " << exporter.GetErrorString() << '\n';
        return kNotRead;
    }
    std::cout.write(static_cast<const char*>(file->data), std::streamsize(file->size));
    std::cout.flush();
    return std::cout ? EXIT_SUCCESS : kTooLittleMemory;
}

}  // namespace

int main(int count, char** arguments) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // without the program that started it, its output has no reader
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);  // a file that makes Assimp crash is refused, and no error of this program
    if (count > 1) limitMemory(arguments[1]);
    try {
        return convert();
    } catch (const std::bad_alloc&) {
        return kTooLittleMemory;
    } catch (const std::exception& failure) {
        std::cerr << "error " << failure.what() << '\n';
        return kNotRead;
    }
}
