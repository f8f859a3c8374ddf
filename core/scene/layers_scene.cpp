#include "core/scene/layers_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"

namespace cullscope {
namespace {

constexpr double kHalfHeight = 1.0;
constexpr double kHalfWidth = 4.0 / 3.0;
constexpr double kHalfDepth = 1.4;  // more than half the width, so that walks lead along z

constexpr double kWavesAcross = 3.7, kWavesUp = 2.3;

/// The height of the waves at a place, as a share of their height.
double waveAt(double x, double y) { return std::sin(kWavesAcross * x) * std::cos(kWavesUp * y); }

Vec3 normalAt(double x, double y, double height) {
    const double alongX = kWavesAcross * std::cos(kWavesAcross * x) * std::cos(kWavesUp * y);
    const double alongY = -kWavesUp * std::sin(kWavesAcross * x) * std::sin(kWavesUp * y);
    return glm::normalize(Vec3(-height * alongX, -height * alongY, 1.0));
}

MeshPointer sheet(const Layers& layers, const Progress& progress) {
    const double squares = double(layers.triangles) / 2.0;
    const auto across = uint32_t(std::max(1.0, std::round(std::sqrt(squares * kHalfWidth / kHalfHeight))));
    const auto up = uint32_t(std::max(1.0, std::round(squares / across)));
    TriangleMesh::Data data;
    data.name = "layer";
    data.positions.reserve(size_t{across + 1} * (up + 1));
    data.normals.reserve(data.positions.capacity());
    for (uint32_t row = 0; row <= up; ++row) {
        progress.check();
        for (uint32_t column = 0; column <= across; ++column) {
            const double x = kHalfWidth * (2.0 * column / across - 1.0), y = kHalfHeight * (2.0 * row / up - 1.0);
            data.positions.emplace_back(float(x), float(y), float(layers.waves * waveAt(x, y)));
            data.normals.emplace_back(normalAt(x, y, layers.waves));
        }
    }
    const auto vertex = [&](uint32_t x, uint32_t y) { return y * (across + 1) + x; };
    for (uint32_t y = 0; y < up; ++y) {
        progress.check();
        for (uint32_t x = 0; x < across; ++x)
            data.indices.insert(data.indices.end(), {vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1),  //
                                                     vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

}  // namespace

ScenePointer layersScene(std::string name, const Layers& layers, const Progress& progress) {
    std::vector<Instance> instances;
    for (size_t i = 0; i < layers.count; ++i) {
        Mat4 place(1.0);
        place[3].z = layers.count > 1 ? kHalfDepth * (1.0 - 2.0 * double(i) / double(layers.count - 1)) : 0.0;
        instances.push_back({0, place, "layer " + std::to_string(i + 1)});
    }
    return std::make_shared<const Scene>(std::move(name), std::vector<MeshPointer>{sheet(layers, progress)},
                                         std::move(instances));
}

}  // namespace cullscope
