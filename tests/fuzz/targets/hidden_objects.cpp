#include "core/scene/hidden.h"

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void hidden_objects(std::string_view input) {
    constexpr size_t kObjects = 100;
    std::vector<bool> hidden;
    if (!accepted({ErrorKind::Usage}, [&] { hidden = hiddenFromText(input, kObjects); })) return;
    require(hidden.size() == kObjects, "not one mark for each object");
    require(hiddenFromText(hiddenToText(hidden), kObjects) == hidden, "marks that are written are read back as others");
}

}  // namespace cullscope::fuzz
