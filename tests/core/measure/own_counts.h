#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "core/measure/reference.h"
#include "core/visibility/triangle_states.h"

namespace cullscope::test {

// Counts of a frame that share no code with those of the library.

/// What a frame drew, by scene triangle number, as its commands have it. Draw lists are in the meshes' own order.
inline std::vector<bool> drawnByCommands(const Scene& scene, const FrameLog& log) {
    std::vector<bool> drawn(scene.triangleCount(), false);
    for (const Command& command : log.commands) {
        if (const auto* list = std::get_if<DrawList>(&command)) {
            EXPECT_FALSE(list->order);
            for (const DrawRange& range : list->ranges)
                for (uint32_t i = 0; i < range.indexCount / 3; ++i)
                    drawn[scene.firstTriangle(range.instance) + range.firstIndex / 3 + i] = true;
        } else if (const auto* own = std::get_if<OwnTrianglesPointer>(&command)) {
            for (const uint32_t triangle : (*own)->triangles) drawn[triangle] = true;
        } else if (const auto* picture = std::get_if<FinishedPicturePointer>(&command)) {
            for (const uint32_t item : (*picture)->triangle)
                if (item != 0) drawn[item - 1] = true;
        }
    }
    return drawn;
}

/// Whether a triangle's back is turned to the eye.
inline bool facesAwayFrom(const Vec3& eye, const Scene& scene, uint64_t triangle) {
    const auto instance = uint32_t(scene.instanceOf(triangle));
    const TriangleMesh& mesh = scene.meshOf(instance);
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t index = mesh.indices()[3 * (triangle - scene.firstTriangle(instance)) + i];
        corners[i] = Vec3(scene.instances()[instance].worldFromMesh * Vec4(mesh.origin() + Vec3(mesh.positions()[index]), 1.0));
    }
    return glm::dot(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), eye - corners[0]) < 0.0;
}

/// The triangles by state, counted here: from what the commands drew, the pixels of the truth, and the triangles' own normals.
/// `leftOut`: what becomes of what the strategy leaves out.
inline std::array<uint64_t, kTriangleStateCount> ownCounts(const Scene& scene, const FrameLog& log, const Reference& truth,
                                                           TriangleState leftOut = TriangleState::Hidden) {
    std::vector<bool> visible(scene.triangleCount(), false);
    for (const uint32_t item : truth.triangle)
        if (item != 0) visible[item - 1] = true;
    const std::vector<bool> drawn = drawnByCommands(scene, log);
    std::array<uint64_t, kTriangleStateCount> counts{};
    for (uint64_t triangle = 0; triangle < drawn.size(); ++triangle) {
        const bool dropped = drawn[triangle] && log.facing == Facing::Front && facesAwayFrom(log.camera.eye, scene, triangle);
        TriangleState state = leftOut;
        if (visible[triangle])
            state = drawn[triangle] ? TriangleState::Visible : TriangleState::WronglyCulled;
        else if (drawn[triangle])
            state = dropped ? TriangleState::BackFacing : TriangleState::InVain;
        ++counts[size_t(state)];
    }
    return counts;
}

/// The objects whose boxes the last question of a frame hit, by the boxes' places.
inline std::set<uint32_t> objectsHit(const Scene& scene, const FrameLog& log) {
    const auto asked = std::find_if(log.commands.rbegin(), log.commands.rend(),
                                    [](const Command& command) { return std::holds_alternative<AskedBoxes>(command); });
    std::set<uint32_t> objects;
    if (asked == log.commands.rend()) return objects;
    const AskedBoxes& boxes = std::get<AskedBoxes>(*asked);
    EXPECT_EQ(boxes.boxes.size(), scene.instances().size()) << "no box reaches the near rectangle in these views";
    for (const uint32_t hit : boxes.hits)
        for (uint32_t i = 0; i < scene.instances().size(); ++i)
            if (glm::distance(log.camera.eye + boxes.boxes[hit].centre, scene.instanceBox(i).centre()) < 1e-6) objects.insert(i);
    return objects;
}

}  // namespace cullscope::test
