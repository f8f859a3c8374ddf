#include "core/mesh/save.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/terminal_text.h"
#include "core/mesh/load.h"
#include "core/mesh/steps.h"

namespace cullscope {
namespace {

constexpr size_t kFlushAt = size_t{1} << 16;

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// A buffered output that reports the written share as progress.
class Writer {
public:
    Writer(std::ostream& out, std::span<const PlacedMesh> meshes, const Progress& progress) : m_out(out), m_progress(progress) {
        for (const PlacedMesh& placed : meshes) m_total += placed.mesh->vertexCount() + placed.mesh->triangleCount();
    }

    fmt::memory_buffer& text() { return m_buffer; }
    template <typename Value>
    void binary(const Value& value) {
        const char* bytes = reinterpret_cast<const char*>(&value);
        m_buffer.append(bytes, bytes + sizeof(Value));
    }
    /// To be called after every vertex and triangle.
    void itemDone() {
        ++m_done;
        if (m_buffer.size() >= kFlushAt) flush();
    }
    void flush() {
        m_progress.check();
        m_out.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
        m_buffer.clear();
        m_progress.tell(m_total > 0 ? static_cast<double>(m_done) / static_cast<double>(m_total) : 1.0,
                        CULLSCOPE_TR("Writing the file"));
    }

private:
    std::ostream& m_out;
    const Progress& m_progress;
    fmt::memory_buffer m_buffer;
    size_t m_done = 0;
    size_t m_total = 0;
};

/// Positions and normals of a mesh in the world. For a mirroring transform the triangles are reversed, so that they still face
/// outward.
class World {
public:
    explicit World(const PlacedMesh& placed)
        : m_mesh(*placed.mesh),
          m_worldFromMesh(placed.worldFromMesh),
          m_normalMatrix(glm::transpose(glm::inverse(Mat3(placed.worldFromMesh)))),
          m_mirrored(glm::determinant(Mat3(placed.worldFromMesh)) < 0.0) {}

