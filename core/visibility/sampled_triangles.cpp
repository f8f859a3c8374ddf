#include "core/visibility/sampled_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/visibility/eye_bounds.h"

namespace cullscope {

CornerBlocks::CornerBlocks(const TriangleMesh& mesh, std::span<const uint32_t> indices) {
    const size_t count = indices.size() / 3;
    m_blocks.resize((count + kCornerBlock - 1) / kCornerBlock);
    for (size_t place = 0; place < m_blocks.size() * kCornerBlock; ++place) {
        auto& rows = m_blocks[place / kCornerBlock].rows;
        for (size_t row = 0; row < rows.size(); ++row)
            rows[row][place % kCornerBlock] = place < count ? mesh.positions()[indices[3 * place + row / 3]][int(row % 3)]
                                                            : std::numeric_limits<float>::quiet_NaN();
    }
    for (const Vec3f& position : mesh.positions()) m_reach = glm::max(m_reach, glm::abs(Vec3(position)));
}

namespace {

using SampleKernel = void(std::span<const CornerBlock>, const SampleTest&, BlockVerdict*);

SampleKernel* kernelOf([[maybe_unused]] SimdLevel level) {
#ifdef CULLSCOPE_SAMPLES_AVX
    if (level != SimdLevel::Scalar) return testSamplesAvx2;
#endif
    return testSamplesPortable;
}

/// The sum of the absolute values of a row's products with any corner: what its rounding is in proportion to.
double largestSum(const Mat4f& clip, int row, const Vec3& reach) {
    return std::abs(double(clip[0][row])) * reach.x + std::abs(double(clip[1][row])) * reach.y +
           std::abs(double(clip[2][row])) * reach.z + std::abs(double(clip[3][row]));
}

}  // namespace

SampledTriangles::SampledTriangles(const Scene& scene, uint32_t instance, const CornerBlocks& corners, const View& view,
                                   Facing facing, SimdLevel level)
    : m_corners(corners), m_kernel(kernelOf(level)) {
    const Mat4& worldFromMesh = scene.instances()[instance].worldFromMesh;
    const Mat4f clip = view.clipFromPositions(worldFromMesh, scene.meshOf(instance).origin());
    const auto width = double(view.viewport().width), height = double(view.viewport().height);
    for (int column = 0; column < 4; ++column) {
        m_test.x[size_t(column)] = float(0.5 * width * (double(clip[column][0]) + double(clip[column][3])));
        m_test.y[size_t(column)] = float(0.5 * height * (double(clip[column][1]) + double(clip[column][3])));
        m_test.w[size_t(column)] = clip[column][3];
    }
    m_test.width = float(width);
    m_test.height = float(height);
    // With S a bound on the absolute values of a row's products, a row is off by 4 u S in OpenGL and by 5 u S here, u = 2^-24
    // (there the matrix is the same, here it is scaled to pixels). A place x = X / w between -1 and 2 times the width is then off
    // by (4.5 Sx + 16.5 Sw) u · width / w in all, and by a few u · width for the quotients. Taken: about twice that, for an
    // OpenGL whose quotients are less exact, and snapping to 1/256 pixel in any direction.
    const double sumW = largestSum(clip, 3, corners.reach());
    m_test.room = float(0x1p-8 + 0x1p-20 * std::max(width, height));
    m_test.roomTimesW = float(std::max(width * (0x1p-20 * largestSum(clip, 0, corners.reach()) + 0x1p-19 * sumW),
                                       height * (0x1p-20 * largestSum(clip, 1, corners.reach()) + 0x1p-19 * sumW)));
    const Frustum& frustum = view.frustum();
    if (frustum.parallel()) {
        // There w is 1, and whether a plane clips a triangle is known of the object as a whole.
        const EyeBox box = relativeToEye(scene.instanceBox(instance), view.eye());
        const double margin = depthRoom(frustum.farDistance);
        const bool unclipped = nearestAhead(box, frustum) > frustum.nearDistance + margin &&
                               farthestAhead(box, frustum) < frustum.farDistance - margin;
        m_test.leastW = unclipped ? 0.5f : std::numeric_limits<float>::infinity();
        m_test.mostW = 2.0f;
    } else {
        m_test.leastW = float(frustum.nearDistance * (1.0 + 0x1p-10) + 0x1p-19 * sumW);
        m_test.mostW = float(frustum.farDistance * (1.0 - 0x1p-10) - 0x1p-19 * sumW);
    }
    if (dropsBacks(scene, instance, facing)) m_test.front = glm::determinant(Mat3(worldFromMesh)) < 0.0 ? -1.0f : 1.0f;
}

namespace {

/// Appends the triangles of a block that are left out, among the places whose bits are set in `within`.
void addOthers(uint32_t first, const BlockVerdict& verdict, uint32_t within, std::vector<LeftOutTriangles::Run>& runs) {
    for (uint32_t i = 0; i < kCornerBlock; ++i) {
        const uint32_t bit = within & 1U << i;
        const bool away = (verdict.facesAway & bit) != 0;
        if (!away && (verdict.holdsNoCentre & bit) == 0) continue;
        const Cause cause = away ? Cause::BackFacing : Cause::NoSample;
        if (!runs.empty() && runs.back().cause == cause && runs.back().places.first + runs.back().places.count == first + i)
            ++runs.back().places.count;
        else
            runs.push_back({{first + i, 1}, cause});
    }
}

}  // namespace

SampledTriangles::Found SampledTriangles::among(std::span<const PlaceRun> runs, bool others) const {
    constexpr uint32_t kAtATime = 8192;
    std::vector<PlaceRun> pieces;
    for (const PlaceRun& run : runs)
        for (uint32_t done = 0; done < run.count; done += kAtATime)
            pieces.push_back({run.first + done, std::min(kAtATime, run.count - done)});
    // Short runs are tested together.
    std::vector<size_t> ends;
    uint32_t together = 0;
    for (size_t i = 0; i < pieces.size(); ++i) {
        together += pieces[i].count;
        if (together < kAtATime && i + 1 < pieces.size()) continue;
        ends.push_back(i + 1);
        together = 0;
    }
    std::vector<Found> parts(ends.size());
    tbb::parallel_for(size_t{0}, parts.size(), [&](size_t part) {
        for (size_t i = part == 0 ? 0 : ends[part - 1]; i < ends[part]; ++i) add(pieces[i], others, parts[part]);
    });
    Found all;
    for (const Found& part : parts) {
        all.kept.insert(all.kept.end(), part.kept.begin(), part.kept.end());
        all.leftOut.insert(all.leftOut.end(), part.leftOut.begin(), part.leftOut.end());
        all.facingAway += part.facingAway;
        all.withoutSample += part.withoutSample;
    }
    return all;
}

double SampledTriangles::estimatedShare(std::span<const PlaceRun> runs, double weightOfAway) const {
    constexpr uint32_t kTested = 2 * uint32_t(kCornerBlock), kEvery = 32 * kTested;
    Found found;
    uint64_t tested = 0, next = 0, before = 0;  // by number among the places of all runs
    for (const PlaceRun& run : runs) {
        for (; next < before + run.count; next += kEvery) {
            const auto first = uint32_t(next - before);
            const PlaceRun part{run.first + first, std::min(kTested, run.count - first)};
            found.kept.clear();
            add(part, false, found);
            tested += part.count;
        }
        before += run.count;
    }
    return tested == 0 ? 0.0 : (weightOfAway * double(found.facingAway) + double(found.withoutSample)) / double(tested);
}

void SampledTriangles::add(const PlaceRun& places, bool others, Found& found) const {
    constexpr size_t kAtATime = 64;
    std::array<BlockVerdict, kAtATime> verdicts;
    const uint32_t end = places.first + places.count;
    uint32_t begin = 0, next = 0;  // of the run in hand
    for (size_t block = places.first / kCornerBlock; block * kCornerBlock < end; block += kAtATime) {
        const size_t blocks = std::min(kAtATime, (end + kCornerBlock - 1) / kCornerBlock - block);
        m_kernel(m_corners.blocks().subspan(block, blocks), m_test, verdicts.data());
        for (size_t i = 0; i < blocks; ++i) {
            const auto first = uint32_t((block + i) * kCornerBlock);
            uint32_t within = 0xffff;
            if (first < places.first) within &= 0xffffU << (places.first - first);
            if (first + kCornerBlock > end) within &= 0xffffU >> (first + kCornerBlock - end);
            const BlockVerdict& verdict = verdicts[i];
            found.facingAway += uint64_t(std::popcount(verdict.facesAway & within));
            found.withoutSample += uint64_t(std::popcount(verdict.holdsNoCentre & within));
            if (others) addOthers(first, verdict, within, found.leftOut);
            uint32_t may = within & ~(uint32_t(verdict.facesAway) | verdict.holdsNoCentre);
            while (may != 0) {
                const auto zeros = uint32_t(std::countr_zero(may)), ones = uint32_t(std::countr_one(may >> zeros));
                may &= ~(((1U << ones) - 1) << zeros);
                if (first + zeros != next || begin == next) {
                    if (begin != next) found.kept.push_back({begin, next - begin});
                    begin = first + zeros;
                }
                next = first + zeros + ones;
            }
        }
    }
    if (begin != next) found.kept.push_back({begin, next - begin});
}

}  // namespace cullscope
