#include "core/mesh/primitive/tessellate.h"

namespace cullscope::primitive {

MeshPointer meshOf(const Surface& surface, std::string name) {
    Box3 box;
    for (const uint32_t corner : surface.triangles) box.add(surface.positions[corner]);
    TriangleMesh::Data data;
    data.name = std::move(name);
    if (!box.empty()) data.origin = box.centre();
    constexpr uint32_t kUnused = 0xffffffffU;  // a corner of triangles without an area alone
    std::vector<uint32_t> places(surface.positions.size(), kUnused);
    for (const uint32_t corner : surface.triangles) {
        if (places[corner] == kUnused) {
            places[corner] = uint32_t(data.positions.size());
            data.positions.emplace_back(surface.positions[corner] - data.origin);
            data.normals.emplace_back(surface.normals[corner]);
        }
        data.indices.push_back(places[corner]);
    }
    return std::make_shared<const TriangleMesh>(std::move(data));
}

}  // namespace cullscope::primitive
