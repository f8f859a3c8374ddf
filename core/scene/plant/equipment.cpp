#include "core/scene/plant/equipment.h"

#include <cmath>

#include "core/mesh/primitive/turn.h"

namespace cullscope::plant {
namespace {

using namespace primitive;

constexpr double kGap = 1.6;  ///< between the equipment's nozzles and the row's front, for pipes that rise there

double middleOf(uint32_t place) { return kNozzlePitch * (place + 0.5); }

/// Level nozzles towards the rack at the places' middles, of an upright vessel whose axis is `depth` behind the row's front.
void addLevelNozzles(const Vec3& origin, double inward, uint32_t places, double depth, double radius,
                     const std::vector<double>& heights, std::vector<Nozzle>& nozzles) {
    const double middle = 0.5 * kNozzlePitch * places;
    for (uint32_t place = 0; place < places; ++place) {
        const double across = middleOf(place) - middle;
        const double out = onGrid(std::sqrt(std::max(0.0, radius * radius - across * across)) + 0.25);
        nozzles.push_back(
            {origin + Vec3(middleOf(place), inward * (out - depth), heights[place % heights.size()]), {0.0, inward, 0.0}});
    }
}

void addTopNozzles(const Vec3& origin, double inward, uint32_t places, double depth, double height,
                   std::vector<Nozzle>& nozzles) {
    for (uint32_t place = 0; place < places; ++place)
        nozzles.push_back({origin + Vec3(middleOf(place), -inward * depth, height), {0.0, 0.0, 1.0}});
}

/// Posts and rails of a platform's edge on a circle, over three quarters from the x axis.
void addRoundRail(Solids& solids, double radius, Angle sweep) {
    constexpr int kPosts = 9;
    const int last = isWholeTurn(sweep) ? kPosts - 1 : kPosts;
    for (const double height : {0.55, 1.1}) solids.push_back({CircularTorus{radius, 0.02, sweep}, at(0, 0, height)});
    for (int post = 0; post <= last; ++post) {
        const Vec2 place = radius * onCircle(sweep * (double(post) / kPosts));
        solids.push_back(box(Vec3(place, 0.54), {0.04, 0.04, 1.08}));
    }
}

void addColumn(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const uint32_t variant = below(random, 3);
    const double radius = variant == 0 ? 0.9 : 1.2, height = variant == 2 ? 24.0 : 18.0, skirt = 2.5;
    const double narrow = variant == 1 ? 0.9 : radius, depth = kGap + radius;
    const Vec3 foot = origin + Vec3(kNozzlePitch, -inward * depth, 0.0);
    kit.add({"column", variant}, 24, at(foot.x, foot.y, foot.z), [&] {
        const double lower = 0.6 * height, cone = radius > narrow ? 1.0 : 0.0, upper = height - lower - cone;
        Solids solids{{HollowCylinder{radius - 0.02, radius + 0.005, skirt}, at(0, 0, 0.5 * skirt)},
                      {HollowCylinder{radius - 0.03, radius + 0.2, 0.04}, at(0, 0, 0.02)},
                      {EllipsoidalDish{radius - kLip, 0.5 * radius}, frame({0, 0, skirt}, {0, 0, -1})},
                      {Cylinder{radius, lower}, at(0, 0, skirt + 0.5 * lower)},
                      {Cylinder{narrow - kLip, upper}, at(0, 0, skirt + lower + cone + 0.5 * upper)},
                      {EllipsoidalDish{narrow - 2.0 * kLip, 0.5 * narrow}, at(0, 0, skirt + height)}};
        if (cone > 0.0) solids.push_back({Cone{radius - kLip, narrow, cone}, at(0, 0, skirt + lower + 0.5 * cone)});
        return solids;
    });
    // Platforms are open to the rack's side, where the pipes rise.
    const std::vector<double> floors = variant == 2 ? std::vector{8.0, 14.0, 20.0, 26.0} : std::vector{8.0, 14.0, 20.0};
    for (const double floor : floors) {
        const double own = floor > skirt + 0.6 * height ? narrow : radius;
        const double turn = inward > 0.0 ? 1.0 : -1.0;
        addRingPlatform(kit, frame(foot + Vec3(0, 0, floor), {0, 0, 1}, {std::sqrt(0.5) * -turn, std::sqrt(0.5) * turn, 0}),
                        own + 0.05, own + 1.1);
        kit.add({"manhole", 0}, 12, frame(foot + Vec3(0, -inward * own, floor + 0.9), {0, -inward, 0}), [] {
            return Solids{{HollowCylinder{0.28, 0.3, 0.5}}, {Cylinder{0.4, 0.05}, at(0, 0, 0.26)}, {Disc{0.3}, at(0, 0, 0.29)}};
        });
    }
    addLadder(kit, frame(foot + Vec3(radius + 0.25, -inward * 0.5, 0), {0, 0, 1}, {1, 0, 0}), floors.back());
    addLevelNozzles(origin, inward, 2, depth, radius, below(random, 2) == 0 ? std::vector{1.4, 12.4} : std::vector{12.4, 3.0},
                    nozzles);
}

void addDrum(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const uint32_t variant = below(random, 2);
    const double radius = variant == 0 ? 0.7 : 0.9, length = 5.2, axis = 2.2, depth = kGap;
    const double middle = 2.0 * kNozzlePitch;
    kit.add({"drum", variant}, 24, at(origin.x + middle, origin.y - inward * depth, origin.z), [&] {
        const TorisphericalHead head{radius - kLip, 2.0 * radius, 0.2 * radius};
        Solids solids{{Cylinder{radius, length}, alongX(0, 0, axis)},
                      {head, alongX(0.5 * length, 0, axis)},
                      {head, frame({-0.5 * length, 0, axis}, {-1, 0, 0})}};
        for (const double side : {-1.0, 1.0}) {
            const double x = 0.3 * side * length, height = axis - 0.7 * radius;
            solids.push_back(box({x, 0, 0.5 * height}, {0.25, 1.5 * radius, height}));
            for (const double edge : {-1.0, 1.0})
                solids.push_back({Wedge{{0.4, 0.2, height - 0.4}},
                                  frame({x, edge * (0.75 * radius + 0.2), 0.5 * (height - 0.4)}, {0, 0, 1}, {0, -edge, 0})});
        }
        return solids;
    });
    addTopNozzles(origin, inward, 4, depth, onGrid(axis + radius + 0.3), nozzles);
    const double floor = 2.6, width = 1.0;
    kit.add({"platform", 1000 + variant}, 8,
            frame(origin + Vec3(middle, -inward * (depth + radius + 0.1 + 0.5 * width), floor), {0, 0, 1}, {-inward, 0, 0}), [&] {
                Solids solids{box({0, 0, -0.03}, {length, width, 0.06}), box({0, 0.5 * width, 0.08}, {length, 0.01, 0.15})};
                for (const double height : {0.55, 1.1})
                    solids.push_back({Cylinder{0.02, length}, alongX(0, 0.5 * width, height)});
                for (int post = 0; post <= 4; ++post)
                    solids.push_back(box({length * (post / 4.0 - 0.5), 0.5 * width, 0.54}, {0.04, 0.04, 1.08}));
                for (const double x : {-0.45, 0.45})
                    for (const double y : {-0.4, 0.4})
                        solids.push_back(box({x * length, y, -0.5 * floor - 0.03}, {0.1, 0.1, floor - 0.06}));
                return solids;
            });
    addLadder(
        kit, frame(origin + Vec3(middle + 0.4 * length, -inward * (depth + radius + 0.3 + width), 0), {0, 0, 1}, {0, -inward, 0}),
        floor);
}

void addExchanger(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const uint32_t variant = below(random, 2);
    const double radius = variant == 0 ? 0.4 : 0.5, length = 3.4, depth = kGap - 0.4, top = 2.4;
    kit.add({"exchanger", variant}, 16, at(origin.x + 1.5 * kNozzlePitch, origin.y - inward * depth, origin.z), [&] {
        Solids solids;
        for (const double axis : {top - 2.0 * radius - 0.35, top}) {
            solids.push_back({Cylinder{radius, length}, alongX(0, 0, axis)});
            solids.push_back({EllipsoidalDish{radius - kLip, 0.5 * radius}, alongX(0.5 * length, 0, axis)});
            solids.push_back({Cylinder{radius - kLip, 0.5}, alongX(-0.5 * length - 0.25, 0, axis)});
            solids.push_back(
                {SphericalDish{radius - 2.0 * kLip, 0.3 * radius}, frame({-0.5 * length - 0.5, 0, axis}, {-1, 0, 0})});
            for (const double x : {-0.5 * length - 0.5, -0.5 * length, 0.5 * length - 0.1})
                solids.push_back({Cylinder{radius + 0.08, 0.1}, alongX(x, 0, axis)});
            for (const double x : {-0.3, 0.3})
                solids.push_back(box({x * length, 0, axis - radius - 0.1}, {0.2, 1.2 * radius, 0.45}));
        }
        for (const double x : {-0.3, 0.3})
            solids.push_back(
                box({x * length, 0, 0.5 * (top - 3.0 * radius - 0.6)}, {0.35, 1.5 * radius, top - 3.0 * radius - 0.6}));
        return solids;
    });
    addTopNozzles(origin, inward, 3, depth, onGrid(top + radius + 0.3), nozzles);
}

void addPump(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const uint32_t variant = below(random, 2);
    const double scale = variant == 0 ? 1.0 : 1.25, depth = 0.4;
    kit.add({"pump", variant}, 12, frame(origin + Vec3(0.5 * kNozzlePitch, -inward * depth, 0), {0, 0, 1}, {0, -inward, 0}), [&] {
        const double axis = 0.3 + 0.3 * scale;
        return Solids{{PyramidFrustum{{2.0, 0.9}, {1.8, 0.7}, 0.3}, at(0.7, 0, 0.15)},
                      box({0.7, 0, 0.33}, {1.7, 0.6, 0.06}),
                      {Cylinder{0.24 * scale, 0.22 * scale}, alongX(0, 0, axis)},
                      {Cone{0.16 * scale, 0.08 * scale, 0.4}, alongX(0.3, 0, axis)},
                      {Cylinder{0.03, 0.4}, alongX(0.6, 0, axis)},
                      {Cylinder{0.2 * scale, 0.7}, alongX(1.1, 0, axis)},
                      {EllipsoidalDish{0.19 * scale, 0.08}, alongX(1.45, 0, axis)},
                      box({1.1, 0.2 * scale, axis}, {0.3, 0.15, 0.2}),
                      box({1.1, 0, 0.5 * (0.36 + axis - 0.15 * scale)}, {0.5, 0.3 * scale, axis - 0.15 * scale - 0.36}),
                      {Cylinder{0.08 * scale, 0.4}, at(0, 0, axis + 0.3 * scale)}};
    });
    if (variant == 1)
        kit.add({"shelter", 0}, 8, at(origin.x + 0.5 * kNozzlePitch, origin.y - inward * (depth + 1.2), origin.z), [] {
            Solids solids{{Pyramid{{1.3, 1.3}, 0.4}, at(0, 0, 2.6)}};
            for (const double x : {-0.55, 0.55})
                for (const double y : {-0.55, 0.55}) solids.push_back({Cylinder{0.03, 2.4}, at(x, y, 1.2)});
            return solids;
        });
    addTopNozzles(origin, inward, 1, depth, 1.3, nozzles);
}

void addTank(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const uint32_t variant = below(random, 2);
    const double radius = 2.8, height = variant == 0 ? 5.0 : 7.0, depth = kGap + radius;
    const Vec3 foot = origin + Vec3(2.0 * kNozzlePitch, -inward * depth, 0.0);
    kit.add({"tank", variant}, 32, at(foot.x, foot.y, foot.z), [&] {
        return Solids{{Cylinder{radius + 0.3, 0.3}, at(0, 0, 0.15)},
                      {Cylinder{radius, height}, at(0, 0, 0.3 + 0.5 * height)},
                      {SphericalDish{radius - kLip, 0.5}, at(0, 0, 0.3 + height)},
                      {RectangularTorus{radius, radius + 0.1, 0.1}, at(0, 0, height)},
                      {Cylinder{0.15, 0.4}, at(0.5, 0, 1.0 + height)}};
    });
    kit.add({"roof rail", variant}, 12, at(foot.x, foot.y, 0.3 + height), [&] {
        Solids solids;
        addRoundRail(solids, radius - 0.05, Angle::fromDegrees(360));
        return solids;
    });
    kit.add({"stairs", variant}, 8, frame(foot, {0, 0, 1}, {-inward, 0, 0}), [&] {
        Solids solids;
        const auto steps = int(std::nearbyint(height / 0.22));
        for (int step = 0; step < steps; ++step) {
            const Vec2 out = onCircle(uint64_t(step), 120);
            solids.push_back(
                {Box{{0.7, 0.25, 0.04}}, frame(Vec3((radius + 0.4) * out, 0.3 + 0.22 * (step + 1)), {0, 0, 1}, Vec3(out, 0))});
            if (step % 3 == 0)
                solids.push_back(
                    {Cylinder{0.02, 1.0}, at((radius + 0.74) * out.x, (radius + 0.74) * out.y, 0.8 + 0.22 * (step + 1))});
        }
        return solids;
    });
    kit.add({"sign", 0}, 12, frame(origin + Vec3(0.4, -inward * 0.2, 0), {0, 0, 1}, {0, inward, 0}), [] {
        return Solids{
            {Cylinder{0.03, 1.8}, at(0, 0, 0.9)}, {Disc{0.25}, alongX(0.04, 0, 1.7)}, {Ring{0.26, 0.3}, alongX(0.04, 0, 1.7)}};
    });
    addLevelNozzles(origin, inward, 4, depth, radius, {0.8}, nozzles);
}

void addSphere(Kit& kit, Random&, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const double radius = 2.6, axis = 3.6, depth = kGap + radius;
    const Vec3 foot = origin + Vec3(2.0 * kNozzlePitch, -inward * depth, 0.0);
    kit.add({"spherical tank", 0}, 24, at(foot.x, foot.y, foot.z), [&] {
        Solids solids{{primitive::Sphere{radius}, at(0, 0, axis)}};
        for (uint64_t leg = 0; leg < 8; ++leg) {
            const Vec2 place = 0.92 * radius * onCircle(2 * leg + 1, 16);
            solids.push_back({Cylinder{0.15, axis}, at(place.x, place.y, 0.5 * axis)});
            solids.push_back({PyramidFrustum{{0.8, 0.8}, {0.5, 0.5}, 0.3}, at(place.x, place.y, 0.15)});
            const Vec2 next = 0.92 * radius * onCircle(2 * leg + 3, 16);
            solids.push_back(rod(Vec3(place, 0.5), Vec3(next, axis - 0.8), 0.03));
        }
        return solids;
    });
    addRingPlatform(kit, frame(foot + Vec3(0, 0, axis + radius), {0, 0, 1}, {-1, 0, 0}), 0.3, 1.2);
    addLevelNozzles(origin, inward, 4, depth, radius, {axis}, nozzles);
}

void addVerticalDrum(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles) {
    const uint32_t variant = below(random, 2);
    const double radius = variant == 0 ? 0.85 : 1.0, height = 3.0, low = 0.9, depth = kGap + radius;
    const Vec3 foot = origin + Vec3(kNozzlePitch, -inward * depth, 0.0);
    kit.add({"vessel", variant}, 24, at(foot.x, foot.y, foot.z), [&] {
        const TorisphericalHead head{radius - kLip, 1.6 * radius, 0.3 * radius};
        Solids solids{{Cylinder{radius, height}, at(0, 0, low + 0.5 * height)},
                      {head, at(0, 0, low + height)},
                      {head, frame({0, 0, low}, {0, 0, -1})},
                      {Cylinder{0.3, 0.5}, at(0, 0, low + height + 0.35 * radius)}};
        for (uint64_t leg = 0; leg < 4; ++leg) {
            const Vec2 place = (radius + 0.04) * onCircle(2 * leg + 1, 8);
            solids.push_back(box(Vec3(place, 0.75), {0.12, 0.12, 1.5}));
        }
        return solids;
    });
    addLevelNozzles(origin, inward, 2, depth, radius, {1.4, 2.2}, nozzles);
}

}  // namespace

const std::vector<EquipmentKind>& equipmentKinds() {
    static const std::vector<EquipmentKind> kKinds{{"C", 2, 3, addColumn},      {"D", 4, 3, addDrum}, {"E", 3, 5, addExchanger},
                                                   {"P", 1, 4, addPump},        {"T", 4, 2, addTank}, {"S", 4, 1, addSphere},
                                                   {"V", 2, 3, addVerticalDrum}};
    return kKinds;
}

void addRingPlatform(Kit& kit, const Mat4& place, double inner, double outer) {
    kit.add({"platform", uint32_t(millimetres(inner)), millimetres(outer)}, 10, place, [&] {
        const Angle sweep = Angle::fromDegrees(270);
        Solids solids{{RectangularTorus{inner, outer, 0.06, sweep}, at(0, 0, -0.03)}};
        addRoundRail(solids, outer - 0.03, sweep);
        return solids;
    });
}

void addLadder(Kit& kit, const Mat4& foot, double height) {
    kit.add({"ladder", 0, millimetres(height)}, 8, foot, [&] {
        Solids solids;
        for (const double side : {-0.225, 0.225})
            solids.push_back(box({0, side, 0.5 * (height + 1.0)}, {0.06, 0.012, height + 1.0}));
        for (int rung = 1; 0.3 * rung < height + 0.9; ++rung) solids.push_back(box({0, 0, 0.3 * rung}, {0.025, 0.45, 0.025}));
        return solids;
    });
}

}  // namespace cullscope::plant
