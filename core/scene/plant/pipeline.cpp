#include "core/scene/plant/pipeline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/scene/plant/steel.h"

namespace cullscope::plant {
namespace {

constexpr double kShoe = 0.1;           ///< height of a pipe's bottom above its beam
constexpr uint32_t kLargestNarrow = 6;  ///< the largest size for the lower tiers: 200 mm
constexpr uint32_t kSmall = 2;          ///< 50 mm: fits where there is hardly room for elbows

double floorOnGrid(double length) { return std::floor(20.0 * length + 1e-6) / 20.0; }

/// In per cent, smallest first.
constexpr std::array<uint32_t, 11> kShare{11, 13, 18, 16, 13, 12, 7, 4, 3, 2, 1};

uint32_t drawnSize(Random& random) {
    uint32_t drawn = below(random, 100);
    for (uint32_t size = 0; size < kShare.size(); ++size) {
        if (drawn < kShare[size]) return size;
        drawn -= kShare[size];
    }
    return 0;
}

Lane& freeLane(std::vector<Lane>& lanes, bool wide) {
    auto lane = std::ranges::find_if(lanes, [&](const Lane& each) { return !each.taken && (each.tier == 2) == wide; });
    if (lane == lanes.end()) lane = std::ranges::find_if(lanes, [](const Lane& each) { return !each.taken; });
    assert(lane != lanes.end());
    lane->taken = true;
    return *lane;
}

/// What is built into a straight part.
struct BuiltIn {
    enum class Kind { Valve, Tee } kind = Kind::Valve;
    uint32_t valve = 0;
};

/// One size of pipe along corners of its middle line, from corner to corner parallel to an axis.
struct Run {
    uint32_t size = 0;
    std::vector<Vec3> corners;
    bool fromFlange = true, toFlange = true;
    size_t builtInAt = 0;  ///< the straight part, by its first corner
    std::vector<BuiltIn> builtIn;
};

double lengthOf(const BuiltIn& part, const PipeSize& size) {
    return part.kind == BuiltIn::Kind::Valve ? size.valveStation() : size.teeLength();
}

void addStraight(PipeFitter& fitter, const Run& run, Vec3 from, const Vec3& along, double length, bool withBuiltIn) {
    const PipeSize& size = pipeSizes()[run.size];
    const Vec3 up = std::abs(along.z) > 0.5 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    if (withBuiltIn)
        for (const BuiltIn& part : run.builtIn) {
            const double own = lengthOf(part, size), before = floorOnGrid(std::min(0.4 * (length - own), 1.5));
            if (length < own + 0.2) continue;
            fitter.pipe(run.size, from, along, before);
            from += along * before;
            if (part.kind == BuiltIn::Kind::Valve)
                fitter.valve(run.size, part.valve, from, along, up);
            else
                fitter.tee(run.size, from, along, up);
            from += along * own;
            length -= before + own;
        }
    fitter.pipe(run.size, from, along, length);
}

void addRun(PipeFitter& fitter, const Run& run) {
    const PipeSize& size = pipeSizes()[run.size];
    for (size_t i = 0; i + 1 < run.corners.size(); ++i) {
        const Vec3 way = run.corners[i + 1] - run.corners[i];
        const double whole = glm::length(way);
        const Vec3 along = way / whole;
        const bool first = i == 0, last = i + 2 == run.corners.size();
        const double before = first ? (run.fromFlange ? size.flangeLength() : 0.0) : size.bend();
        const double after = last ? (run.toFlange ? size.flangeLength() : 0.0) : size.bend();
        if (first && run.fromFlange) fitter.flange(run.size, run.corners[i], along);
        addStraight(fitter, run, run.corners[i] + along * before, along, whole - before - after, i == run.builtInAt);
        if (last && run.toFlange) fitter.flange(run.size, run.corners[i + 1], -along);
        if (!last) fitter.elbow(run.size, run.corners[i + 1], along, glm::normalize(run.corners[i + 2] - run.corners[i + 1]));
    }
}

/// From a nozzle to above its lane on the rack, at the height `cross`; the lane's own corner is left to the caller.
std::vector<Vec3> wayToLane(const Nozzle& nozzle, const PipeSize& size, double cross, double lane) {
    std::vector<Vec3> corners{nozzle.face};
    Vec3 place = nozzle.face;
    if (nozzle.out.z == 0.0) {
        place += nozzle.out * onGrid(size.bend() + size.flangeLength() + 0.25);
        corners.push_back(place);
    }
    corners.emplace_back(place.x, place.y, cross);
    corners.emplace_back(place.x, lane, cross);
    return corners;
}

void addShoes(PipeFitter& fitter, uint32_t size, const Vec3& corner, const Vec3& from, const Vec3& to) {
    const double room = pipeSizes()[size].bend();
    const auto bays = int(kUnitLength / kBay);
    for (int bay = 0; bay <= bays; ++bay) {
        const double x = corner.x + bay * kBay;
        if (x > std::min(from.x, to.x) + room && x < std::max(from.x, to.x) - room)
            fitter.shoe(size, {x, from.y, from.z}, {1, 0, 0});
    }
}

}  // namespace

std::vector<Lane> lanesOfRack() {
    std::vector<Lane> lanes;
    for (uint32_t tier = 0; tier < kTiers.size(); ++tier) {
        const double pitch = tier < 2 ? 0.45 : 0.8;
        for (double y = -3.4; y < 3.45; y += pitch) lanes.push_back({tier, onGrid(y)});
    }
    return lanes;
}

void addPipeline(PipeFitter& fitter, Random& random, const Vec3& corner, const Nozzle& from, const Nozzle& to,
                 std::vector<Lane>& lanes) {
    const double apart = std::abs(to.face.x - from.face.x);
    uint32_t size = drawnSize(random);
    if (apart < 2.0 * pipeSizes()[size].bend() + 0.1) size = std::min(size, kSmall);
    const PipeSize& pipe = pipeSizes()[size];
    const Lane& lane = freeLane(lanes, size > kLargestNarrow);
    const double y = corner.y + lane.y, z = kTiers[lane.tier] + kShoe + pipe.radius();
    // Across the rack above the pipes that lie on it: an elbow up to there and one down.
    const double cross = onGrid(z + std::max(0.75, 2.0 * pipe.bend() + 0.15));

    Run run{size, wayToLane(from, pipe, cross, y), true, true, 0, {}};
    std::vector<Vec3> back = wayToLane(to, pipe, cross, y);
    const Vec3 begin(run.corners.back().x, y, z);
    Vec3 end(back.back().x, y, z);
    fitter.nozzle(size, from.face, from.out);
    fitter.joint(size, from.face, from.out);
    run.corners.push_back(begin);
    run.builtInAt = run.corners.size() - 1;
    const double straight = std::abs(end.x - begin.x) - 2.0 * pipe.bend();
    if (below(random, 100) < 60) run.builtIn.push_back({BuiltIn::Kind::Valve, below(random, 3)});
    if (below(random, 100) < 40) run.builtIn.push_back({BuiltIn::Kind::Tee, 0});
    double wanted = 1.0 + pipe.reducerLength();
    for (const BuiltIn& part : run.builtIn) wanted += lengthOf(part, pipe) + 1.5;

    uint32_t last = size;
    if (size > 0 && straight > wanted && below(random, 100) < 25) {
        last = size - 1;
        const PipeSize& narrow = pipeSizes()[last];
        const Vec3 along(end.x > begin.x ? 1.0 : -1.0, 0.0, 0.0);
        const Vec3 reduced(
            begin.x + along.x * onGrid(pipe.bend() + std::max(wanted - 0.5, 0.6 * straight) - pipe.reducerLength()), y, z);
        run.corners.push_back(reduced);
        run.toFlange = false;
        addRun(fitter, run);
        fitter.reducer(size, last, reduced, along);
        addShoes(fitter, size, corner, begin, reduced);
        const Vec3 narrowed = reduced + along * pipe.reducerLength() - Vec3(0, 0, pipe.radius() - narrow.radius());
        run = {last, {narrowed}, false, true, 0, {}};
        end.z = narrowed.z;
        addShoes(fitter, last, corner, narrowed, end);
    } else {
        addShoes(fitter, size, corner, begin, end);
    }
    run.corners.push_back(end);
    run.corners.insert(run.corners.end(), back.rbegin(), back.rend());
    addRun(fitter, run);
    fitter.nozzle(last, to.face, to.out);
    fitter.joint(last, to.face, to.out);
}

}  // namespace cullscope::plant
