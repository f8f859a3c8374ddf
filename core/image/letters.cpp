#include "core/image/letters.h"

#include <ft2build.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/terminal_text.h"

#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace cullscope {
namespace {

// Files of fonts by their names, best first: one of Latin and Greek letters, then one of Korean and Chinese ones.
constexpr std::array kPlainFonts{"DejaVuSans.ttf", "NotoSans-Regular.ttf", "LiberationSans-Regular.ttf", "FreeSans.ttf"};
constexpr std::array kSquareFonts{"NotoSansCJK-Regular.ttc", "NotoSansCJKkr-Regular.otf", "NanumGothic.ttf", "wqy-zenhei.ttc"};
constexpr std::array kFontFolders{"/usr/share/fonts", "/usr/local/share/fonts"};

/// The languages whose forms of the same characters differ. A collection of fonts has a face of each.
enum class Writing : uint8_t { Chinese, Japanese, Korean };
constexpr std::array kFamilyEnds{" SC", " JP", " KR"};  ///< of a face's family, by Writing

constexpr double kFixed = 64.0;          ///< FreeType counts 64ths of a pixel
constexpr double kBoldShare = 1 / 18.0;  ///< of the size: by how much bold strokes are wider

std::map<std::string, std::filesystem::path> installedFonts() {
    std::map<std::string, std::filesystem::path> found;
    for (const char* folder : kFontFolders) {
        std::error_code absent;
        for (auto each = std::filesystem::recursive_directory_iterator(folder, absent);
             !absent && each != std::filesystem::recursive_directory_iterator(); each.increment(absent))
            found.emplace(each->path().filename().string(), each->path());
    }
    return found;
}

/// The characters of a text in UTF-8 without control characters.
std::u32string charactersOf(const std::string& text) {
    std::u32string characters;
    for (const char byte : terminalLine(text)) {
        const auto value = uint8_t(byte);
        if ((value & 0xC0) == 0x80 && !characters.empty())
            characters.back() = (characters.back() << 6) | (value & 0x3F);
        else
            characters.push_back(value < 0x80 ? value : value < 0xE0 ? value & 0x1F : value < 0xF0 ? value & 0x0F : value & 0x07);
    }
    return characters;
}

/// Kana are Japanese alone, syllables of Hangul Korean; characters without either are taken as mainland China's.
Writing writingOf(const std::u32string& characters) {
    const auto within = [](char32_t character, char32_t from, char32_t to) { return character >= from && character <= to; };
    for (const char32_t each : characters) {
        if (within(each, 0xAC00, 0xD7A3) || within(each, 0x1100, 0x11FF) || within(each, 0x3130, 0x318F)) return Writing::Korean;
        if (within(each, 0x3041, 0x30FF)) return Writing::Japanese;
    }
    return Writing::Chinese;
}

/// The index of the face of a file for a kind of writing; 0 where the file has none of its own for it.
FT_Long faceFor(FT_Library library, const std::filesystem::path& file, Writing writing) {
    const std::string_view end = kFamilyEnds[size_t(writing)];
    FT_Long count = 1;
    for (FT_Long i = 0; i < count; ++i) {
        FT_Face face = nullptr;
        if (FT_New_Face(library, file.c_str(), i, &face) != 0) break;
        count = face->num_faces;
        const bool found = face->family_name != nullptr && std::string_view(face->family_name).ends_with(end);
        FT_Done_Face(face);
        if (found) return i;
    }
    return 0;
}

}  // namespace

struct Letters::Fonts {
    Fonts() = default;
    ~Fonts() {
        for (FT_Face face : faces) FT_Done_Face(face);
        if (library != nullptr) FT_Done_FreeType(library);
    }
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

    FT_Face open(const std::filesystem::path& file, FT_Long index) {
        FT_Face face = nullptr;
        if (FT_New_Face(library, file.c_str(), index, &face) != 0) return nullptr;
        faces.push_back(face);
        FT_Set_Char_Size(face, 0, FT_F26Dot6(std::lround(pixels * kFixed)), 72, 72);
        return face;
    }

