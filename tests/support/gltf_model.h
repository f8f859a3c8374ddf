#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope::test {

/// Kinds of numbers of accessors, as glTF numbers them.
struct GltfKind {
    enum : int { Byte = 5120, UnsignedByte = 5121, Short = 5122, UnsignedShort = 5123, UnsignedInt = 5125, Float = 5126 };
};

/// Writes glTF 2.0: JSON that a test may change, and one buffer.
class GltfModel {
public:
    GltfModel() { json["asset"]["version"] = "2.0"; }

    /// The number of a new view of `bytes`.
    int view(const std::string& bytes, int stride = 0) {
        binary.resize((binary.size() + 3) / 4 * 4);
        nlohmann::json view{{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
        if (stride > 0) view["byteStride"] = stride;
        binary += bytes;
        return add("bufferViews", std::move(view));
    }
    int accessor(int view, int kind, size_t count, const char* type, bool normalised = false) {
        nlohmann::json accessor{{"bufferView", view}, {"componentType", kind}, {"count", count}, {"type", type}};
        if (normalised) accessor["normalized"] = true;
        return add("accessors", std::move(accessor));
    }
    template <typename Value>
    static std::string bytesOf(const std::vector<Value>& values) {
        return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
    }
    int positions(const std::vector<Vec3f>& values) {
        return accessor(view(bytesOf(values)), GltfKind::Float, values.size(), "VEC3");
    }
    int indices(const std::vector<uint16_t>& values) {
        return accessor(view(bytesOf(values)), GltfKind::UnsignedShort, values.size(), "SCALAR");
    }
    int mesh(nlohmann::json primitives, const std::string& name = {}) {
        nlohmann::json mesh{{"primitives", std::move(primitives)}};
        if (!name.empty()) mesh["name"] = name;
        return add("meshes", std::move(mesh));
    }
    int node(nlohmann::json node) { return add("nodes", std::move(node)); }
    int add(const char* section, nlohmann::json item) {
        json[section].push_back(std::move(item));
        return int(json[section].size()) - 1;
    }

    /// The JSON alone; its buffer is at `uri`, or without one a data URI.
    [[nodiscard]] std::string text(const std::string& uri = {}) const {
        nlohmann::json all = json;
        if (!binary.empty()) all["buffers"] = {{{"byteLength", binary.size()}, {"uri", uri.empty() ? dataUri() : uri}}};
        return all.dump();
    }
    [[nodiscard]] std::string glb() const {
        nlohmann::json all = json;
        std::string chunk = binary;
        chunk.resize((chunk.size() + 3) / 4 * 4);
        if (!binary.empty()) all["buffers"] = {{{"byteLength", chunk.size()}}};
        std::string text = all.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string bytes = "glTF";
        const auto whole = [&](size_t value) {
            const auto bits = uint32_t(value);
            bytes.append(reinterpret_cast<const char*>(&bits), sizeof(bits));
        };
        whole(2);
        whole(20 + text.size() + (chunk.empty() ? 0 : 8 + chunk.size()));
        whole(text.size());
        bytes += "JSON" + text;
        if (chunk.empty()) return bytes;
        whole(chunk.size());
        return bytes + std::string("BIN\0", 4) + chunk;
    }

    nlohmann::json json;
    std::string binary;

private:
    [[nodiscard]] std::string dataUri() const {
        constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string uri = "data:application/octet-stream;base64,";
        for (size_t i = 0; i < binary.size(); i += 3) {
            uint32_t bits = 0;
            for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < binary.size() ? uint8_t(binary[i + k]) : 0U);
            for (size_t k = 0; k < 4; ++k) uri += i + k > binary.size() ? '=' : kLetters[bits >> (18 - 6 * k) & 63];
        }
        return uri;
    }
};

/// The square from (0, 0) to (1, 1) in the plane z = 0, facing z, as a mesh of that name.
inline int gltfSquare(GltfModel& model, const std::string& name) {
    const int positions = model.positions({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    const int corners = model.indices({0, 1, 2, 0, 2, 3});
    return model.mesh({{{"attributes", {{"POSITION", positions}}}, {"indices", corners}}}, name);
}

/// A tree of nodes that share the square, a node of points, and what is not shown: a skin, morph targets, an animation, images.
inline GltfModel gltfSample() {
    GltfModel model;
    const int square = gltfSquare(model, "square");
    const int points = model.mesh({{{"attributes", {{"POSITION", 0}}}, {"mode", 0}}});
    const int morphed =
        model.mesh({{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"targets", {{{"POSITION", 0}}}}}}, "blob");
    model.node({{"name", "arm"}, {"translation", {10, 0, 0}}, {"children", {1, 2}}});
    model.node({{"name", "hand"}, {"mesh", square}, {"scale", {2, 2, 2}}});
    model.node({{"mesh", square}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}, {"children", {3}}});
    model.node(
        {{"name", "hand"}, {"mesh", morphed}, {"rotation", {0, 0, 0.70710678118654757, 0.70710678118654757}}, {"skin", 0}});
    model.node({{"mesh", points}});
    model.add("scenes", {{"nodes", {0, 4}}});
    model.add("skins", {{"joints", {0}}});
    const int times = model.accessor(model.view(std::string(4, '\0')), GltfKind::Float, 1, "SCALAR");
    model.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                             {"samplers", {{{"input", times}, {"output", 0}}}}});
    model.add("images", {{"uri", "missing.png"}});
    model.add("images", {{"uri", "data:image/unknown;base64,AAAA"}});
    model.add("materials", {{"name", "red"}});
    return model;
}

}  // namespace cullscope::test
