#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>

namespace cullscope {

/// Calls `work(i)` for every i below `count`, on all processors or one after the other.
template <typename Work>
void forEachOf(size_t count, bool parallel, const Work& work) {
    if (parallel)
        tbb::parallel_for(size_t{0}, count, work);
    else
        for (size_t i = 0; i < count; ++i) work(i);
}

}  // namespace cullscope
