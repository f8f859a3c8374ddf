#include "core/scene/gltf/draco_mesh.h"

#include <draco/compression/decode.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <array>

#include "core/base/error.h"
#include "core/base/terminal_text.h"

namespace cullscope::gltf {
namespace {

/// For each triangle and corner: tables of the decoder, attributes, and the mesh made of them.
constexpr uint64_t kBytesOfTriangle = 256, kBytesOfPoint = 256;

constexpr uint16_t kMetadataFlag = 0x8000;

/// The counts of triangles and points of a mesh (Draco's bitstream, "Decoding process": header, metadata, connectivity). None
/// where the bytes are no mesh of a version that states them in this place.
std::optional<uint64_t> memoryOf(std::span<const unsigned char> bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DracoHeader header{};
    std::array<uint8_t, 4> numbers{};  // versions, type and method
    if (!buffer.Decode(header.draco_string, sizeof(header.draco_string)) || !buffer.Decode(numbers.data(), numbers.size()) ||
        !buffer.Decode(&header.flags))
        return std::nullopt;
    const auto [major, minor, type, method] = numbers;
    if (major != 2 || minor < 2 || type != draco::TRIANGULAR_MESH) return std::nullopt;
    buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(major, minor));
    if ((header.flags & kMetadataFlag) != 0) {
        draco::GeometryMetadata metadata;
        if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) return std::nullopt;
    }
    uint8_t traversal = 0;
    if (method == draco::MESH_EDGEBREAKER_ENCODING && !buffer.Decode(&traversal)) return std::nullopt;
    uint32_t first = 0, second = 0;
    if (!draco::DecodeVarint(&first, &buffer) || !draco::DecodeVarint(&second, &buffer)) return std::nullopt;
    const bool pointsFirst = method == draco::MESH_EDGEBREAKER_ENCODING;
    const uint64_t triangles = pointsFirst ? second : first, points = pointsFirst ? first : second;
    return kBytesOfTriangle * triangles + kBytesOfPoint * points;
}

class Decoding {
public:
    Decoding(const std::string& fileName, const draco::Mesh& mesh) : m_fileName(fileName), m_mesh(mesh) {}

    [[nodiscard]] std::vector<Vec3f> vectors(int number) const {
        const draco::PointAttribute* attribute = number < 0 ? nullptr : m_mesh.GetAttributeByUniqueId(uint32_t(number));
        if (attribute == nullptr || attribute->num_components() != 3) refuseAttribute(number);
        std::vector<Vec3f> vectors;
        vectors.reserve(m_mesh.num_points());
        for (draco::PointIndex point(0); point < m_mesh.num_points(); ++point) {
            Vec3f value(0.0F);
            const draco::AttributeValueIndex index = attribute->mapped_index(point);
            if (index.value() >= attribute->size() || !attribute->ConvertValue<float, 3>(index, &value.x))
                refuseAttribute(number);
            vectors.push_back(value);
        }
        return vectors;
    }

private:
    [[noreturn]] void refuseAttribute(int number) const {
        throwInput(
            CULLSCOPE_TR("%1: a mesh that is compressed with Draco does not have its attribute %2. Export the file again."),
            {m_fileName, std::to_string(number)});
    }

    const std::string& m_fileName;
    const draco::Mesh& m_mesh;
};

}  // namespace

DracoMesh decodeDraco(std::span<const unsigned char> bytes, int positions, int normals, const std::string& fileName,
                      const RequireMemory& requireMemory) {
    const std::optional<uint64_t> memory = memoryOf(bytes);
    if (!memory)
        throwInput(CULLSCOPE_TR("%1: a mesh is compressed with a version of Draco that is not read. Export the file again."),
                   {fileName});
    requireMemory(*memory);
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
        throwInput(
            CULLSCOPE_TR("%1: a mesh that is compressed with Draco cannot be decoded: %2. Fetch or export the file again."),
            {fileName, terminalLine(decoded.status().error_msg_string())});
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    const Decoding decoding(fileName, *mesh);
    DracoMesh made;
    made.positions = decoding.vectors(positions);
    if (normals >= 0) made.normals = decoding.vectors(normals);
    made.triangles.reserve(size_t{3} * mesh->num_faces());
    for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face)
        for (const draco::PointIndex& corner : mesh->face(face)) made.triangles.push_back(corner.value());
    return made;
}

}  // namespace cullscope::gltf