    [[nodiscard]] Vec3 position(size_t vertex) const {
        // An identity keeps every bit of a position; the product with a large origin would not.
        return m_worldFromMesh == Mat4(1.0) ? m_mesh.position(vertex)
                                            : Vec3(m_worldFromMesh * Vec4(m_mesh.position(vertex), 1.0));
    }
    [[nodiscard]] Vec3 normal(size_t vertex) const {
        const Vec3 normal = m_normalMatrix * Vec3(m_mesh.normals()[vertex]);
        const double length = glm::length(normal);
        return length > 0.0 && std::isfinite(length) ? normal / length : Vec3(m_mesh.normals()[vertex]);
    }
    [[nodiscard]] std::array<uint32_t, 3> triangle(size_t triangle) const {
        const std::span<const uint32_t> corner = m_mesh.indices().subspan(3 * triangle, 3);
        return {corner[0], corner[m_mirrored ? 2 : 1], corner[m_mirrored ? 1 : 2]};
    }

private:
    const TriangleMesh& m_mesh;
    Mat4 m_worldFromMesh;
    Mat3 m_normalMatrix;
    bool m_mirrored;
};

std::string objectName(const std::string& name) { return name.empty() ? "mesh" : plainName(name); }

void writeObj(Writer& out, std::span<const PlacedMesh> meshes) {
    uint64_t first = 1;
    for (const PlacedMesh& placed : meshes) {
        const World world(placed);
        fmt::format_to(std::back_inserter(out.text()), "o {}\n", objectName(placed.name));
        for (size_t vertex = 0; vertex < placed.mesh->vertexCount(); ++vertex) {
            const Vec3 p = world.position(vertex);
            const Vec3f n(world.normal(vertex));
            // The shortest decimal that reads back as the same number.
            fmt::format_to(std::back_inserter(out.text()), "v {} {} {}\nvn {} {} {}\n", p.x, p.y, p.z, n.x, n.y, n.z);
            out.itemDone();
        }
        for (size_t triangle = 0; triangle < placed.mesh->triangleCount(); ++triangle) {
            const auto [a, b, c] = world.triangle(triangle);
            fmt::format_to(std::back_inserter(out.text()), "f {0}//{0} {1}//{1} {2}//{2}\n", first + a, first + b, first + c);
            out.itemDone();
        }
        first += placed.mesh->vertexCount();
    }
}

void writePly(Writer& out, std::span<const PlacedMesh> meshes) {
    uint64_t vertices = 0;
    uint64_t triangles = 0;
    for (const PlacedMesh& placed : meshes) {
        vertices += placed.mesh->vertexCount();
        triangles += placed.mesh->triangleCount();
    }
    fmt::format_to(
        std::back_inserter(out.text()),
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face {}\nproperty list uchar uint "
        "vertex_indices\nend_header\n",
        vertices, triangles);
    for (const PlacedMesh& placed : meshes) {
        const World world(placed);
        for (size_t vertex = 0; vertex < placed.mesh->vertexCount(); ++vertex) {
            out.binary(world.position(vertex));
            out.binary(Vec3f(world.normal(vertex)));
            out.itemDone();
        }
    }
    uint32_t first = 0;
    for (const PlacedMesh& placed : meshes) {
        const World world(placed);
        for (size_t triangle = 0; triangle < placed.mesh->triangleCount(); ++triangle) {
            const auto [a, b, c] = world.triangle(triangle);
            out.binary(uint8_t{3});
            out.binary(std::array{first + a, first + b, first + c});
            out.itemDone();
        }
        first += static_cast<uint32_t>(placed.mesh->vertexCount());
    }
}

void writeStl(Writer& out, std::span<const PlacedMesh> meshes) {
    uint64_t triangles = 0;
    for (const PlacedMesh& placed : meshes) triangles += placed.mesh->triangleCount();
    std::array<char, 80> header{};
    std::strncpy(header.data(), "Binary STL written by Cullscope", header.size() - 1);
    out.binary(header);
    out.binary(static_cast<uint32_t>(triangles));
    for (const PlacedMesh& placed : meshes) {
        const World world(placed);
        for (size_t triangle = 0; triangle < placed.mesh->triangleCount(); ++triangle) {
            const auto [a, b, c] = world.triangle(triangle);
            const Vec3 pa = world.position(a);
            const Vec3 normal = glm::cross(world.position(b) - pa, world.position(c) - pa);
            const double length = glm::length(normal);
            out.binary(std::array{length > 0.0 ? Vec3f(normal / length) : Vec3f(0.0F), Vec3f(pa), Vec3f(world.position(b)),
                                  Vec3f(world.position(c))});
            out.binary(uint16_t{0});
            out.itemDone();
        }
    }
}

using WriteFormat = void (*)(Writer&, std::span<const PlacedMesh>);

WriteFormat writerFor(const std::filesystem::path& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".obj" || path == "-") return writeObj;
    if (extension == ".ply") return writePly;
    if (extension == ".stl") return writeStl;
    throwUsage(CULLSCOPE_TR("%1: meshes are written as .obj, .ply or .stl. Choose one of these endings."), {path.string()});
}

/// Throws Error(Usage) above the 32-bit limits of PLY's vertex numbers and STL's triangle count.
void refuseTooMany(const std::filesystem::path& path, std::span<const PlacedMesh> meshes) {
    uint64_t most = 0;
    for (const PlacedMesh& placed : meshes) most += std::max(placed.mesh->vertexCount(), placed.mesh->triangleCount());
    if (most >= (uint64_t{1} << 32) && extensionOf(path) != ".obj" && path != "-")
        throwUsage(CULLSCOPE_TR("%1: the scene has too many triangles for one file of this format. Write an OBJ file."),
                   {path.string()});
}

}  // namespace

void requireMeshFormat(const std::filesystem::path& path) { static_cast<void>(writerFor(path)); }

void saveMeshFile(const std::filesystem::path& path, std::span<const PlacedMesh> meshes, const Progress& progress) {
    const WriteFormat write = writerFor(path);
    refuseTooMany(path, meshes);
    writeFileAtomically(path, [&](std::ostream& stream) {
        Writer out(stream, meshes, progress);
        write(out, meshes);
        out.flush();
    });
}

}  // namespace cullscope
