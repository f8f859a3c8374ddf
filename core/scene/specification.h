#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cullscope {

struct GeneratorParameter {
    std::string key;
    std::string defaultValue;
    std::string description;  ///< English, marked for translation
};
struct GeneratorInfo {
    std::string id;
    std::string description;  ///< English, marked for translation
    std::vector<GeneratorParameter> parameters;
};

/// `GENERATOR:key=value,…` split at its commas. A comma splits only before `name=`, so that a file's name may contain commas.
/// Where a mesh is itself a generator with parameters (`split:mesh=field:mesh=a.obj,n=3,by=components`), a following piece
/// belongs to the innermost generator that has this key and no value for it yet.
struct Specification {
    struct Piece {
        std::string key;  ///< empty: a first piece without a name, as in `mesh:FILE`
        std::string value;
    };
    std::string generator;
    std::vector<Piece> pieces;

    /// Whether a piece's value is a mesh: a file or another specification.
    [[nodiscard]] bool namesMesh(const Piece& piece) const;
    /// The specification as text again.
    [[nodiscard]] std::string text() const;
};
/// The most generators of which one is another's mesh, the outermost and the innermost counted.
inline constexpr size_t kMostNestedGenerators = 64;

/// `known`: all generators. Text without a colon has no pieces. Throws Error(Usage) where more generators are nested than
/// kMostNestedGenerators.
[[nodiscard]] Specification cutSpecification(std::string_view text, const std::vector<GeneratorInfo>& known);

/// A generator's parameters, read one by one with their defaults. An invalid value throws Error(Usage) that names the generator
/// and the key.
class GeneratorArguments {
public:
    explicit GeneratorArguments(const Specification& specification);

    [[nodiscard]] const std::string& unnamed() const { return m_unnamed; }
    [[nodiscard]] bool has(const std::string& key) const { return m_values.contains(key); }
    [[nodiscard]] std::string text(const std::string& key, const std::string& fallback);
    [[nodiscard]] double number(const std::string& key, double fallback, double least, double most);
    [[nodiscard]] double wholeNumber(const std::string& key, double fallback, double least, double most);
    /// A whole number from 1 to `most`.
    [[nodiscard]] size_t count(const std::string& key, double fallback, double most);
    /// Throws Error(Usage) for a parameter that was not read: call it after all known parameters have been read.
    void finish(const GeneratorInfo& info) const;

private:
    std::string m_generator;
    std::string m_unnamed;
    std::map<std::string, std::string> m_values;
};

}  // namespace cullscope
