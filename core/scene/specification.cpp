#include "core/scene/specification.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/error.h"

namespace cullscope {
namespace {

std::string shortest(double value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

/// The number of leading characters that can belong to a parameter's name.
size_t wordLength(std::string_view text) {
    const auto end = std::find_if(text.begin(), text.end(),
                                  [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_'; });
    return static_cast<size_t>(end - text.begin());
}

/// A file's name may contain an equals sign; only a plain word before it is a parameter's name.
Specification::Piece pieceOf(std::string_view text) {
    const size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0 || wordLength(text) != equals) return {"", std::string(text)};
    return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

std::vector<Specification::Piece> piecesOf(std::string_view text) {
    std::vector<Specification::Piece> pieces;
    size_t start = 0;
    for (size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
        const size_t end = comma + 1 + wordLength(text.substr(comma + 1));
        if (end == comma + 1 || end >= text.size() || text[end] != '=') continue;
        pieces.push_back(pieceOf(text.substr(start, comma - start)));
        start = comma + 1;
    }
    if (start < text.size()) pieces.push_back(pieceOf(text.substr(start)));
    return pieces;
}

std::string joined(const Specification::Piece& piece) { return piece.key.empty() ? piece.value : piece.key + "=" + piece.value; }

/// The generators nested in a value, from the outermost inwards, each with the keys that it has been given.
class Nesting {
public:
    Nesting(const std::vector<GeneratorInfo>& known, const std::string& value) : m_known(known) { enter(value); }

    /// Whether one of the generators takes the piece, the innermost first. Generators nested deeper than that one are then
    /// complete.
    bool takes(const Specification::Piece& piece) {
        for (size_t level = m_levels.size(); level-- > 0;) {
            if (!m_levels[level].lacks(piece.key)) continue;
            m_levels.resize(level + 1);
            m_levels[level].got.insert(piece.key);
            if (piece.key == "mesh") enter(piece.value);
            return true;
        }
        return false;
    }

private:
    struct Level {
        const GeneratorInfo* info;
        std::set<std::string> got;

        [[nodiscard]] bool lacks(const std::string& key) const {
            const auto declares = [&](const GeneratorParameter& parameter) { return parameter.key == key; };
            return !got.contains(key) && std::any_of(info->parameters.begin(), info->parameters.end(), declares);
        }
    };

    void enter(std::string_view value) {
        for (size_t colon = value.find(':'); colon != std::string_view::npos; colon = value.find(':')) {
            const auto info = std::find_if(m_known.begin(), m_known.end(),
                                           [&](const GeneratorInfo& each) { return each.id == value.substr(0, colon); });
            if (info == m_known.end()) return;
            // Each level is cut once more when its own scene is opened, so that the time grows with the square of the depth.
            if (m_levels.size() + 1 >= kMostNestedGenerators)
                throwUsage(CULLSCOPE_TR("More than %1 generators stand one inside another. Write the inner scene to a mesh file "
                                        "with cullbench export, and name that file."),
                           {std::to_string(kMostNestedGenerators)});
            m_levels.push_back({&*info, {}});
            value.remove_prefix(colon + 1);
            const Specification::Piece piece = pieceOf(value);
            if (!piece.key.empty()) m_levels.back().got.insert(piece.key);
            if (!Specification{info->id, {}}.namesMesh(piece)) return;
            value.remove_prefix(piece.key.empty() ? 0 : piece.key.size() + 1);
        }
    }

    const std::vector<GeneratorInfo>& m_known;
    std::vector<Level> m_levels;
};

}  // namespace

bool Specification::namesMesh(const Piece& piece) const {
    return piece.key == "mesh" || (generator == "mesh" && piece.key.empty());
}

std::string Specification::text() const {
    std::string text = generator;
    for (const Piece& piece : pieces) text += (&piece == &pieces.front() ? ":" : ",") + joined(piece);
    return text;
}

Specification cutSpecification(std::string_view text, const std::vector<GeneratorInfo>& known) {
    const size_t colon = text.find(':');
    Specification specification{std::string(text.substr(0, colon)), {}};
    if (colon == std::string_view::npos) return specification;
    std::optional<Nesting> nesting;
    for (Specification::Piece& piece : piecesOf(text.substr(colon + 1))) {
        if (nesting && nesting->takes(piece)) {
            specification.pieces.back().value += "," + joined(piece);
            continue;
        }
        nesting.reset();
        if (specification.namesMesh(piece)) nesting.emplace(known, piece.value);
        specification.pieces.push_back(std::move(piece));
    }
    return specification;
}

GeneratorArguments::GeneratorArguments(const Specification& specification) : m_generator(specification.generator) {
    for (const auto& [key, value] : specification.pieces) {
        if (key.empty())
            m_unnamed = value;
        else if (value.empty())
            throwUsage(CULLSCOPE_TR("%1: %2 has no value."), {m_generator, key + "="});
        else if (!m_values.emplace(key, value).second)
            throwUsage(CULLSCOPE_TR("%1: %2 is given twice."), {m_generator, key});
    }
}

std::string GeneratorArguments::text(const std::string& key, const std::string& fallback) {
    const auto found = m_values.find(key);
    if (found == m_values.end()) return fallback;
    std::string value = found->second;
    m_values.erase(found);
    return value;
}

double GeneratorArguments::number(const std::string& key, double fallback, double least, double most) {
    const std::string value = text(key, "");
    if (value.empty()) return fallback;
    double parsed = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parsed);
    if (error != std::errc() || end != value.data() + value.size() || !(parsed >= least && parsed <= most))
        throwUsage(CULLSCOPE_TR("%1: %2=%3 is not a number between %4 and %5."),
                   {m_generator, key, value, shortest(least), shortest(most)});
    return parsed;
}

double GeneratorArguments::wholeNumber(const std::string& key, double fallback, double least, double most) {
    const double value = number(key, fallback, least, most);
    if (value != std::floor(value))
        throwUsage(CULLSCOPE_TR("%1: %2 is a whole number, not %3."), {m_generator, key, shortest(value)});
    return value;
}

size_t GeneratorArguments::count(const std::string& key, double fallback, double most) {
    return static_cast<size_t>(wholeNumber(key, fallback, 1, most));
}

void GeneratorArguments::finish(const GeneratorInfo& info) const {
    if (!m_values.empty()) {
        std::string known;
        for (const GeneratorParameter& parameter : info.parameters) known += (known.empty() ? "" : ", ") + parameter.key;
        throwUsage(CULLSCOPE_TR("%1 has no parameter \"%2\". It has: %3."),
                   {m_generator, m_values.begin()->first, known.empty() ? "-" : known});
    }
    const bool takesFile = info.id == "mesh";
    if (!takesFile && !m_unnamed.empty())
        throwUsage(CULLSCOPE_TR("%1: \"%2\" is not of the form key=value."), {m_generator, m_unnamed});
}

}  // namespace cullscope
