#pragma once

#include <array>
#include <functional>
#include <optional>

#include "core/base/progress.h"
#include "core/frame/draw_list.h"
#include "core/scene/camera.h"
#include "core/spatial/cut_triangles.h"

namespace cullscope {

/// The tests of Newell, Newell & Sancha (1972) by their numbers: which of them says that a polygon P may be drawn before another
/// one, Q. The first that does ends the comparison.
enum class NewellTest : uint8_t {
    Depth,        ///< Q lies wholly nearer than P, or as near
    ExtentX,      ///< 1: their extents in x are apart
    ExtentY,      ///< 2: those in y are
    BehindQ,      ///< 3: P lies wholly behind the plane of Q, seen from the eye, or in it
    BeforeP,      ///< 4: Q lies wholly on the eye's side of the plane of P, or in it
    Projections,  ///< 5: their projections do not overlap, or P is farther wherever they do
    Swap,         ///< none does: Q is to be drawn before P
    Cycle,        ///< likewise, but Q waits for P itself: one of the polygons that wait for each other is cut
    Pierce        ///< none does and Q is not farther either: they pass through each other, and P is cut
};
inline constexpr size_t kNewellTests = 9;

/// One step of the order, while it is watched. Steps come in the order of the algorithm.
struct NewellStep {
    enum class Kind : uint8_t {
        Taken,     ///< P is the farthest one left, and is compared now
        Again,     ///< P waited for others, and is compared on
        Failed,    ///< a test of P and Q that does not let P come first: the next test follows
        Compared,  ///< the test that ends the comparison of P and Q
        Drawn      ///< P is the next one of PaintersOrder::polygons
    };
    /// Why P is drawn now.
    enum class Cause : uint8_t {
        Free,        ///< nothing is left that has to come before P
        NoSamples,   ///< it covers no sample, so that it is not compared: outside the picture, edge-on, or dropped as back-facing
        ByCentroid,  ///< its centroid is the farthest one left (PaintersOptions::byCentroid): it is compared with none
        GivenUp      ///< rounding alone lets it wait for others
    };
    Kind kind = Kind::Taken;
    NewellTest test = NewellTest::Depth;  ///< of a comparison
    uint32_t p = 0, q = 0;                ///< polygons of the CutTriangles; without a comparison both P
    /// The two numbers that the test compares; without a comparison the first one is P's farthest depth.
    ///  - Depth: P's nearest depth, Q's farthest one.
    ///  - ExtentX, ExtentY: the ends of P and Q that face each other, in pixels; where it fails, the begin and the end of what
    ///    both have.
    ///  - BehindQ: how far P reaches before the plane of Q, seen from the eye, and behind it.
    ///  - BeforeP: how far Q reaches before the plane of P, and behind it.
    ///  - Projections: the thickness of the overlap in pixels, negative where they are apart, and the least that counts as one;
    ///    with `byDepth` the least and the largest difference of P's and Q's inverse depths over the overlap.
    ///  - Swap, Cycle: the farthest depths of P and Q. Pierce: as Projections with `byDepth`.
    double first = 0, second = 0;
    bool byDepth = false;
    Cause cause = Cause::Free;  ///< of Drawn; with ByCentroid `first` is the distance of the centroid
};

struct PaintersOptions {
    Facing facing = Facing::TwoSided;
    bool byCentroid = false;                         ///< sorted by the distance of the centroids alone
    uint64_t limit = 1'000'000;                      ///< of polygons, whole and cut
    std::function<void(const NewellStep&)> watch{};  ///< called for each step; may be empty
    bool watchDrawnOnly = false;                     ///< called for what is drawn alone
};

/// Polygons in the order in which a painter draws them, as seen from an eye.
struct PaintersOrder {
    std::vector<uint32_t> polygons;  ///< of the CutTriangles, far to near
    std::array<uint64_t, kNewellTests> tests{};
    uint64_t unordered = 0;   ///< polygons that cover no sample: outside the picture, edge-on, or dropped as back-facing
    uint64_t unresolved = 0;  ///< polygons drawn before one that rounding alone let wait for them
};

/// Orders all polygons of `triangles` (not cut before) for a view, and cuts those that wait for each other in a cycle or pass
/// through each other. Newell's list is a heap by the farthest depth; what may overlap a polygon is found in a grid over the
/// picture, whose cells list polygons by that depth; a polygon that has to wait is marked and put on a stack, and where one is
/// met that is marked already, all between are a cycle. Every polygon that is cut is cut by the plane of another one at most
/// once, so that this ends. Polygons are compared before the near plane and within the picture. Throws Error(Usage) beyond the
/// limit, Error(Interrupted) on a stop request.
[[nodiscard]] PaintersOrder paintersOrder(CutTriangles& triangles, const Scene& scene, const View& view,
                                          const PaintersOptions& options, const Progress& progress = {});

}  // namespace cullscope
