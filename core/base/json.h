#pragma once

#include <nlohmann/json.hpp>

namespace cullscope {

/// JSON whose fields keep their order: what the project writes, and reads where the order does not matter.
using Json = nlohmann::ordered_json;

}  // namespace cullscope
