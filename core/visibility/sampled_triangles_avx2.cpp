#include "core/visibility/sampled_triangles_lanes.h"

namespace cullscope {
namespace {

struct EightLanes {
    static constexpr size_t kWide = 8;
    using Floats [[gnu::vector_size(4 * kWide)]] = float;
    using Ints [[gnu::vector_size(4 * kWide)]] = int32_t;
};

}  // namespace

void testSamplesAvx2(std::span<const CornerBlock> blocks, const SampleTest& test, BlockVerdict* verdicts) {
    testSamples<EightLanes>(blocks, test, verdicts);
}

}  // namespace cullscope
