#pragma once

#include <optional>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope {

/// What an audience expects of a frame before it sees it.
struct Prediction {
    enum class Question {
        Vanish,  ///< of which items nothing is drawn
        Order    ///< in which order the items are drawn, by their first triangle
    };
    Question question = Question::Vanish;
    bool ofTriangles = false;          ///< items are numbers of the scene's triangles, else of its instances
    std::vector<uint64_t> items = {};  ///< as they were named, each once

    /// Names an item, or takes it back if it was named.
    void toggle(uint64_t item);
    bool operator==(const Prediction&) const = default;
};

/// An item beside what was expected of it.
struct PredictionRow {
    uint64_t item = 0;
    /// With Question::Vanish: 1 where it vanishes, 0 where it does not. With Question::Order: its place in the order, from 1;
    /// none: it has no place.
    std::optional<size_t> expected, actual;

    [[nodiscard]] bool right() const { return expected == actual; }
    bool operator==(const PredictionRow&) const = default;
};

/// All instances of the scene, or the named triangles, by what the frame drew. A finished picture has no order: what only it
/// shows has no place.
[[nodiscard]] std::vector<PredictionRow> answerTo(const Prediction& prediction, const Scene& scene, const FrameLog& log);
/// How many rows are right.
[[nodiscard]] size_t rightRows(const std::vector<PredictionRow>& rows);

}  // namespace cullscope
