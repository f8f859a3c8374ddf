#pragma once

#include "core/spatial/inner_kernel.h"

namespace cullscope::spherical {

/// What an object's inner kernel hides from one eye (methods.md, `spherical-lossless`). Seen from outside, every sight line stays
/// in one half-plane of the axis from the centre to the eye, the angle α at the centre grows along it, and its slope
/// s = r·sin α / (d − r·cos α), d from the eye to the centre, is the same all along. A point is hidden where the kernel reaches
/// to a larger slope at some smaller α in its half-plane. Holds whatever the surface is, as long as all of it lies behind the
/// near plane and the kernel's own surface is drawn.
class KernelHorizon {
public:
    /// What is known of a sphere's points.
    enum class Reach {
        Hidden,  ///< all are hidden
        Open,    ///< some may be, some may not
        Visible  ///< the kernel hides none
    };

    /// `eye` from the kernel's centre, outside the bounding sphere of `radius`; `snap`: by how much a picture moves a point, in
    /// mesh units a unit of distance from the eye.
    KernelHorizon(const InnerKernel& kernel, const Vec3& eye, double radius, double snap);

    /// False: the eye is so far away that the picture's grid is as coarse as the kernel, and nothing is hidden.
    [[nodiscard]] bool usable() const { return m_bands > 0; }
    /// Of a sphere, from the centre. Never says Hidden of one with a point that the picture may show.
    [[nodiscard]] Reach reach(const Vec3& middle, double radius) const;

    [[nodiscard]] const Vec3& axis() const { return m_axis; }  ///< unit: from the centre to the eye
    [[nodiscard]] uint32_t sectors() const { return m_sectors; }
    /// The kernel's outline as the eye sees it: the point of the largest slope in the middle of each sector, from the centre.
    [[nodiscard]] std::vector<Vec3> outline(const InnerKernel& kernel) const;

private:
    struct Band {
        double cosine = 1.0, sine = 0.0;     ///< of α
        double lowest = 0.0, highest = 0.0;  ///< slopes over its sectors
    };

    [[nodiscard]] Vec3 direction(const Band& band, uint32_t sector) const;
    [[nodiscard]] double radiusAt(const InnerKernel& kernel, const Band& band, uint32_t sector) const;
    [[nodiscard]] double slope(double radius, const Band& band) const {
        return radius * band.sine / (m_distance - radius * band.cosine);
    }
    void fill(const InnerKernel& kernel);
    /// The band with the largest α up to that of a cosine; −1: none.
    [[nodiscard]] int bandUpTo(double cosine) const;

    Vec3 m_axis{0.0, 0.0, 1.0}, m_side{1.0, 0.0, 0.0}, m_over{0.0, 1.0, 0.0};
    double m_distance = 0.0;  ///< from the centre to the eye
    double m_snap = 0.0;
    double m_shrink = 0.0;  ///< of the kernel, for the picture's grid
    uint32_t m_sectors = 0;
    size_t m_bands = 0;
    std::vector<Vec2> m_sectorArms;  ///< (cos, sin) of the sectors' middles
    std::vector<Band> m_band;
    std::vector<double> m_slopes;  ///< by band, then sector: the largest up to that band
};

}  // namespace cullscope::spherical
