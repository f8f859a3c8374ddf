#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/geometry/types.h"

namespace cullscope::ui {

/// A value of a JSON text together with its file and its path in the text, both of which error messages state. All reading
/// functions throw Error(Input) if the value is not of the requested kind.
class JsonField {
public:
    /// Pairs of a word in the file and the enumerator it stands for.
    template <typename Enum>
    using Words = std::span<const std::pair<const char*, Enum>>;

    /// The root of the text. `file` is used in error messages only.
    JsonField(const nlohmann::json& value, std::string file) : m_value(&value), m_file(std::move(file)) {}

    [[nodiscard]] JsonField at(const char* key) const;
    /// The value of a key; none if it is missing or null.
    [[nodiscard]] std::optional<JsonField> find(const char* key) const;
    /// The number of entries of a list, which may be at most `most`.
    [[nodiscard]] size_t listSize(size_t most) const;
    [[nodiscard]] JsonField at(size_t index) const;

    [[nodiscard]] double number() const;
    /// A number within inclusive bounds.
    [[nodiscard]] double number(double least, double most) const;
    [[nodiscard]] int wholeNumber(int least, int most) const;
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] Vec3 vector() const;
    [[nodiscard]] bool isText() const { return m_value->is_string(); }
    [[nodiscard]] bool isNull() const { return m_value->is_null(); }

    template <typename Enum>
    [[nodiscard]] Enum oneOf(Words<Enum> words) const {
        std::string known;
        for (const auto& [word, value] : words) {
            if (m_value->is_string() && m_value->get_ref<const std::string&>() == word) return value;
            known += (known.empty() ? "" : ", ") + std::string(word);
        }
        refuseWord(known);
    }

    /// Calls `visit` for every key of an object with its value.
    template <typename Visit>
    void forEach(const Visit& visit) const {
        requireObject();
        for (const auto& [key, value] : m_value->items()) visit(key, child(value, "." + key));
    }

    /// Runs `read` and returns its result. Puts file and path in front of the sentence of an Error that it throws.
    template <typename Read>
    auto checked(const Read& read) const {
        try {
            return read();
        } catch (const Error& error) {
            refuse(error);
        }
    }

private:
    JsonField(const nlohmann::json& value, std::string file, std::string place)
        : m_value(&value), m_file(std::move(file)), m_place(std::move(place)) {}

    [[nodiscard]] JsonField child(const nlohmann::json& value, const std::string& step) const;
    void requireObject() const;
    [[noreturn]] void refuse(const Error& error) const;
    [[noreturn]] void refuseWord(const std::string& known) const;
    [[noreturn]] void refuse(const char* sentence, std::vector<std::string> further = {}) const;

    const nlohmann::json* m_value;
    std::string m_file;
    std::string m_place;
};

}  // namespace cullscope::ui
