#include "core/base/message.h"

namespace cullscope {

std::string fillIn(std::string_view text, const std::vector<std::string>& arguments) {
    std::string filled;
    filled.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        const bool place = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9';
        const size_t argument = place ? static_cast<size_t>(text[i + 1] - '1') : arguments.size();
        if (argument < arguments.size()) {
            filled += arguments[argument];
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

std::string Message::english() const { return fillIn(text, arguments); }

}  // namespace cullscope
