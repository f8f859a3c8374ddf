#include "core/mesh/obj_lines.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"

namespace cullscope {
namespace {

constexpr size_t kMostDigitsOfAnIndex = 9;
constexpr size_t kMostDigitsOfAnExponent = 3;

/// Keywords of the format that do not describe the surface (vt and vp, materials, smoothing, points, lines, free-form surfaces…).
constexpr std::array<std::string_view, 48> kPassedOver{
    "vt",       "vp",   "usemtl", "mtllib", "s",          "l",         "p",     "deg",    "bmat", "step", "cstype", "curv",
    "curv2",    "surf", "parm",   "trim",   "hole",       "scrv",      "sp",    "end",    "con",  "mg",   "bevel",  "c_interp",
    "d_interp", "lod",  "usemap", "maplib", "shadow_obj", "trace_obj", "ctech", "stech",  "call", "csh",  "vw",     "t",
    "fo",       "bzp",  "bsp",    "cdc",    "cdp",        "res",       "rat",   "newmtl", "Kd",   "Ka",   "Ks",     "illum"};

bool isDigit(char character) { return character >= '0' && character <= '9'; }

bool spellsNotANumber(std::string_view word) {
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
    return startsWithIgnoringCase(word, "nan") || startsWithIgnoringCase(word, "inf") || startsWithIgnoringCase(word, "1.#");
}

enum class Number { No, Finite, NotFinite };

size_t skipDigits(std::string_view word, size_t& at) {
    const size_t begin = at;
    while (at < word.size() && isDigit(word[at])) ++at;
    return at - begin;
}

/// Whether tinyobjloader parses the whole word as a number.
Number judged(std::string_view word) {
    size_t at = !word.empty() && (word[0] == '-' || word[0] == '+') ? 1 : 0;
    size_t digits = skipDigits(word, at);
    if (at < word.size() && word[at] == '.') digits += skipDigits(word, ++at);
    if (digits == 0) return spellsNotANumber(word) ? Number::NotFinite : Number::No;
    if (at == word.size()) return Number::Finite;
    if (word[at] != 'e' && word[at] != 'E') return spellsNotANumber(word) ? Number::NotFinite : Number::No;
    ++at;
    if (at < word.size() && (word[at] == '-' || word[at] == '+')) ++at;
    const size_t exponentDigits = skipDigits(word, at);
    if (exponentDigits == 0 || at < word.size()) return Number::No;
    return exponentDigits <= kMostDigitsOfAnExponent ? Number::Finite : Number::NotFinite;
}

}  // namespace

ObjLines::int_type ObjLines::underflow() {
    do {
        if (!readLogicalLine()) return traits_type::eof();
    } while (!admitted());
    m_line += '\n';
    setg(m_line.data(), m_line.data(), m_line.data() + m_line.size());
    return traits_type::to_int_type(m_line.front());
}

/// Reads a line together with those that a backslash at its end continues, without leading blanks.
bool ObjLines::readLogicalLine() {
    std::string_view line;
    if (!m_source.line(line)) return false;
    m_firstLine = m_source.lineNumber();
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(" \t")));
    m_line.assign(line);
    while (!m_line.empty() && m_line.back() == '\\' && m_line.front() != '#' && m_source.line(line)) {
        m_line.back() = ' ';
        m_line += line;
        if (m_line.size() > ByteSource::kLongestLine)
            throwInput(CULLSCOPE_TR("%1, line %2 goes on for more than %3 MB. Check that the file is a mesh in a text format."),
                       {m_source.name(), std::to_string(m_firstLine), std::to_string(ByteSource::kLongestLine >> 20)});
    }
    return true;
}

bool ObjLines::admitted() {
    m_notFinite = false;
    std::string_view rest = m_line;
    const std::string_view keyword = takeWord(rest);
    if (keyword.empty() || keyword.front() == '#') return false;
    // tinyobjloader requires a blank after the keyword.
    const bool blankFollows = keyword.size() < m_line.size() && (m_line[keyword.size()] == ' ' || m_line[keyword.size()] == '\t');
    if (keyword == "v" || keyword == "vn") {
        checkNumbers(rest);
        return blankFollows;
    }
    if (keyword == "f") return checkFace(rest) && blankFollows;
    if (keyword == "o" || keyword == "g") {
        if (!blankFollows) m_line += ' ';
        return true;
    }
    if (std::ranges::find(kPassedOver, keyword) == kPassedOver.end() && m_unknownLines++ == 0) m_firstUnknownLine = m_firstLine;
    return false;
}

void ObjLines::checkNumbers(std::string_view rest) {
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
        const std::string_view word = takeWord(rest);
        if (word.empty())
            throwInput(
                CULLSCOPE_TR(
                    "%1, line %2: a vertex or normal has only %3 of 3 coordinates. Correct the line or export the file again."),
                {m_source.name(), std::to_string(m_firstLine), std::to_string(coordinate)});
        const Number number = judged(word);
        if (number == Number::No)
            throwInput(CULLSCOPE_TR("%1, line %2: \"%3\" is not a number. Correct the line or export the file again."),
                       {m_source.name(), std::to_string(m_firstLine), shownWord(word)});
        if (number == Number::NotFinite) m_notFinite = true;
    }
}

bool ObjLines::checkFace(std::string_view rest) {
    bool absurd = false;
    bool empty = true;
    for (std::string_view word = takeWord(rest); !word.empty() && word.front() != '#'; word = takeWord(rest)) {
        empty = false;
        size_t at = 0;
        for (int part = 0; part < 3; ++part) {
            if (at < word.size() && (word[at] == '-' || word[at] == '+')) ++at;
            const size_t digits = skipDigits(word, at);
            absurd = absurd || digits > kMostDigitsOfAnIndex;
            if (part == 0 && digits == 0) break;
            if (at < word.size() && word[at] == '/' && part < 2)
                ++at;
            else
                break;
        }
        if (at != word.size() || !(isDigit(word[0]) || (word.size() > 1 && isDigit(word[1]))))
            throwInput(CULLSCOPE_TR("%1, line %2: \"%3\" is not a corner of a face. Correct the line or export the file again."),
                       {m_source.name(), std::to_string(m_firstLine), shownWord(word)});
    }
    // tinyobjloader would read a comment after the corners as corners.
    const size_t comment = m_line.find('#');
    if (comment != std::string::npos) m_line.resize(comment);
    if (absurd) ++m_facesWithAbsurdIndex;
    if (empty) ++m_facesWithoutCorners;
    return !absurd && !empty;
}

}  // namespace cullscope
