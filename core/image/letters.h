#pragma once

#include <memory>
#include <string>

#include "core/raster/canvas.h"

namespace cullscope {

/// Letters of the installed fonts at one size, drawn without a window by FreeType: Latin and Greek ones, Korean syllables and
/// Chinese characters, each as it stands in the text: in words with Hangul or kana as Korea or Japan write them, else as mainland
/// China does. A letter that no font has is an empty box.
class Letters {
public:
    /// `pixels`: the size of the letters (em). Throws Error(Usage) where none of the fonts that the program knows is installed.
    explicit Letters(double pixels);
    ~Letters();
    Letters(Letters&&) noexcept;
    Letters(const Letters&) = delete;
    Letters& operator=(const Letters&) = delete;

    /// Of a line of text, pixels.
    [[nodiscard]] double ascent() const;
    [[nodiscard]] double height() const;
    /// Of words in UTF-8, pixels.
    [[nodiscard]] double width(const std::string& words, bool bold = false) const;
    /// Draws words from a place on their base line to the right.
    void draw(Canvas& canvas, const Vec2& place, const std::string& words, const Vec3f& colour, bool bold = false) const;

private:
    struct Fonts;
    std::unique_ptr<Fonts> m_fonts;
};

}  // namespace cullscope
