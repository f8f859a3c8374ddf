#include "tests/support/draco_bytes.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <stdexcept>

namespace cullscope::test {

std::string dracoBytes(const std::vector<Vec3f>& positions, const std::vector<uint32_t>& triangles, bool edgebreaker, int bits) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(int(triangles.size() / 3));
    const int place = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int normal = builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    const Vec3f up(0.0F, 0.0F, 1.0F);
    for (size_t i = 0; i < triangles.size(); i += 3) {
        const draco::FaceIndex face(uint32_t(i / 3));
        builder.SetAttributeValuesForFace(place, face, &positions[triangles[i]].x, &positions[triangles[i + 1]].x,
                                          &positions[triangles[i + 2]].x);
        builder.SetAttributeValuesForFace(normal, face, &up.x, &up.x, &up.x);
    }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
    if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
    draco::EncoderBuffer buffer;
    if (mesh == nullptr || !encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) throw std::runtime_error("Draco encodes nothing");
    return {buffer.data(), buffer.size()};
}

}  // namespace cullscope::test
