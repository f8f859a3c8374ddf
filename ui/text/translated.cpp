#include "ui/text/translated.h"

#include <QCoreApplication>

namespace cullscope::ui {

QString translated(const Message& message) {
    const std::string sentence = QCoreApplication::translate(kCoreContext, message.text.c_str()).toStdString();
    return QString::fromStdString(fillIn(sentence, message.arguments));
}

QString translated(std::string_view text) {
    if (text.empty()) return {};
    return QCoreApplication::translate(kCoreContext, std::string(text).c_str());
}

}  // namespace cullscope::ui
