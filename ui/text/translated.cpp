#include "ui/text/translated.h"

#include <QCoreApplication>

namespace cullscope::ui {
namespace {

/// Translates an argument that is a marked text, such as the system's reason for a failure. Only arguments of several words are
/// looked up: a single word may be the name of a file or an object that is in the catalogue by chance ("hidden").
std::string translatedArgument(const std::string& argument) {
    if (argument.find(' ') == std::string::npos) return argument;
    const QString translation = QCoreApplication::translate(kCoreContext, argument.c_str());
    return translation == QString::fromStdString(argument) ? argument : translation.toStdString();
}

}  // namespace

QString translated(const Message& message) {
    const std::string sentence = QCoreApplication::translate(kCoreContext, message.text.c_str()).toStdString();
    std::vector<std::string> arguments;
    for (const std::string& argument : message.arguments) arguments.push_back(translatedArgument(argument));
    return QString::fromStdString(fillIn(sentence, arguments));
}

QString translated(std::string_view text) {
    if (text.empty()) return {};
    return QCoreApplication::translate(kCoreContext, std::string(text).c_str());
}

}  // namespace cullscope::ui
