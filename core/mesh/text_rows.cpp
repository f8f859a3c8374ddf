#include "core/mesh/text_rows.h"

#include "core/base/error.h"
#include "core/mesh/numbers_in_text.h"

namespace cullscope {

bool TextRows::nextRow() {
    while (m_source.line(m_rest)) {
        if (m_comment != '\0') m_rest = m_rest.substr(0, m_rest.find(m_comment));
        if (hasMore()) return true;
    }
    m_rest = {};
    return false;
}

std::string_view TextRows::word() {
    for (;;) {
        const std::string_view word = takeWord(m_rest);
        if (!word.empty()) return word;
        if (!nextRow()) refuseEnd();
    }
}

double TextRows::real() {
    const std::string_view text = word();
    double value = 0.0;
    if (!parseReal(text, value)) refuseNumber(text);
    return value;
}

int64_t TextRows::integer() {
    const std::string_view text = word();
    int64_t value = 0;
    if (!parseInteger(text, value)) refuseNumber(text);
    return value;
}

void TextRows::refuseEnd() const {
    throwInput(CULLSCOPE_TR("%1 ends after line %2, before everything that it promises. The file was cut off: fetch it again."),
               {m_source.name(), std::to_string(m_source.lineNumber())});
}

void TextRows::refuseNumber(std::string_view word) const {
    throwInput(
        CULLSCOPE_TR("%1, line %2: \"%3\" is not a number that can stand here. Correct the line or export the file again."),
        {m_source.name(), std::to_string(m_source.lineNumber()), shownWord(word)});
}

}  // namespace cullscope
