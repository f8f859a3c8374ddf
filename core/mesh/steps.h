#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/progress.h"

namespace cullscope {

/// Calls `work(begin, end)` over [0, count) in pieces of a few milliseconds, and checks for a stop request before every piece.
template <typename Work>
void inSteps(size_t count, const Progress& progress, Work&& work, size_t step = size_t{1} << 17) {
    for (size_t begin = 0; begin < count; begin += step) {
        progress.check();
        work(begin, std::min(count, begin + step));
    }
}

/// Sorts in pieces and checks for a stop request between them: std::sort over blocks, then merges. Not necessarily stable.
template <typename Value>
void sortInSteps(std::span<Value> values, const Progress& progress) {
    constexpr size_t kSortedAtOnce = size_t{1} << 18;
    inSteps(
        values.size(), progress, [&](size_t begin, size_t end) { std::sort(values.begin() + begin, values.begin() + end); },
        kSortedAtOnce);
    if (values.size() <= kSortedAtOnce) return;
    std::vector<Value> other(values.size());
    std::span<Value> from = values;
    std::span<Value> to = other;
    for (size_t width = kSortedAtOnce; width < values.size(); width *= 2) {
        for (size_t begin = 0; begin < values.size(); begin += 2 * width) {
            progress.check();
            const size_t middle = std::min(values.size(), begin + width);
            const size_t end = std::min(values.size(), begin + 2 * width);
            std::merge(from.begin() + begin, from.begin() + middle, from.begin() + middle, from.begin() + end,
                       to.begin() + begin);
        }
        std::swap(from, to);
    }
    if (from.data() != values.data()) std::copy(from.begin(), from.end(), values.begin());
}

}  // namespace cullscope
