#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/frame/named_parts.h"

namespace cullscope {

/// What an audience expects of a frame before it sees it.
struct Prediction {
    enum class Question {
        Vanish,  ///< of which items nothing is drawn; of triangles, neither those whose back OpenGL drops
        Order,   ///< in which order the items are drawn, by their first triangle
        Place    ///< in which of the strategy's places, such as the leaves of a tree, the items lie
    };
    /// What is named: instances or triangles of the scene, or parts (NamedParts::parts), each by its number.
    enum class Items { Objects, Triangles, Parts };
    Question question = Question::Vanish;
    Items of = Items::Objects;
    std::vector<uint64_t> items = {};                ///< as they were named, each once
    std::vector<std::optional<size_t>> places = {};  ///< with Question::Place, by item: where it is expected; none: not said yet

    /// Names an item, or takes it back if it was named.
    void toggle(uint64_t item);
    /// Names those of some items that are not named yet, or takes all of them back if they all were named.
    void toggle(std::span<const uint64_t> some);
    /// Says where the item that was named last is expected.
    void place(size_t place);
    bool operator==(const Prediction&) const = default;
};

/// An item beside what was expected of it.
struct PredictionRow {
    uint64_t item = 0;
    /// With Question::Vanish: 1 where it vanishes, 0 where it does not. With Question::Order: its place in the order, from 1.
    /// With Question::Place: the number of the place, from 0. None: it has no place.
    std::optional<size_t> expected, actual;

    [[nodiscard]] bool right() const { return expected == actual; }
    bool operator==(const PredictionRow&) const = default;
};

/// All instances of the scene or all parts, but of triangles and of what is asked about its place the named ones, by what the
/// frame drew. A finished picture has no order: what only it shows has no place. `parts`: the frame's, for questions about parts.
[[nodiscard]] std::vector<PredictionRow> answerTo(const Prediction& prediction, const Scene& scene, const FrameLog& log,
                                                  const NamedParts& parts = {});
/// How many rows are right.
[[nodiscard]] size_t rightRows(const std::vector<PredictionRow>& rows);

}  // namespace cullscope
