#pragma once

#include <filesystem>
#include <string>

#include "core/measure/meter.h"

namespace cullscope {

/// A measurement as JSON text and as CSV (one row for each frame, same names): docs/files.md.
[[nodiscard]] std::string resultJson(const MeasureResult& result);
[[nodiscard]] std::string resultCsv(const MeasureResult& result);

/// "front" and "two-sided", as in files; English marked for translation.
[[nodiscard]] const char* facingId(Facing facing);

/// Name and version of the program and the commit that it was built from.
struct ToolVersion {
    std::string name, version, commit;
};
[[nodiscard]] ToolVersion toolVersion();

/// The name of the processor as the operating system reports it.
[[nodiscard]] std::string cpuName();

}  // namespace cullscope
