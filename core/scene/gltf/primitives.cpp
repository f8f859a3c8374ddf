#include "core/scene/gltf/primitives.h"

#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/mesh/steps.h"
#include "core/scene/gltf/draco_mesh.h"
#include "core/scene/gltf/tiny_gltf.h"

namespace cullscope::gltf {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// A whole number of an object within an extension; none where it does not have it.
std::optional<int> wholeOf(const tinygltf::Value& object, const std::string& key) {
    if (!object.Has(key) || !object.Get(key).IsInt()) return std::nullopt;
    return object.Get(key).Get<int>();
}

class MeshBuilder {
public:
    MeshBuilder(const Accessors& accessors, const std::string& fileName, const RequireMemory& requireMemory,
                const Progress& progress, LeftOut& leftOut)
        : m_accessors(accessors),
          m_fileName(fileName),
          m_requireMemory(requireMemory),
          m_progress(progress),
          m_leftOut(leftOut) {}

    void add(const tinygltf::Primitive& primitive) {
        if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
            ++m_leftOut.pointsAndLines;
            return;
        }
        if (const auto draco = primitive.extensions.find(kDraco); draco != primitive.extensions.end())
            return addCompressed(primitive, draco->second);
        const auto positions = primitive.attributes.find("POSITION");
        if (positions == primitive.attributes.end()) {
            ++m_leftOut.withoutPositions;
            return;
        }
        const auto normals = primitive.attributes.find("NORMAL");
        const Vertices& vertices = verticesOf(positions->second, normals == primitive.attributes.end() ? -1 : normals->second);
        if (primitive.indices >= 0) {
            const std::vector<uint32_t> indices = m_accessors.wholes(primitive.indices);
            addTriangles(primitive.mode, indices.size(), vertices, [&](size_t i) { return indices[i]; });
        } else {
            addTriangles(primitive.mode, vertices.count, vertices, [](size_t i) { return uint32_t(i); });
        }
    }

    RawMesh finish() {
        if (!m_anyNormal) std::vector<Vec3f>().swap(m_mesh.normals);
        for (const Vec3f& position : m_mesh.narrow) nonFinite += usableCoordinates(Vec3(position)) ? 0 : 1;
        // Vertices that another mesh of the file uses may stand among this one's.
        m_mesh.verticesCounted = true;
        return std::move(m_mesh);
    }

    size_t nonFinite = 0;

private:
    struct Vertices {
        uint32_t first = 0;
        size_t count = 0;
    };

    void requireRoom(uint64_t vertices, uint64_t corners) const {
        m_requireMemory(2 * (m_mesh.bytes() + vertices * 2 * sizeof(Vec3f) + corners * sizeof(uint32_t)));
        if (m_mesh.narrow.size() + vertices >= kNoVertex)
            throwInput(CULLSCOPE_TR("%1 has more than 2,147,483,647 vertices in one object. Split the object."), {m_fileName});
    }

    const Vertices& verticesOf(int positions, int normals) {
        const auto [known, isNew] = m_known.try_emplace({positions, normals});
        if (!isNew) return known->second;
        const std::vector<float> places = m_accessors.numbers(positions, 3);
        requireRoom(places.size() / 3, 0);
        const Vertices vertices{uint32_t(m_mesh.narrow.size()), places.size() / 3};
        append(m_mesh.narrow, places);
        if (normals >= 0) {
            append(m_mesh.normals, m_accessors.numbers(normals, 3));
            m_anyNormal = true;
        }
        m_mesh.normals.resize(m_mesh.narrow.size(), Vec3f(0.0F));
        return known->second = vertices;
    }

    static void append(std::vector<Vec3f>& to, const std::vector<float>& numbers) {
        for (size_t i = 0; i + 2 < numbers.size(); i += 3) to.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }

    void addCompressed(const tinygltf::Primitive& primitive, const tinygltf::Value& draco) {
        const std::optional<int> view = wholeOf(draco, "bufferView");
        const tinygltf::Value none;
        const tinygltf::Value& attributes = draco.Has("attributes") ? draco.Get("attributes") : none;
        const std::optional<int> positions = wholeOf(attributes, "POSITION");
        if (!positions) {
            ++m_leftOut.withoutPositions;
            return;
        }
        const auto accessor = primitive.attributes.find("POSITION");
        DracoMesh decoded =
            decodeDraco(m_accessors.view(view.value_or(-1), accessor == primitive.attributes.end() ? -1 : accessor->second),
                        *positions, wholeOf(attributes, "NORMAL").value_or(-1), m_fileName, m_requireMemory);
        requireRoom(decoded.positions.size(), decoded.triangles.size());
        const Vertices vertices{uint32_t(m_mesh.narrow.size()), decoded.positions.size()};
        m_mesh.narrow.insert(m_mesh.narrow.end(), decoded.positions.begin(), decoded.positions.end());
        m_mesh.normals.insert(m_mesh.normals.end(), decoded.normals.begin(), decoded.normals.end());
        m_anyNormal = m_anyNormal || !decoded.normals.empty();
        m_mesh.normals.resize(m_mesh.narrow.size(), Vec3f(0.0F));
        addTriangles(TINYGLTF_MODE_TRIANGLES, decoded.triangles.size(), vertices, [&](size_t i) { return decoded.triangles[i]; });
    }

    /// Of `count` corners, of which `indexAt(i)` gives the vertex from the first of `vertices` (glTF 2.0, section 3.7.2.1).
    template <typename IndexAt>
    void addTriangles(int mode, size_t count, const Vertices& vertices, IndexAt&& indexAt) {
        const auto corner = [&](size_t i) {
            const uint32_t index = indexAt(i);
            m_mesh.triangles.push_back(index < vertices.count ? vertices.first + index : kNoVertex);
        };
        const bool isList = mode == TINYGLTF_MODE_TRIANGLES;
        const size_t triangles = isList ? count / 3 : count < 3 ? 0 : count - 2;
        requireRoom(0, 3 * triangles);
        inSteps(triangles, m_progress, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const size_t first = isList ? 3 * i : i;
                const bool isTurned = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
                if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
                    corner(i + 1);
                    corner(i + 2);
                    corner(0);
                } else {
                    corner(first);
                    corner(first + (isTurned ? 2 : 1));
                    corner(first + (isTurned ? 1 : 2));
                }
            }
        });
    }

    const Accessors& m_accessors;
    const std::string& m_fileName;
    const RequireMemory& m_requireMemory;
    const Progress& m_progress;
    LeftOut& m_leftOut;
    RawMesh m_mesh;
    bool m_anyNormal = false;
    std::map<std::pair<int, int>, Vertices> m_known;  ///< by the accessors of positions and normals
};

}  // namespace

RawMesh trianglesOf(const tinygltf::Mesh& mesh, const Accessors& accessors, const std::string& fileName,
                    const RequireMemory& requireMemory, const Progress& progress, LeftOut& leftOut) {
    MeshBuilder builder(accessors, fileName, requireMemory, progress, leftOut);
    for (const tinygltf::Primitive& primitive : mesh.primitives) builder.add(primitive);
    RawMesh made = builder.finish();
    leftOut.nonFiniteVertices += builder.nonFinite;
    return made;
}

}  // namespace cullscope::gltf
