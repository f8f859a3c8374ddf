#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/scene/quake/level.h"

namespace cullscope::quake {
namespace {

constexpr size_t kLumps = 17;
constexpr size_t kHeaderBytes = 8 + 8 * kLumps;
constexpr int32_t kVersion = 46;

/// Numbers of the arrays (lumps) that are read, in the order of the file's directory.
struct Lump {
    enum : size_t {
        Entities = 0,
        Shaders = 1,
        Planes = 2,
        Nodes = 3,
        Leaves = 4,
        LeafSurfaces = 5,
        Models = 7,
        Vertices = 10,
        Corners = 11,
        Surfaces = 13,
        Visibility = 16
    };
};

// The records as they lie in the file: numbers of four bytes each, without gaps.
struct ShaderRecord {
    std::array<char, 64> name;
    uint32_t flags, contents;
};
struct PlaneRecord {
    Vec3f normal;
    float distance;
};
struct NodeRecord {
    int32_t plane;
    std::array<int32_t, 2> children;
    std::array<int32_t, 6> box;
};
struct LeafRecord {
    int32_t cluster, area;
    std::array<int32_t, 6> box;
    int32_t firstSurface, surfaceCount, firstBrush, brushCount;
};
struct ModelRecord {
    std::array<float, 6> box;
    int32_t firstSurface, surfaceCount, firstBrush, brushCount;
};
struct VertexRecord {
    Vec3f position;
    std::array<float, 4> textures;
    Vec3f normal;
    uint32_t colour;
};
struct SurfaceRecord {
    int32_t shader, fog, kind, firstVertex, vertexCount, firstCorner, cornerCount;
    std::array<int32_t, 5> lightMap;
    std::array<float, 12> lightMapPlace;
    int32_t patchWidth, patchHeight;
};
static_assert(sizeof(ShaderRecord) == 72 && sizeof(PlaneRecord) == 16 && sizeof(NodeRecord) == 36 && sizeof(LeafRecord) == 48 &&
              sizeof(ModelRecord) == 40 && sizeof(VertexRecord) == 44 && sizeof(SurfaceRecord) == 104);

class Reader {
public:
    Reader(ByteSource& source, const std::function<void(uint64_t)>& requireMemory)
        : m_name(source.name()), m_source(source), m_requireMemory(requireMemory) {}

    Level read() {
        readDirectory();
        readShapes();
        readSurfaces();
        readTree();
        readVisibility();
        const std::string_view text = bytesOf(Lump::Entities);
        m_level.entities = readEntities(text.substr(0, text.find('\0')), [&](size_t byte) {
            refuse(m_offsets[Lump::Entities] + byte,
                   CULLSCOPE_TR("%1, byte %2: the text of the level's entities cannot be read here. Fetch or compile the level "
                                "again."));
        });
        return std::move(m_level);
    }

private:
    [[noreturn]] void refuse(uint64_t byte, std::string_view sentence, const std::string& more = {}) const {
        throwInput(sentence, {m_name, std::to_string(byte), more});
    }

    void readDirectory();
    void readShapes();
    void readSurfaces();
    void readTree();
    void requireTree() const;
    void readVisibility();

    [[nodiscard]] std::string_view bytesOf(size_t lump) const {
        return std::string_view(m_content).substr(m_offsets[lump], m_lengths[lump]);
    }

    /// Calls `visit(record, byte of the file)` for each record of an array.
    template <typename Record, typename Visit>
    void forEach(size_t lump, Visit&& visit) const {
        const std::string_view bytes = bytesOf(lump);
        if (bytes.size() % sizeof(Record) != 0)
            refuse(8 + 8 * lump,
                   CULLSCOPE_TR("%1, byte %2: an array of the level ends within a record. Fetch or compile the level again."));
        for (size_t at = 0; at < bytes.size(); at += sizeof(Record)) {
            Record record;
            std::memcpy(&record, bytes.data() + at, sizeof(Record));
            visit(record, m_offsets[lump] + at);
        }
    }