    void openAll() {
        const std::map<std::string, std::filesystem::path> installed = installedFonts();
        for (const char* name : kPlainFonts)
            if (const auto file = installed.find(name); file != installed.end())
                if ((plain = open(file->second, 0)) != nullptr) break;
        for (const char* name : kSquareFonts) {
            const auto file = installed.find(name);
            if (file == installed.end()) continue;
            for (const Writing writing : {Writing::Chinese, Writing::Japanese, Writing::Korean})
                square[size_t(writing)] = open(file->second, faceFor(library, file->second, writing));
            if (square[0] != nullptr) break;
        }
    }

    /// The first font that has a character, as a kind of writing has it; the first font of all where none has it.
    [[nodiscard]] FT_Face faceOf(char32_t character, Writing writing) const {
        for (FT_Face face : {plain, square[size_t(writing)]})
            if (face != nullptr && FT_Get_Char_Index(face, character) != 0) return face;
        return faces.front();
    }

    /// Calls `use(glyph, advance in pixels)` of each character.
    template <typename Use>
    void forEach(const std::string& words, bool bold, const Use& use) const {
        const std::u32string characters = charactersOf(words);
        const Writing writing = writingOf(characters);
        for (const char32_t character : characters) {
            FT_Face face = faceOf(character, writing);
            if (FT_Load_Char(face, character, FT_LOAD_NO_HINTING) != 0) continue;
            double advance = double(face->glyph->advance.x) / kFixed;
            if (bold && face->glyph->format == FT_GLYPH_FORMAT_OUTLINE) {
                FT_Outline_Embolden(&face->glyph->outline, FT_Pos(pixels * kBoldShare * kFixed));
                advance += pixels * kBoldShare;
            }
            use(face->glyph, advance);
        }
    }

    double pixels = 0.0;
    FT_Library library = nullptr;
    std::vector<FT_Face> faces;       ///< all that are open
    FT_Face plain = nullptr;          ///< of Latin and Greek letters; null: not installed
    std::array<FT_Face, 3> square{};  ///< of the others, by Writing; null: not installed
};

Letters::Letters(double pixels) : m_fonts(std::make_unique<Fonts>()) {
    m_fonts->pixels = pixels;
    if (FT_Init_FreeType(&m_fonts->library) == 0) m_fonts->openAll();
    if (m_fonts->faces.empty())
        throwUsage(
            CULLSCOPE_TR("There is no font for the picture's letters: install the package fonts-noto-cjk or "
                         "fonts-dejavu-core, or write an .svg file, whose letters its viewer draws."));
}

Letters::~Letters() = default;
Letters::Letters(Letters&&) noexcept = default;

// Fixed shares of the size, so that a page has the same layout whichever of the fonts is installed.
double Letters::ascent() const { return 0.95 * m_fonts->pixels; }
double Letters::height() const { return 1.3 * m_fonts->pixels; }

double Letters::width(const std::string& words, bool bold) const {
    double width = 0.0;
    m_fonts->forEach(words, bold, [&](FT_GlyphSlot, double advance) { width += advance; });
    return width;
}

void Letters::draw(Canvas& canvas, const Vec2& place, const std::string& words, const Vec3f& colour, bool bold) const {
    double x = place.x;
    m_fonts->forEach(words, bold, [&](FT_GlyphSlot glyph, double advance) {
        // Outlines are moved by the part of a pixel, so that letters keep their distances.
        const double whole = std::floor(x);
        if (glyph->format == FT_GLYPH_FORMAT_OUTLINE) FT_Outline_Translate(&glyph->outline, FT_Pos((x - whole) * kFixed), 0);
        x += advance;
        if (FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL) != 0) return;
        const FT_Bitmap& bitmap = glyph->bitmap;
        if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return;
        const int left = int(whole) + glyph->bitmap_left, top = int(std::lround(place.y)) - glyph->bitmap_top;
        for (unsigned row = 0; row < bitmap.rows; ++row)
            for (unsigned column = 0; column < bitmap.width; ++column) {
                const uint8_t coverage = bitmap.buffer[ptrdiff_t(row) * bitmap.pitch + ptrdiff_t(column)];
                const double pixelX = left + int(column), pixelY = top + int(row);
                if (coverage > 0) canvas.fill({pixelX, pixelY, pixelX + 1.0, pixelY + 1.0}, colour, coverage / 255.0);
            }
    });
}

}  // namespace cullscope
