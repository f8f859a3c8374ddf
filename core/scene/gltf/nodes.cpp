#include "core/scene/gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/base/error.h"
#include "core/scene/gltf/tiny_gltf.h"

namespace cullscope::gltf {
namespace {

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

Mat4 composed(const Vec3& translation, const glm::dquat& rotation, const Vec3& scale) {
    const double length = glm::length(rotation);
    const Mat3 turn = glm::mat3_cast(length > 0.0 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0));
    Mat4 transform(1.0);
    for (int column = 0; column < 3; ++column) transform[column] = Vec4(turn[column] * scale[column], 0.0);
    transform[3] = Vec4(translation, 1.0);
    return transform;
}

class NodeWalk {
public:
    NodeWalk(const tinygltf::Model& model, const Accessors& accessors, const std::string& fileName,
             const std::function<void(const PlacedMesh&)>& place)
        : m_model(model), m_accessors(accessors), m_fileName(fileName), m_place(place), m_seen(model.nodes.size()) {}

    void walk() {
        push(roots(), Mat4(1.0));
        while (!m_open.empty()) {
            const Open open = m_open.back();
            m_open.pop_back();
            const tinygltf::Node& node = m_model.nodes[size_t(open.node)];
            const Mat4 world = open.worldFromParent * transformOf(node, open.node);
            if (node.mesh >= 0) placeMesh(node, open.node, world);
            push(node.children, world);
        }
    }

private:
    struct Open {
        int node = 0;
        Mat4 worldFromParent{1.0};
    };

    void refuse(std::string_view sentence, int number) const { throwInput(sentence, {m_fileName, std::to_string(number)}); }

    [[nodiscard]] std::vector<int> roots() const {
        if (!m_model.scenes.empty()) {
            const int shown = m_model.defaultScene < 0 ? 0 : m_model.defaultScene;
            if (size_t(shown) >= m_model.scenes.size())
                refuse(CULLSCOPE_TR("%1 names the scene %2, which it does not have. Export the file again."), shown);
            return m_model.scenes[size_t(shown)].nodes;
        }
        std::vector<bool> isChild(m_model.nodes.size());
        for (const tinygltf::Node& node : m_model.nodes)
            for (const int child : node.children)
                if (child >= 0 && size_t(child) < isChild.size()) isChild[size_t(child)] = true;
        std::vector<int> roots;
        for (size_t i = 0; i < isChild.size(); ++i)
            if (!isChild[i]) roots.push_back(int(i));
        return roots;
    }

    /// In reverse, so that they are taken in the file's order.
    void push(const std::vector<int>& nodes, const Mat4& worldFromParent) {
        for (size_t i = nodes.size(); i-- > 0;) {
            const int node = nodes[i];
            if (node < 0 || size_t(node) >= m_seen.size())
                refuse(CULLSCOPE_TR("%1 names the node %2, which it does not have. Export the file again."), node);
            if (m_seen[size_t(node)])
                refuse(CULLSCOPE_TR("%1: the node %2 has two parents or is its own ancestor. Export the file again."), node);
            m_seen[size_t(node)] = true;
            m_open.push_back({node, worldFromParent});
        }
    }

    [[nodiscard]] Mat4 transformOf(const tinygltf::Node& node, int number) const {
        const auto has = [&](const std::vector<double>& numbers, size_t count) {
            if (numbers.empty()) return false;
            if (numbers.size() != count || !std::ranges::all_of(numbers, [](double value) { return std::isfinite(value); }))
                refuse(CULLSCOPE_TR("%1: the transform of the node %2 does not have the numbers that it needs. Export the file "
                                    "again."),
                       number);
            return true;
        };
        Mat4 transform(1.0);
        if (has(node.matrix, 16)) {
            for (int i = 0; i < 16; ++i) transform[i / 4][i % 4] = node.matrix[size_t(i)];
            if (transform[0].w != 0.0 || transform[1].w != 0.0 || transform[2].w != 0.0 || transform[3].w != 1.0)
                refuse(CULLSCOPE_TR("%1: the matrix of the node %2 is not affine. Export the file again."), number);
            return transform;
        }
        Vec3 translation(0.0), scale(1.0);
        glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
        if (has(node.translation, 3)) translation = {node.translation[0], node.translation[1], node.translation[2]};
        if (has(node.scale, 3)) scale = {node.scale[0], node.scale[1], node.scale[2]};
        if (has(node.rotation, 4)) rotation = {node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]};
        return composed(translation, rotation, scale);
    }

    void placeMesh(const tinygltf::Node& node, int number, const Mat4& world) const {
        if (size_t(node.mesh) >= m_model.meshes.size())
            refuse(CULLSCOPE_TR("%1 names the mesh %2, which it does not have. Export the file again."), node.mesh);
        const auto instancing = node.extensions.find(kInstancing);
        if (instancing == node.extensions.end()) return m_place({number, node.mesh, world});
        const std::vector<float> translations = numbersOf(instancing->second, "TRANSLATION", 3);
        const std::vector<float> rotations = numbersOf(instancing->second, "ROTATION", 4);
        const std::vector<float> scales = numbersOf(instancing->second, "SCALE", 3);
        const size_t count = std::max({translations.size() / 3, rotations.size() / 4, scales.size() / 3});
        for (const auto& [numbers, components] : {std::pair(&translations, 3), std::pair(&rotations, 4), std::pair(&scales, 3)})
            if (!numbers->empty() && numbers->size() != count * size_t(components))
                refuse(
                    CULLSCOPE_TR("%1: the instances of the node %2 have transforms of different numbers. Export the file again."),
                    number);
        for (size_t i = 0; i < count; ++i) {
            Vec3 translation(0.0), scale(1.0);
            glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
            if (!translations.empty()) translation = {translations[3 * i], translations[3 * i + 1], translations[3 * i + 2]};
            if (!scales.empty()) scale = {scales[3 * i], scales[3 * i + 1], scales[3 * i + 2]};
            if (!rotations.empty())
                rotation = {rotations[4 * i + 3], rotations[4 * i], rotations[4 * i + 1], rotations[4 * i + 2]};
            m_place({number, node.mesh, world * composed(translation, rotation, scale)});
        }
    }

    [[nodiscard]] std::vector<float> numbersOf(const tinygltf::Value& instancing, const std::string& attribute,
                                               size_t components) const {
        if (!instancing.Has("attributes")) return {};
        const tinygltf::Value& attributes = instancing.Get("attributes");
        if (!attributes.Has(attribute)) return {};
        const tinygltf::Value& accessor = attributes.Get(attribute);
        return m_accessors.numbers(accessor.IsInt() ? accessor.Get<int>() : -1, components);
    }

    const tinygltf::Model& m_model;
    const Accessors& m_accessors;
    const std::string& m_fileName;
    const std::function<void(const PlacedMesh&)>& m_place;
    std::vector<bool> m_seen;
    std::vector<Open> m_open;
};

}  // namespace

void placeMeshes(const tinygltf::Model& model, const Accessors& accessors, const std::string& fileName,
                 const std::function<void(const PlacedMesh&)>& place) {
    NodeWalk(model, accessors, fileName, place).walk();
}

}  // namespace cullscope::gltf
