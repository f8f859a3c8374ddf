#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope {

struct ToolVersion;

/// The fields of result files and of the store, in their order.
using ResultFields = nlohmann::ordered_json;

/// The fields of one frame, the same in JSON and CSV. A value that was not measured is null.
[[nodiscard]] ResultFields frameFields(const FrameMeasurement& frame);
[[nodiscard]] ResultFields summaryFields(const Summary& summary);
/// The fields of a run besides its frames; also the first columns of its CSV rows.
[[nodiscard]] ResultFields runHeadFields(const RunMeasurement& run, const MeasureRequest& request);
/// What measured: the first fields of a result file.
[[nodiscard]] ResultFields headFields(const ToolVersion& tool, const std::string& cpu, const GlInfo& gl);

/// A run in fields.
struct FieldsOfRun {
    ResultFields before;  ///< columns of CSV rows before those of the head
    ResultFields head;
    std::vector<ResultFields> frames;
};
/// A run of a result file.
[[nodiscard]] ResultFields runFields(const FieldsOfRun& run, const Summary& summary);

/// A result file's text.
[[nodiscard]] std::string fieldsText(const ResultFields& fields);
/// One row for each frame; the columns of the first run's heads.
[[nodiscard]] std::string framesCsv(const std::vector<FieldsOfRun>& runs);

}  // namespace cullscope
