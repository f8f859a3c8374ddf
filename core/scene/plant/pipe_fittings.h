#pragma once

#include "core/scene/plant/kit.h"

namespace cullscope::plant {

/// A nominal size of pipes with its flanges (after ASME B36.10 and B16.5, class 150), in millimetres.
struct PipeSize {
    int nominal, outside;
    int flange, thickness;    ///< outer diameter and thickness of a flange
    int bolts, circle, bolt;  ///< how many, the diameter of their circle, their own diameter

    [[nodiscard]] double radius() const { return 0.0005 * outside; }
    /// Of an elbow's middle line.
    [[nodiscard]] double bend() const { return 0.0015 * nominal; }
    /// From a flange's face to the pipe's end at its neck.
    [[nodiscard]] double flangeLength() const { return 0.001 * (thickness + neck()); }
    [[nodiscard]] int neck() const { return 20 + nominal / 4; }
    /// Between a valve's faces.
    [[nodiscard]] double valveLength() const { return 0.15 + 0.002 * nominal; }
    /// A valve with the two flanges before and behind it.
    [[nodiscard]] double valveStation() const { return valveLength() + 2.0 * flangeLength(); }
    [[nodiscard]] double reducerLength() const { return 0.1 + 0.001 * nominal; }
    [[nodiscard]] double teeLength() const { return 0.002 * outside + 0.1; }
    /// Chords of a circle.
    [[nodiscard]] uint32_t segments() const { return nominal <= 50 ? 8 : nominal <= 150 ? 12 : 16; }
};

/// From the smallest to the largest.
[[nodiscard]] const std::vector<PipeSize>& pipeSizes();

/// Adds the parts of pipelines, each where the pipe arrives: `from` on its middle line, `along` a unit vector of an axis. A size
/// is a place in pipeSizes.
class PipeFitter {
public:
    explicit PipeFitter(Kit& kit) : m_kit(kit) {}

    /// In pieces of at most 12 m.
    void pipe(uint32_t size, const Vec3& from, const Vec3& along, double length);
    /// Round a corner of the middle line: bent, or of three mitred pieces for large sizes.
    void elbow(uint32_t size, const Vec3& corner, const Vec3& in, const Vec3& out);
    /// A flange whose face lies at `face`, its pipe in the direction `pipe`.
    void flange(uint32_t size, const Vec3& face, const Vec3& pipe);
    /// Bolts with their nuts, and a gasket for larger sizes, at two flanges' faces.
    void joint(uint32_t size, const Vec3& face, const Vec3& along);
    /// A nozzle of a vessel, whose wall lies behind its face.
    void nozzle(uint32_t size, const Vec3& face, const Vec3& out);
    /// One of the kinds 0 to 2: gate, ball, control; with its flanges and bolts. `stem` is perpendicular.
    void valve(uint32_t size, uint32_t kind, const Vec3& from, const Vec3& along, const Vec3& stem);
    /// To a smaller size; the bottom of a level pipe stays level.
    void reducer(uint32_t size, uint32_t smaller, const Vec3& from, const Vec3& along);
    /// With a short branch that is closed by a cap.
    void tee(uint32_t size, const Vec3& from, const Vec3& along, const Vec3& branch);
    /// Between a level pipe and the beam 0.1 m below it.
    void shoe(uint32_t size, const Vec3& middle, const Vec3& along);

private:
    Kit& m_kit;
};

}  // namespace cullscope::plant
