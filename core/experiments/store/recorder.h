#pragma once

#include <mutex>
#include <optional>

#include "core/base/error.h"
#include "core/experiments/store/result_store.h"

namespace cullscope::store {

/// Puts measurements into a store while they run: each pose is committed once all its strategies are measured, so that a killed
/// program loses at most the pose in progress. Where the store cannot be written any more, as on a full disk, the measurement
/// goes on without it, and the failure is kept.
class Recorder {
public:
    /// Opens the store; throws where that fails, before anything is measured.
    Recorder(const std::filesystem::path& file, Origin origin);

    void setExperiment(const std::string& id) { m_origin.experiment = id; }
    /// To be called after every pose of a measurement, and at its end. Neither throws an Error.
    void afterPose(const Meter& meter);
    void end(bool interrupted);

    /// The newest measurement's number; none where nothing was committed.
    [[nodiscard]] std::optional<int64_t> newest() const;
    /// Why what was measured is not in the store; none: it is.
    [[nodiscard]] std::optional<Error> failure() const;

private:
    mutable std::mutex m_mutex;  ///< the desktop measures on one thread and asks on another
    ResultStore m_store;
    Origin m_origin;
    std::optional<int64_t> m_current, m_newest;
    std::optional<Error> m_failure;
};

/// Measures as `measure` does, and records where there is a recorder.
[[nodiscard]] MeasureResult measureInto(Recorder* recorder, const MeasureRequest& request, const Progress& progress = {},
                                        MeasuredScene* shared = nullptr);

}  // namespace cullscope::store
