#include "app/cullbench/language.h"

#include "embedded/catalogues.h"

namespace cullscope::cullbench {
namespace {

constexpr std::string_view kContext = "<name>core</name>";

/// A text as the catalogue writes it, in XML.
std::string inXml(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\'')
            result += "&apos;";
        else
            result += c;
    }
    return result;
}

std::string outOfXml(std::string_view text) {
    static constexpr std::pair<std::string_view, char> kNames[]{
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
    std::string result;
    while (!text.empty()) {
        char c = text.front();
        size_t length = 1;
        for (const auto& [name, letter] : kNames)
            if (text.starts_with(name)) c = letter, length = name.size();
        result += c;
        text.remove_prefix(length);
    }
    return result;
}

}  // namespace

Catalogue::Catalogue(std::string_view language) {
    const std::string_view file = language == "ko"      ? embedded::cullscope_ko_ts
                                  : language == "zh_CN" ? embedded::cullscope_zh_CN_ts
                                                        : std::string_view();
    const size_t context = file.find(kContext);
    if (context == std::string_view::npos) return;
    m_file = file.substr(context);
    m_file = m_file.substr(0, m_file.find("</context>"));
}

std::string Catalogue::translated(const std::string& text) const {
    constexpr std::string_view kBegin = "<translation>", kEnd = "</translation>";
    const std::string source = "<source>" + inXml(text) + "</source>";
    const size_t found = m_file.find(source);
    if (found == std::string_view::npos) return text;
    const std::string_view rest = m_file.substr(found + source.size(), m_file.find("</message>", found) - found - source.size());
    const size_t begin = rest.find(kBegin), end = rest.find(kEnd);
    if (begin == std::string_view::npos || end == std::string_view::npos) return text;
    return outOfXml(rest.substr(begin + kBegin.size(), end - begin - kBegin.size()));
}

std::string Catalogue::say(const Words& words) const {
    std::vector<std::string> arguments;
    for (const Term& term : words.terms)
        arguments.push_back(term.form == Term::Form::Marked ? translated(term.text) : term.english());
    return fillIn(translated(words.text), arguments);
}

}  // namespace cullscope::cullbench
