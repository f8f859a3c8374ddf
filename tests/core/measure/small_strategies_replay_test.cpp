// Replays of the five small strategies' frames: by tiles of a screenshot, and of a part of their logs.
#include <algorithm>
#include <set>

#include "tests/core/measure/small_strategies_bench.h"

namespace cullscope::test::small_strategies_replay_test {
namespace {

class EverySmallStrategy : public testing::TestWithParam<RegisteredStrategy (*)()> {
protected:
    /// A view with the past that a frame needs which leaves something out.
    void prepare(Bench& bench, const View& view) const {
        if (bench.built->info().remembers) (void)bench.decide(view);
    }
};

/// Copies a tile's rows to their place in the whole picture.
template <typename Value>
void place(const std::vector<Value>& from, const PictureTile& tile, size_t values, std::vector<Value>& whole, int width) {
    whole.resize(std::max(whole.size(), values * size_t(width) * size_t(tile.y + tile.size.height)));
    for (int row = 0; row < tile.size.height; ++row)
        std::copy_n(from.begin() + std::ptrdiff_t(values) * row * tile.size.width, values * size_t(tile.size.width),
                    whole.begin() + std::ptrdiff_t(values) * ((tile.y + row) * width + tile.x));
}

/// A picture and its item buffer, drawn by tiles of at most `side` pixels.
struct Tiled {
    Picture picture;
    ShownPixels items;

    Tiled(const Bench& bench, const View& view, const FrameLog& log, int side) {
        const Viewport& size = view.viewport();
        for (int y = 0; y < size.height; y += side)
            for (int x = 0; x < size.width; x += side) {
                const PictureTile tile{x, y, {std::min(side, size.width - x), std::min(side, size.height - y)}};
                const Picture part = bench.replayed(view, log, tile);
                place(part.colour, tile, 4, picture.colour, size.width);
                place(part.depth, tile, 1, picture.depth, size.width);
                const Renderer::ItemBuffer shown = GlEnvironment::renderer().drawItemBuffer(bench.buffers, view, log, tile);
                place(shown.depth, tile, 1, items.depth, size.width);
                place(shown.triangle, tile, 1, items.triangle, size.width);
            }
    }
};

TEST_P(EverySmallStrategy, aScreenshotByTilesIsTheUntiledPicture) {
    constexpr int kTile = 4096;  // the desktop's
    const Viewport size = longMode() ? Viewport{3840, 2160} : Viewport{960, 540};
    Bench bench(GetParam()());
    Random random(3);
    const View view = somewhere(random, size);
    prepare(bench, view);
    const auto [own, log] = bench.drawn(view);
    const Tiled screenshot(bench, view, log, kTile);
    EXPECT_TRUE(screenshot.picture == own) << "pixel for pixel";

    // Smaller tiles begin at other places of the raster, where OpenGL rounds a vertex and a depth otherwise.
    const Tiled small(bench, view, log, size.width / 4);
    Reference whole;
    whole.size = size;
    whole.triangle = screenshot.items.triangle;
    whole.depth = screenshot.items.depth;
    size_t otherTriangle = 0, otherColour = 0;
    for (size_t i = 0; i < whole.triangle.size(); ++i) {
        const bool same = whole.triangle[i] == small.items.triangle[i];
        otherTriangle += same ? 0 : 1;
        for (size_t channel = 4 * i; same && channel < 4 * i + 4; ++channel)
            otherColour += std::abs(int(own.colour[channel]) - int(small.picture.colour[channel])) > 1 ? 1 : 0;
    }
    EXPECT_EQ(missedBeyondSnapping(whole, small.items, *bench.scene, view), 0u);
    EXPECT_EQ(extraBeyondSnapping(whole, small.items, *bench.scene, view), 0u);
    EXPECT_LE(otherTriangle, whole.triangle.size() / 100'000);
    EXPECT_EQ(otherColour, 0u) << "by more than the last step of 255";
}

/// How many of the first `entries` entries of a frame are commands: each decision stands behind as many as it says.
size_t commandsAmong(const FrameLog& log, size_t entries) {
    size_t commands = 0, decisions = 0;
    for (size_t entry = 0; entry < entries; ++entry) {
        const bool decided = decisions < log.decisions.size() && log.decisions[decisions].commands <= commands;
        ++(decided ? decisions : commands);
    }
    return commands;
}

TEST_P(EverySmallStrategy, aLogThatIsCutReplaysToThePictureSoFar) {
    constexpr Viewport kSmall{80, 60};
    Bench bench(GetParam()(), manySpheres());
    Random random(4);
    const View view = somewhere(random, kSmall);
    prepare(bench, view);
    const FrameLog log = bench.decide(view);
    // What OpenGL chooses is decided in one command.
    ASSERT_TRUE(log.entries() > 200 || log.decisions.empty()) << "enough places to cut it";
    // The picture after each command, executed one by one as the frame did.
    std::vector<Picture> soFar;
    Framebuffer target(kSmall);
    GlEnvironment::renderer().clear(view, target, {});
    for (size_t command = 0; command <= log.commands.size(); ++command) {
        if (command > 0) GlEnvironment::renderer().execute(bench.buffers, view, log.commands[command - 1], target, {});
        soFar.push_back({target.readColour(), target.readDepth()});
    }
    EXPECT_TRUE(std::ranges::all_of(soFar.front().depth, [](float depth) { return depth == 0.0f; }));
    EXPECT_FALSE(soFar.back() == soFar.front());
    const size_t places = howMany(200, 40);
    std::set<size_t> cut;
    for (size_t i = 0; i <= places; ++i) cut.insert(i * log.entries() / places);
    for (const size_t entries : cut) {
        const FrameLog part = log.upTo(entries);
        ASSERT_EQ(part.entries(), entries);
        const size_t commands = commandsAmong(log, entries);
        EXPECT_EQ(part.commands.size(), commands) << "at " << entries;
        EXPECT_TRUE(bench.replayed(view, part, {0, 0, kSmall}) == soFar[commands]) << "at " << entries;
    }
}

INSTANTIATE_TEST_SUITE_P(Small, EverySmallStrategy,
                         testing::Values(backToFront, tracedPicture, halfThenAsk, lastFrame, chosenByGpu),
                         [](const auto& strategy) {
                             std::string name = strategy.param().info.id;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace cullscope::test::small_strategies_replay_test
