#include "core/visibility/sampled_triangles_lanes.h"

namespace cullscope {
namespace {

struct FourLanes {
    static constexpr size_t kWide = 4;
    using Floats [[gnu::vector_size(4 * kWide)]] = float;
    using Ints [[gnu::vector_size(4 * kWide)]] = int32_t;
};

}  // namespace

void testSamplesPortable(std::span<const CornerBlock> blocks, const SampleTest& test, BlockVerdict* verdicts) {
    testSamples<FourLanes>(blocks, test, verdicts);
}

}  // namespace cullscope
