#pragma once

#include "core/visibility/object_record.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

// What decisions of the spherical strategies found besides their operands. Each hangs at the decision with which it was found
// (FrameContext::attach), so that it is part of the one stream.

/// At the last test of an object's sphere.
struct SphereDetail : DecisionDetail {
    SphereDetail(SphereRelation found, const Vec3& from) : relation(found), eye(from) {}
    SphereRelation relation;
    Vec3 eye;
};

/// At the decision about a corner ray.
struct RayDetail : DecisionDetail {
    RayDetail(size_t number, CornerRay found) : corner(number), ray(std::move(found)) {}
    size_t corner;
    CornerRay ray;
};

/// At the decision about the region between the rays.
struct RegionDetail : DecisionDetail {
    explicit RegionDetail(VisibleRegion found) : region(std::move(found)) {}
    VisibleRegion region;
};

/// Before the decisions about an object's bands, with empty sectors; where there are too many objects to say each band, with all.
struct BandsDetail : DecisionDetail {
    explicit BandsDetail(ContourBands made) : bands(std::move(made)) {}
    ContourBands bands;
};

/// Attaches an object's bands to its record: before their tests without what these find; where the record holds no tests, after
/// them with all of it. Called at both times; `tested`: which one it is. `record`: null: nothing.
inline void attachBands(const ContourBands& bands, bool tested, ObjectRecord* record) {
    if (record != nullptr && record->tests() != tested) record->attach(std::make_shared<BandsDetail>(bands));
}

/// At the end of an object that was decided by cells of maps, where neither its cells nor its ranges of cells were said.
struct RunsDetail : DecisionDetail {
    RunsDetail(std::vector<CellRun> runs, uint64_t triangles) : drawn(std::move(runs)), drawnTriangles(triangles) {}
    std::vector<CellRun> drawn;
    uint64_t drawnTriangles;
};

/// Before the decisions about the cells of an object's quadtree: how they are walked. Of an object that is drawn whole, at its
/// end.
struct WalkDetail : DecisionDetail {
    bool cones = false, horizon = false;
    uint64_t nodesVisited = 0;
    std::vector<Vec3> outline;  ///< of the kernel as seen from the eye, with `horizon`
    uint64_t whole = 0;         ///< triangles of an object that is drawn without a walk; 0: it is walked
};

/// At a decision before those about objects: kernels are asked for the horizon in this frame.
struct KernelsDetail : DecisionDetail {};

/// The decisions about objects that a recorded frame, or the first entries of one, has said, by instance. Everything is read from
/// the stream of decisions; what was not said yet is missing.
[[nodiscard]] std::vector<SphericalDecision> decisionsOf(const FrameLog& log);
/// Whether a recorded frame says that kernels are asked for the horizon.
[[nodiscard]] bool asksKernels(const FrameLog& log);

}  // namespace cullscope::spherical
