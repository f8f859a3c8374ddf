#include "core/scene/plant/pipe_fittings.h"

#include <cmath>

#include "core/mesh/primitive/turn.h"

namespace cullscope::plant {
namespace {

using namespace primitive;

constexpr double kLongestPipe = 12.0;
constexpr int kMitred = 400;      ///< elbows of this nominal size and above are welded of mitred pieces
constexpr int kWithGasket = 150;  ///< below it the gasket is not modelled
constexpr double kShoeHeight = 0.1;

Solids elbowSolids(const PipeSize& size) { return {{CircularTorus{size.bend(), size.radius(), Angle::fromDegrees(90)}}}; }

/// Of three pieces that meet at half of 45°; in comes z, out goes x, the corner is the origin.
Solids mitredElbow(const PipeSize& size) {
    const double bend = size.bend(), cut = 0.55 * bend, half = std::sqrt(0.5);
    const Mitre begins{Angle::fromDegrees(22.5), {}}, ends{Angle::fromDegrees(-22.5), {}};
    const Vec3 in(0.0, 0.0, 1.0), out(1.0, 0.0, 0.0);
    const double straight = bend - cut, between = cut / half;
    return {{MitredCylinder{size.radius(), straight, {}, ends}, frame(-in * (cut + 0.5 * straight), in, out)},
            {MitredCylinder{size.radius() + kLip, between, begins, ends},
             frame(0.5 * cut * (out - in), half * (in + out), half * (out - in))},
            {MitredCylinder{size.radius(), straight, begins, {}}, frame(out * (cut + 0.5 * straight), out, -in)}};
}

/// The face lies in z = 0.
Solids flangeSolids(const PipeSize& size) {
    const double thickness = 0.001 * size.thickness, neck = 0.001 * size.neck();
    return {{Cylinder{0.0005 * size.flange, thickness}, at(0, 0, 0.5 * thickness)},
            {Cone{1.3 * size.radius(), size.radius(), neck}, at(0, 0, thickness + 0.5 * neck)}};
}

Solids nozzleSolids(const PipeSize& size) {
    constexpr double kNeck = 0.35;
    const double thickness = 0.001 * size.thickness;
    return {{Cylinder{0.0005 * size.flange, thickness}, at(0, 0, -0.5 * thickness)},
            {Cylinder{size.radius(), kNeck}, at(0, 0, -thickness - 0.5 * kNeck)}};
}

/// A stud with a nut at each end, about the middle between two flanges.
Solids boltSolids(const PipeSize& size) {
    const double diameter = 0.001 * size.bolt, nut = 0.8 * diameter, toNut = 0.001 * size.thickness;
    return {{Cylinder{0.5 * diameter, 2.0 * (toNut + nut) + 0.6 * diameter}},
            {Prism{6, 0.9 * diameter, nut}, at(0, 0, toNut + 0.5 * nut)},
            {Prism{6, 0.9 * diameter, nut}, at(0, 0, -toNut - 0.5 * nut)}};
}

/// The parts of a valve above its body: the stem points along x.
void addOperator(Solids& solids, const PipeSize& size, uint32_t kind, double middle) {
    const double r = size.radius();
    if (kind == 1) {  // a ball valve's lever
        solids.push_back({Cylinder{0.25 * r, r + 0.03}, alongX(1.6 * r + 0.015, 0, middle)});
        solids.push_back(box({2.1 * r + 0.04, 0, middle + 1.5 * r + 0.04}, {0.012, 0.025, 3.0 * r + 0.12}));
        return;
    }
    solids.push_back({Cylinder{0.9 * r, 1.2 * r}, alongX(1.9 * r, 0, middle)});
    solids.push_back({Cylinder{1.2 * r, 0.3 * r}, alongX(2.6 * r, 0, middle)});
    if (kind == 2) {  // a control valve's yoke and its actuator
        solids.push_back(
            {PyramidFrustum{{0.8 * r, 1.2 * r}, {0.5 * r, 0.8 * r}, 1.6 * r + 0.1}, alongX(3.5 * r + 0.05, 0, middle)});
        const double base = 4.4 * r + 0.1, actuator = 1.8 * r + 0.06;
        solids.push_back({EllipsoidalDish{actuator - kLip, 0.5 * actuator}, alongX(base, 0, middle)});
        solids.push_back({EllipsoidalDish{actuator, 0.5 * actuator}, frame({base, 0, middle}, {-1, 0, 0}, {0, 1, 0})});
        return;
    }
    const double wheel = 1.4 * r + 0.04, height = 4.5 * r + 0.1;  // a gate valve's stem and handwheel
    solids.push_back({Cylinder{0.18 * r + 0.004, height - 2.6 * r}, alongX(0.5 * (height + 2.6 * r), 0, middle)});
    solids.push_back({CircularTorus{wheel, 0.08 * wheel}, alongX(height, 0, middle)});
    solids.push_back(box({height, 0, middle}, {0.01, 2.0 * wheel, 0.02}));
    solids.push_back(box({height, 0, middle}, {0.01, 0.02, 2.0 * wheel}));
}

/// From z = 0 to its length.
Solids valveSolids(const PipeSize& size, uint32_t kind) {
    const double r = size.radius(), length = size.valveLength(), thickness = 0.001 * size.thickness, middle = 0.5 * length;
    const double half = middle - thickness;
    Solids solids{{Cylinder{0.0005 * size.flange, thickness}, at(0, 0, 0.5 * thickness)},
                  {Cylinder{0.0005 * size.flange, thickness}, at(0, 0, length - 0.5 * thickness)}};
    if (kind == 1) {
        solids.push_back({Cylinder{1.05 * r, 2.0 * half}, at(0, 0, middle)});
        solids.push_back({primitive::Sphere{1.5 * r}, at(0, 0, middle)});
    } else {
        solids.push_back({Cone{1.1 * r, 1.5 * r, half}, at(0, 0, thickness + 0.5 * half)});
        solids.push_back({Cone{1.5 * r - kLip, 1.1 * r, half}, at(0, 0, length - thickness - 0.5 * half)});
    }
    addOperator(solids, size, kind, middle);
    return solids;
}

/// A saddle of plates below a pipe along x whose middle line is y = z = 0, and a clip over it.
Solids shoeSolids(const PipeSize& size) {
    const double r = size.radius(), low = -r - kShoeHeight;
    Solids solids{box({0, 0, low + 0.006}, {0.25, 0.12, 0.012}),
                  box({0, 0, low + 0.5 * kShoeHeight}, {0.25, 0.012, kShoeHeight})};
    if (size.nominal > 100) {
        solids.push_back({Wedge{{0.1, 0.014, kShoeHeight}}, at(-0.175, 0, low + 0.5 * kShoeHeight)});
        return solids;
    }
    // Half a ring, from y to −y over the pipe.
    solids.push_back({CircularTorus{r + 0.006, 0.006, Angle::fromDegrees(180)}, frame({0, 0, 0}, {1, 0, 0}, {0, 1, 0})});
    return solids;
}

}  // namespace

const std::vector<PipeSize>& pipeSizes() {
    static const std::vector<PipeSize> kSizes{
        {25, 34, 108, 14, 4, 80, 14},     {40, 48, 128, 18, 4, 98, 14},     {50, 60, 152, 19, 4, 120, 16},
        {80, 88, 190, 24, 4, 152, 16},    {100, 114, 228, 24, 8, 190, 16},  {150, 168, 280, 26, 8, 242, 20},
        {200, 218, 342, 29, 8, 298, 20},  {250, 274, 406, 30, 12, 362, 24}, {300, 324, 482, 32, 12, 432, 24},
        {400, 406, 598, 36, 16, 540, 27}, {500, 508, 698, 42, 20, 636, 30}};
    return kSizes;
}

void PipeFitter::pipe(uint32_t size, const Vec3& from, const Vec3& along, double length) {
    const PipeSize& pipe = pipeSizes()[size];
    double done = 0.0;
    while (millimetres(length - done) > 0) {
        const double piece = std::min(length - done, kLongestPipe);
        m_kit.add({"pipe", size, millimetres(piece)}, pipe.segments(), frame(from + along * (done + 0.5 * piece), along), [&] {
            return Solids{{Cylinder{pipe.radius(), piece}}};
        });
        done += piece;
    }
}

void PipeFitter::elbow(uint32_t size, const Vec3& corner, const Vec3& in, const Vec3& out) {
    const PipeSize& pipe = pipeSizes()[size];
    if (pipe.nominal >= kMitred)
        m_kit.add({"mitre bend", size}, pipe.segments(), frame(corner, in, out), [&] { return mitredElbow(pipe); });
    else
        m_kit.add({"elbow", size}, pipe.segments(), frame(corner + pipe.bend() * (out - in), glm::cross(in, out), -out),
                  [&] { return elbowSolids(pipe); });
}

void PipeFitter::flange(uint32_t size, const Vec3& face, const Vec3& pipe) {
    m_kit.add({"flange", size}, pipeSizes()[size].segments(), frame(face, pipe), [&] { return flangeSolids(pipeSizes()[size]); });
}

void PipeFitter::joint(uint32_t size, const Vec3& face, const Vec3& along) {
    const PipeSize& pipe = pipeSizes()[size];
    const Mat4 plane = frame(face, along);
    for (int bolt = 0; bolt < pipe.bolts; ++bolt) {
        // Two bolts beside the plane's axes, as flanges have them.
        const Vec2 place = 0.0005 * pipe.circle * onCircle(uint64_t(2 * bolt + 1), uint64_t(2 * pipe.bolts));
        Mat4 own = plane;
        own[3] = plane * Vec4(place, 0.0, 1.0);
        m_kit.add({"bolt", size}, kHexagon, own, [&] { return boltSolids(pipe); });
    }
    if (pipe.nominal >= kWithGasket)
        m_kit.add({"gasket", size}, pipe.segments(), plane, [&] {
            return Solids{{HollowCylinder{pipe.radius(), 0.0005 * (pipe.circle - pipe.bolt), 0.003}}};
        });
}

void PipeFitter::nozzle(uint32_t size, const Vec3& face, const Vec3& out) {
    m_kit.add({"nozzle", size}, pipeSizes()[size].segments(), frame(face, out), [&] { return nozzleSolids(pipeSizes()[size]); });
}

void PipeFitter::valve(uint32_t size, uint32_t kind, const Vec3& from, const Vec3& along, const Vec3& stem) {
    const PipeSize& pipe = pipeSizes()[size];
    const Vec3 first = from + along * pipe.flangeLength(), second = first + along * pipe.valveLength();
    flange(size, first, -along);
    joint(size, first, along);
    m_kit.add({"valve", size, int64_t(kind)}, pipe.segments(), frame(first, along, stem),
              [&] { return valveSolids(pipe, kind); });
    joint(size, second, along);
    flange(size, second, along);
}

void PipeFitter::reducer(uint32_t size, uint32_t smaller, const Vec3& from, const Vec3& along) {
    const PipeSize &wide = pipeSizes()[size], &narrow = pipeSizes()[smaller];
    const double length = wide.reducerLength(), drop = wide.radius() - narrow.radius();
    const Vec3 up(0.0, 0.0, 1.0);
    m_kit.add({"reducer", size, int64_t(smaller)}, wide.segments(),
              frame(from + along * (0.5 * length) - up * (0.5 * drop), along, up), [&] {
                  return Solids{{EccentricCone{wide.radius(), narrow.radius(), length, {-drop, 0.0}}}};
              });
}

void PipeFitter::tee(uint32_t size, const Vec3& from, const Vec3& along, const Vec3& branch) {
    const PipeSize& pipe = pipeSizes()[size];
    constexpr uint32_t kBranch = 0;
    const double length = pipe.teeLength(), own = pipeSizes()[kBranch].radius(), height = pipe.radius() + 0.06;
    m_kit.add({"tee", size}, pipe.segments(), frame(from, along, branch), [&] {
        return Solids{{Cylinder{pipe.radius(), length}, at(0, 0, 0.5 * length)},
                      {Cylinder{own, height}, alongX(0.5 * height, 0, 0.5 * length)}};
    });
    const Vec3 end = from + along * (0.5 * length) + branch * height;
    this->pipe(kBranch, end, branch, 0.2);
    m_kit.add({"cap", kBranch}, 8, frame(end + branch * 0.2, branch), [&] { return Solids{{SphericalDish{own, 0.5 * own}}}; });
}

void PipeFitter::shoe(uint32_t size, const Vec3& middle, const Vec3& along) {
    m_kit.add({"support", size}, 8, frame(middle, {0.0, 0.0, 1.0}, along), [&] { return shoeSolids(pipeSizes()[size]); });
}

}  // namespace cullscope::plant
