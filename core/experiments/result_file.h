#pragma once

#include <filesystem>
#include <string>

#include "core/measure/meter.h"

namespace cullscope {

/// A measurement as JSON text and as CSV (one row a frame, same names): measurement.md, "Result".
[[nodiscard]] std::string resultJson(const MeasureResult& result);
[[nodiscard]] std::string resultCsv(const MeasureResult& result);

/// "front" and "two-sided", as in files; English marked for translation.
[[nodiscard]] const char* facingId(Facing facing);

/// Program, version and commit it was built from.
struct ToolVersion {
    std::string name, version, commit;
};
[[nodiscard]] ToolVersion toolVersion();

/// The processor's name as the system tells it.
[[nodiscard]] std::string cpuName();

}  // namespace cullscope
