#pragma once

#include <string>
#include <string_view>

#include "core/frame/words.h"

namespace cullscope::cullbench {

/// The desktop's catalogue of one language, for pictures with words: cullbench itself speaks English.
class Catalogue {
public:
    /// "en", "ko" or "zh_CN".
    explicit Catalogue(std::string_view language);

    /// Words of core in that language; in English where the catalogue has none.
    [[nodiscard]] std::string say(const Words& words) const;

private:
    [[nodiscard]] std::string translated(const std::string& text) const;

    std::string_view m_file;  ///< empty: English
};

}  // namespace cullscope::cullbench
