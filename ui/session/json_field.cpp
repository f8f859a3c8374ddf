#include "ui/session/json_field.h"

#include <QCoreApplication>
#include <cmath>

#include "core/visibility/parameters.h"

namespace cullscope::ui {

JsonField JsonField::child(const nlohmann::json& value, const std::string& step) const {
    return {value, m_file, m_place.empty() && step.starts_with('.') ? step.substr(1) : m_place + step};
}

void JsonField::refuse(const char* sentence, std::vector<std::string> further) const {
    std::vector<std::string> arguments{m_file, m_place};
    arguments.insert(arguments.end(), further.begin(), further.end());
    throwInput(sentence, std::move(arguments));
}

void JsonField::refuse(const Error& error) const {
    refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\": %3"), {error.message().english()});
}

void JsonField::refuseWord(const std::string& known) const {
    refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be one of these words: %3."), {known});
}

void JsonField::requireObject() const {
    if (!m_value->is_object()) refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be a group of fields in braces."));
}

JsonField JsonField::at(const char* key) const {
    if (const std::optional<JsonField> found = find(key)) return *found;
    child(*m_value, std::string(".") + key).refuse(QT_TRANSLATE_NOOP("core", "%1: the field \"%2\" is missing."));
}

std::optional<JsonField> JsonField::find(const char* key) const {
    requireObject();
    const auto found = m_value->find(key);
    if (found == m_value->end() || found->is_null()) return std::nullopt;
    return child(*found, std::string(".") + key);
}

size_t JsonField::listSize(size_t most) const {
    if (!m_value->is_array() || m_value->empty() || m_value->size() > most)
        refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be a list of 1 to %3 entries."), {std::to_string(most)});
    return m_value->size();
}

JsonField JsonField::at(size_t index) const { return child((*m_value)[index], "[" + std::to_string(index) + "]"); }

double JsonField::number() const {
    if (!m_value->is_number()) refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be a number."));
    return m_value->get<double>();
}

double JsonField::number(double least, double most) const {
    const double number = m_value->is_number() ? m_value->get<double>() : std::nan("");
    if (!(number >= least && number <= most))
        refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be a number between %3 and %4."), {toText(least), toText(most)});
    return number;
}

int JsonField::wholeNumber(int least, int most) const {
    const double number = m_value->is_number_integer() ? m_value->get<double>() : std::nan("");
    if (!(number >= least && number <= most))
        refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be a whole number between %3 and %4."),
               {std::to_string(least), std::to_string(most)});
    return int(number);
}

bool JsonField::boolean() const {
    if (!m_value->is_boolean()) refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be true or false."));
    return m_value->get<bool>();
}

const std::string& JsonField::text() const {
    if (!m_value->is_string()) refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be a text in quotes."));
    return m_value->get_ref<const std::string&>();
}

Vec3 JsonField::vector() const {
    const auto isNumber = [](const nlohmann::json& each) { return each.is_number(); };
    if (!m_value->is_array() || m_value->size() != 3 || !std::all_of(m_value->begin(), m_value->end(), isNumber))
        refuse(QT_TRANSLATE_NOOP("core", "%1: \"%2\" must be three numbers."));
    return {(*m_value)[0].get<double>(), (*m_value)[1].get<double>(), (*m_value)[2].get<double>()};
}

}  // namespace cullscope::ui
