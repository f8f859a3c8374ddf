#pragma once

#include <span>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope {

/// A picture drawn without OpenGL: antialiased lines and dots. Pixels count from the upper left corner; their centres lie at
/// +0.5.
class Canvas {
public:
    /// A canvas filled with a background; `alpha` is its opacity, from 0 to 1.
    Canvas(const Viewport& size, const Vec3f& background, float alpha);

    struct Rectangle {
        double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    };
    /// Restricts all further drawing to this rectangle.
    void clipTo(const Rectangle& rectangle) { m_clip = rectangle; }

    void setPixel(int x, int y, const Vec3f& colour) { blend(x, y, colour, 1.0); }
    /// Fills the pixels whose centres lie inside.
    void fill(const Rectangle& rectangle, const Vec3f& colour, double opacity);

    /// Fills the pixels whose centres lie inside a polygon, by the even-odd rule.
    void fill(std::span<const Vec2> polygon, const Vec3f& colour, double opacity);

    struct Pen {
        Vec3f colour{0.0f};
        double width = 1.0;  ///< pixels
        double dash = 0.0;   ///< length of the dashes and of the gaps between them, in pixels; 0: a solid line
    };
    void line(std::span<const Vec2> points, const Pen& pen);
    void dot(const Vec2& centre, double radius, const Vec3f& colour);
    void ring(const Vec2& centre, double radius, const Pen& pen);

    /// RGBA, rows from the bottom, as in all pictures.
    [[nodiscard]] std::vector<uint8_t> rgba() const;

private:
    void blend(int x, int y, const Vec3f& colour, double coverage);
    void stroke(const Vec2& from, const Vec2& to, const Pen& pen);
    /// Draws the pixels around a box with a coverage computed from a signed distance (pixels, negative inside).
    template <typename Distance>
    void cover(const Vec2& low, const Vec2& high, const Vec3f& colour, const Distance& distance);

    Viewport m_size;
    std::vector<uint8_t> m_rgba;
    Rectangle m_clip;
};

}  // namespace cullscope