    /// Refuses a record that names items from `first` on which the file does not have.
    void requireRange(int64_t first, int64_t count, size_t size, uint64_t byte) const {
        if (first >= 0 && count >= 0 && first + count <= int64_t(size)) return;
        throwInput(
            CULLSCOPE_TR("%1, byte %2: the record here names %3 items from number %4 on, but the file has %5 of them. Fetch "
                         "or compile the level again."),
            {m_name, std::to_string(byte), std::to_string(count), std::to_string(first), std::to_string(size)});
    }
    void requireOne(int64_t index, size_t size, uint64_t byte) const { requireRange(index, 1, size, byte); }

    std::string m_name;
    ByteSource& m_source;
    const std::function<void(uint64_t)>& m_requireMemory;
    std::string m_content;
    std::array<size_t, kLumps> m_offsets{}, m_lengths{};
    Level m_level;
};

void Reader::readDirectory() {
    const std::string_view start = m_source.peek(kHeaderBytes);
    if (!start.starts_with("IBSP"))
        throwInput(CULLSCOPE_TR("%1 does not begin with IBSP, as levels of Quake 3 do. Levels of other games are not read: "
                                "convert them to a mesh."),
                   {m_name});
    if (start.size() < kHeaderBytes)
        throwInput(CULLSCOPE_TR("%1 ends at byte %2, before everything that it promises. The file was cut off: fetch it again."),
                   {m_name, std::to_string(m_source.size())});
    int32_t version = 0;
    std::memcpy(&version, start.data() + 4, sizeof(version));
    if (version != kVersion)
        throwInput(CULLSCOPE_TR("%1 is a level of version %2; only version %3, that of Quake 3, is read. Convert it to a mesh."),
                   {m_name, std::to_string(version), std::to_string(kVersion)});
    // The content, and records of a level that are at most as large as those in the file.
    m_requireMemory(2 * m_source.size());
    m_content = m_source.rest();
    for (size_t lump = 0; lump < kLumps; ++lump) {
        std::array<uint32_t, 2> place{};
        std::memcpy(place.data(), m_content.data() + 8 + 8 * lump, sizeof(place));
        if (uint64_t{place[0]} + place[1] > m_content.size())
            refuse(
                8 + 8 * lump,
                CULLSCOPE_TR("%1, byte %2: an array of the level is to end at byte %3, after the end of the file. The file was "
                             "cut off or changed: fetch it again."),
                std::to_string(uint64_t{place[0]} + place[1]));
        m_offsets[lump] = place[0];
        m_lengths[lump] = place[1];
    }
}

void Reader::readShapes() {
    forEach<ShaderRecord>(Lump::Shaders, [&](const ShaderRecord& record, uint64_t) {
        const std::string_view name(record.name.data(), record.name.size());
        m_level.shaders.push_back({std::string(name.substr(0, name.find('\0'))), record.flags});
    });
    forEach<VertexRecord>(Lump::Vertices, [&](const VertexRecord& record, uint64_t) {
        m_level.vertices.push_back({record.position, record.normal});
    });
    forEach<uint32_t>(Lump::Corners, [&](uint32_t corner, uint64_t) { m_level.corners.push_back(corner); });
    forEach<PlaneRecord>(Lump::Planes, [&](const PlaneRecord& record, uint64_t) {
        m_level.planes.push_back({Vec3(record.normal), record.distance});
    });
}

void Reader::readSurfaces() {
    forEach<SurfaceRecord>(Lump::Surfaces, [&](const SurfaceRecord& record, uint64_t byte) {
        if (record.kind < 1 || record.kind > 4)
            refuse(byte + 8, CULLSCOPE_TR("%1, byte %2: there is no surface of kind %3. Fetch or compile the level again."),
                   std::to_string(record.kind));
        Surface surface;
        surface.kind = Surface::Kind(record.kind);
        requireOne(record.shader, m_level.shaders.size(), byte);
        requireRange(record.firstVertex, record.vertexCount, m_level.vertices.size(), byte + 12);
        requireRange(record.firstCorner, record.cornerCount, m_level.corners.size(), byte + 20);
        surface.shader = uint32_t(record.shader);
        surface.firstVertex = uint32_t(record.firstVertex);
        surface.vertexCount = uint32_t(record.vertexCount);
        surface.firstCorner = uint32_t(record.firstCorner);
        surface.cornerCount = uint32_t(record.cornerCount);
        if (surface.kind == Surface::Kind::Patch) {
            const int64_t width = record.patchWidth, height = record.patchHeight;
            if (width < 3 || height < 3 || width % 2 == 0 || height % 2 == 0 || width * height != record.vertexCount)
                refuse(byte + 96,
                       CULLSCOPE_TR("%1, byte %2: a patch has %3 control points; the sides are odd numbers from 3 on, and their "
                                    "product is the number of vertices. Fetch or compile the level again."),
                       std::to_string(width) + " × " + std::to_string(height));
            surface.patchWidth = uint32_t(width);
            surface.patchHeight = uint32_t(height);
        }
        m_level.surfaces.push_back(surface);
    });
    const size_t surfaces = m_level.surfaces.size();
    forEach<ModelRecord>(Lump::Models, [&](const ModelRecord& record, uint64_t byte) {
        requireRange(record.firstSurface, record.surfaceCount, surfaces, byte + 24);
        m_level.models.push_back({uint32_t(record.firstSurface), uint32_t(record.surfaceCount)});
    });
    forEach<int32_t>(Lump::LeafSurfaces, [&](int32_t surface, uint64_t byte) {
        requireOne(surface, surfaces, byte);
        m_level.leafSurfaces.push_back(uint32_t(surface));
    });
}

void Reader::readTree() {
    forEach<LeafRecord>(Lump::Leaves, [&](const LeafRecord& record, uint64_t byte) {
        requireRange(record.firstSurface, record.surfaceCount, m_level.leafSurfaces.size(), byte + 32);
        m_level.leaves.push_back({record.cluster, uint32_t(record.firstSurface), uint32_t(record.surfaceCount)});
    });
    forEach<NodeRecord>(Lump::Nodes, [&](const NodeRecord& record, uint64_t byte) {
        requireOne(record.plane, m_level.planes.size(), byte);
        for (const int64_t child : record.children)
            requireOne(child < 0 ? -1 - child : child,
                       child < 0 ? m_level.leaves.size() : m_lengths[Lump::Nodes] / sizeof(record), byte + 4);
        m_level.nodes.push_back({uint32_t(record.plane), record.children});
    });
    requireTree();
}

/// A node that two others name, or that lies below itself, would make walks through the tree long or endless.
void Reader::requireTree() const {
    std::vector<bool> named(m_level.nodes.size());
    if (!named.empty()) named[0] = true;
    for (size_t i = 0; i < m_level.nodes.size(); ++i)
        for (const int32_t child : m_level.nodes[i].children) {
            if (child < 0) continue;
            if (named[size_t(child)])
                refuse(
                    m_offsets[Lump::Nodes] + i * sizeof(NodeRecord) + 4,
                    CULLSCOPE_TR("%1, byte %2: the node %3 of the BSP tree has two parents. Fetch or compile the level again."),
                    std::to_string(child));
            named[size_t(child)] = true;
        }
}

void Reader::readVisibility() {
    const std::string_view bytes = bytesOf(Lump::Visibility);
    std::array<uint32_t, 2> sizes{};
    if (bytes.size() >= sizeof(sizes)) std::memcpy(sizes.data(), bytes.data(), sizeof(sizes));
    if (sizes[0] > 0) {
        m_level.clusters = sizes[0];
        m_level.bytesOfCluster = sizes[1];
        if (uint64_t{sizes[1]} * 8 < sizes[0] || uint64_t{sizes[0]} * sizes[1] > bytes.size() - sizeof(sizes))
            refuse(
                m_offsets[Lump::Visibility],
                CULLSCOPE_TR("%1, byte %2: the file has no room for which of %3 clusters see which. Fetch or compile the level "
                             "again."),
                std::to_string(sizes[0]));
        m_level.visibleBits = bytes.substr(sizeof(sizes), size_t{sizes[0]} * sizes[1]);
    }
    for (size_t i = 0; i < m_level.leaves.size(); ++i) {
        const int32_t cluster = m_level.leaves[i].cluster;
        if (cluster >= 0 && m_level.clusters > 0)
            requireOne(cluster, m_level.clusters, m_offsets[Lump::Leaves] + i * sizeof(LeafRecord));
    }
}

}  // namespace

Level readLevel(ByteSource& source, const std::function<void(uint64_t)>& requireMemory) {
    return Reader(source, requireMemory).read();
}

}  // namespace cullscope::quake
