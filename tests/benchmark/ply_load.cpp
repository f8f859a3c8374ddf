#include "tests/benchmark/ply_load.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace cullscope::benchmark {
namespace {

using namespace OpenMesh;

/// Stores points and triangles and ignores everything else.
class ArrayImporter : public IO::BaseImporter {
public:
    BareMesh mesh;

    VertexHandle add_vertex(const Vec3f& point) override {
        mesh.positions.insert(mesh.positions.end(), {point[0], point[1], point[2]});
        return VertexHandle(static_cast<int>(mesh.positions.size() / 3 - 1));
    }
    VertexHandle add_vertex() override { return add_vertex(Vec3f(0.0F, 0.0F, 0.0F)); }
    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(const VHandles& corners) override {
        for (const VertexHandle corner : corners) mesh.indices.push_back(static_cast<uint32_t>(corner.idx()));
        return FaceHandle(static_cast<int>(mesh.indices.size() / 3 - 1));
    }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void reserve(unsigned int vertices, unsigned int, unsigned int faces) override {
        mesh.positions.reserve(size_t{3} * vertices);
        mesh.indices.reserve(size_t{3} * faces);
    }
    size_t n_vertices() const override { return mesh.positions.size() / 3; }
    size_t n_faces() const override { return mesh.indices.size() / 3; }
    size_t n_edges() const override { return 0; }

    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_point(VertexHandle, const Vec3f&) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_normal(VertexHandle, const Vec3f&) override {}
    void set_normal(VertexHandle, const Vec3d&) override {}
    void set_color(VertexHandle, const Vec3uc&) override {}
    void set_color(VertexHandle, const Vec4uc&) override {}
    void set_color(VertexHandle, const Vec3f&) override {}
    void set_color(VertexHandle, const Vec4f&) override {}
    void set_texcoord(VertexHandle, const Vec2f&) override {}
    void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
    void set_texcoord(VertexHandle, const Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
    void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
    void set_color(EdgeHandle, const Vec3uc&) override {}
    void set_color(EdgeHandle, const Vec4uc&) override {}
    void set_color(EdgeHandle, const Vec3f&) override {}
    void set_color(EdgeHandle, const Vec4f&) override {}
    void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
    void set_normal(FaceHandle, const Vec3f&) override {}
    void set_normal(FaceHandle, const Vec3d&) override {}
    void set_color(FaceHandle, const Vec3uc&) override {}
    void set_color(FaceHandle, const Vec4uc&) override {}
    void set_color(FaceHandle, const Vec3f&) override {}
    void set_color(FaceHandle, const Vec4f&) override {}
    void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}
};

}  // namespace

BareMesh loadByOpenMesh(const std::filesystem::path& path) {
    ArrayImporter importer;
    IO::Options options;
    if (!IO::PLYReader().read(path.string(), importer, options))
        throw std::runtime_error("OpenMesh cannot read " + path.string());
    return std::move(importer.mesh);
}

void writeSheet(const std::filesystem::path& path, uint64_t faces) {
    const auto side = static_cast<uint32_t>(std::llround(std::sqrt(static_cast<double>(faces) / 2.0)));
    std::ofstream out(path, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << uint64_t{side + 1} * (side + 1)
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << uint64_t{side} * side * 2
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (uint32_t row = 0; row <= side; ++row) {
        for (uint32_t column = 0; column <= side; ++column) {
            const float point[3] = {
                static_cast<float>(column), static_cast<float>(row),
                20.0F * std::sin(0.01F * static_cast<float>(row)) * std::cos(0.013F * static_cast<float>(column))};
            out.write(reinterpret_cast<const char*>(point), sizeof(point));
        }
    }
    const auto writeFace = [&](uint32_t a, uint32_t b, uint32_t c) {
        const uint32_t corners[3] = {a, b, c};
        char record[13] = {3};
        std::memcpy(record + 1, corners, sizeof(corners));
        out.write(record, sizeof(record));
    };
    for (uint32_t row = 0; row < side; ++row) {
        for (uint32_t column = 0; column < side; ++column) {
            const uint32_t corner = row * (side + 1) + column;
            writeFace(corner, corner + 1, corner + side + 2);
            writeFace(corner, corner + side + 2, corner + side + 1);
        }
    }
    out.close();
    if (!out) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace cullscope::benchmark
