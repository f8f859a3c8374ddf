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

/// `GENERATOR:key=value,…` cut at its commas. A comma cuts only before `name=`, so that a file's name may hold commas. Where a
/// mesh is itself a generator with parameters (`split:mesh=field:mesh=a.obj,n=3,by=components`), what follows belongs to the
/// innermost one that knows the key and has not got it yet.
struct Specification {
    struct Piece {
        std::string key;  ///< empty: a first piece without a name, as in `mesh:FILE`
        std::string value;
    };
    std::string generator;
    std::vector<Piece> pieces;

    /// Whether a piece's value is a mesh: a file or another specification.
    [[nodiscard]] bool namesMesh(const Piece& piece) const;
    /// Put together again.
    [[nodiscard]] std::string text() const;
};
/// `known`: the generators that there are. Text without a colon has no pieces.
[[nodiscard]] Specification cutSpecification(std::string_view text, const std::vector<GeneratorInfo>& known);

/// A generator's parameters, taken one by one with their defaults.
/// What is wrong with one throws Error(Usage) that names the generator and the key.
class GeneratorArguments {
public:
    explicit GeneratorArguments(const Specification& specification);

    [[nodiscard]] const std::string& unnamed() const { return m_unnamed; }
    [[nodiscard]] bool has(const std::string& key) const { return m_values.contains(key); }
    [[nodiscard]] std::string text(const std::string& key, const std::string& fallback);
    [[nodiscard]] double number(const std::string& key, double fallback, double least, double most);
    [[nodiscard]] double wholeNumber(const std::string& key, double fallback, double least, double most);
    /// From 1 to `most`.
    [[nodiscard]] size_t count(const std::string& key, double fallback, double most);
    /// Refuses what nobody asked for: call after everything known was taken.
    void finish(const GeneratorInfo& info) const;

private:
    std::string m_generator;
    std::string m_unnamed;
    std::map<std::string, std::string> m_values;
};

}  // namespace cullscope
