#pragma once

#include "core/spatial/inner_kernel.h"
#include "core/visibility/part_walk.h"

namespace cullscope::spherical {

/// The region that an object's inner kernel hides from one eye (docs/methods/spherical.md). Seen from outside, every sight
/// line stays in one half-plane of the axis from the centre to the eye; the angle α at the centre grows along it; and its slope s
/// = r·sin α / (d − r·cos α), with d the distance from the eye to the centre, is constant. A point is hidden where the kernel
/// extends to a larger slope at a smaller α in the same half-plane. This holds for every surface that lies completely beyond the
/// near plane, if the surface around the kernel is drawn.
class KernelHorizon {
public:
    /// What is known of the points of a sphere.
    using Reach = HidingTest::Reach;

    /// `eye` is relative to the kernel's centre, outside the bounding sphere of `radius`. `snap`: displacement of a point by the
    /// picture's snapping, in mesh units for each unit of distance from the eye (see snapping()).
    KernelHorizon(const InnerKernel& kernel, const Vec3& eye, double radius, double snap);

    /// False where the eye is so far away that snapping displaces points by about the kernel's size; then nothing is hidden.
    [[nodiscard]] bool usable() const { return m_bands > 0; }
    /// The result, and the slopes that decided it.
    struct Comparison {
        Reach reach = Reach::Open;
        double slope = 0.0;    ///< Visible: the sphere's smallest, else its largest; infinite for a sphere around the eye
        double horizon = 0.0;  ///< Visible: the horizon's largest, Hidden: its smallest over the sphere, Open: one that does not
                               ///< exceed `slope`
    };
    /// The test of a sphere, given relative to the centre. Never Hidden for a sphere with a point that may be visible in the
    /// picture.
    [[nodiscard]] Comparison compare(const Vec3& middle, double radius) const;

    [[nodiscard]] const Vec3& axis() const { return m_axis; }  ///< unit vector from the centre to the eye
    [[nodiscard]] uint32_t sectors() const { return m_sectors; }
    /// The kernel's outline as seen from the eye: in the middle of each sector the point with the largest slope, relative to the
    /// centre.
    [[nodiscard]] std::vector<Vec3> outline(const InnerKernel& kernel) const;

private:
    struct Band {
        double cosine = 1.0, sine = 0.0;     ///< of α
        double lowest = 0.0, highest = 0.0;  ///< smallest and largest slope over its sectors
    };

    [[nodiscard]] Vec3 direction(const Band& band, uint32_t sector) const;
    [[nodiscard]] double radiusAt(const InnerKernel& kernel, const Band& band, uint32_t sector) const;
    [[nodiscard]] double slope(double radius, const Band& band) const {
        return radius * band.sine / (m_distance - radius * band.cosine);
    }
    void fill(const InnerKernel& kernel);
    /// The band with the largest α that is at most the α of a cosine; −1: none.
    [[nodiscard]] int bandUpTo(double cosine) const;

    Vec3 m_axis{0.0, 0.0, 1.0}, m_side{1.0, 0.0, 0.0}, m_over{0.0, 1.0, 0.0};
    double m_distance = 0.0;  ///< from the centre to the eye
    double m_snap = 0.0;
    double m_shrink = 0.0;  ///< reduction of the kernel's radius that covers the snapping
    uint32_t m_sectors = 0;
    size_t m_bands = 0;
    std::vector<Vec2> m_sectorArms;  ///< (cos, sin) of the azimuth of the sectors' middles
    std::vector<Band> m_band;
    std::vector<double> m_slopes;  ///< by band, then sector: the largest slope up to that band
};

}  // namespace cullscope::spherical
