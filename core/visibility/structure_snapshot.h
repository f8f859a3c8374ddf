#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frame/frame_log.h"
#include "core/geometry/bounds.h"

namespace cullscope {

/// A box that a strategy tests: that of an object, or of a group of objects.
struct SnapshotNode {
    static constexpr uint32_t kGroup = 0xFFFFFFFF;

    int32_t parent = -1;    ///< index into StructureSnapshot::nodes; -1: a root
    uint32_t instance = 0;  ///< kGroup: a group
    uint32_t number = 0;    ///< of a group: its number in the structure, as decisions have it
    std::string name{};     ///< of a group: what it is called; empty: nothing but its number
    uint32_t objects = 1;   ///< number of objects in it
    Box3 box;               ///< world coordinates
    uint64_t triangles = 0;
    bool culled = false;
    Cause cause = Cause::OutsideFrustum;  ///< with `culled`
    Containment containment = Containment::Straddles;
    bool tested = false;  ///< the frame said a test of it by itself (markTested)
    bool reached = true;  ///< false in a part of a frame that says nothing yet of it or of what it holds (markReached)
    std::optional<FrustumPlane> rejectedBy;  ///< the plane that culled it; none: no single plane did

    [[nodiscard]] bool isGroup() const { return instance == kGroup; }
};

class SubjectPlaces;

/// What only one family has in its snapshot. Only the family's own files know the derived type.
struct StructureDetails {
    virtual ~StructureDetails() = default;
};

/// A strategy's structures and their results after a cull, as plain data, for display.
struct StructureSnapshot {
    std::vector<SnapshotNode> nodes;  ///< empty: this strategy has no boxes
    /// The sentence about an object's bounds, English and marked for translation: %1 is the object's name, %2 the number of its
    /// triangles. Null: "tested as one box".
    const char* objectSentence = nullptr;
    /// The sentence about a group that was neither left out nor kept as a whole: %1 is the number of its objects. Null: "reaches
    /// over the edge of the frustum".
    const char* groupSentence = nullptr;
    /// What a group with a name is called in a list, English and marked for translation: %1 is its name, %2 the number of its
    /// objects. Null: "%1: %2 objects".
    const char* groupName = nullptr;
    std::shared_ptr<const StructureDetails> details;  ///< null: there is nothing more
    std::shared_ptr<const SubjectPlaces> places;      ///< where subjects lie that only the strategy can place; null: none
};

/// Sets SnapshotNode::tested by the tests that a recorded frame said.
void markTested(StructureSnapshot& snapshot, const FrameLog& log);
/// Sets SnapshotNode::reached by what the first entries of a recorded frame said; of a whole frame every node is reached.
void markReached(StructureSnapshot& snapshot, const FrameLog& log);

}  // namespace cullscope
