#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/experiments/certify/random_scenes.h"
#include "core/gpu/renderer.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::certify {

/// Views are tried in blocks: a random scene and so many random views of it. A block's number is the seed of both.
inline constexpr uint64_t kViewsOfABlock = 50;
/// Of these views: a block's number gives others in another version. Since 2 some views are parallel ones.
inline constexpr uint64_t kViewsVersion = 2;

/// A scene and a view in which a strategy lost what it promises to keep.
struct Counterexample {
    uint64_t block = 0, view = 0;  ///< which gave it
    uint64_t lostPixels = 0;       ///< of the view as it was tried
    uint64_t triangles = 0;        ///< of the scene that it was shrunk to
    uint64_t objects = 0;
    Viewport size{};           ///< of the view that it was shrunk to
    std::string file{};        ///< of the case that was written, without an ending; empty: none was
    bool fileShowsIt = false;  ///< whether the loss is seen in the scene as it is read back from the file
};

/// What was tried so far: of one shard, or merged.
struct Certificate {
    std::string strategy;  ///< strategyText
    uint64_t seed = 0;
    uint64_t blocks = 0;             ///< of all shards together
    uint64_t shard = 1, shards = 1;  ///< from 1; merged: 1 of 1
    std::vector<bool> done{};        ///< by block
    uint64_t views = 0;              ///< tried
    uint64_t promised = 0;           ///< of these, where it promises to lose nothing
    uint64_t refused = 0;            ///< views of scenes that it does not serve
    uint64_t coveredPixels = 0;      ///< of the views where it promises so
    std::vector<Counterexample> counterexamples{};
    uint64_t viewsVersion = kViewsVersion;

    [[nodiscard]] bool ofShard(uint64_t block) const { return block % shards == shard - 1; }
    [[nodiscard]] uint64_t blocksDone() const;
    [[nodiscard]] uint64_t blocksToDo() const;
    [[nodiscard]] bool complete() const { return blocksDone() == blocksToDo(); }
};

/// What was found in a block, of one strategy.
struct BlockResult {
    uint64_t views = 0, promised = 0, refused = 0, coveredPixels = 0;
    std::vector<Counterexample> counterexamples{};
};
struct CertifyRequest;
/// Tries a block, and returns the results by strategy.
using BlockTrier = std::function<std::vector<BlockResult>(uint64_t block, const Progress& progress)>;
/// Makes a trier of a request's blocks.
using TrierMaker = std::function<BlockTrier(const CertifyRequest& request)>;

struct CertifyRequest {
    std::vector<StrategyRequest> strategies;  ///< tried at the same views, whose truth is drawn once
    uint64_t views = 10'000;
    uint64_t seed = 1;
    uint64_t shard = 1, shards = 1;
    std::filesystem::path state{};    ///< read where it is there, and written after every few seconds; empty: none
    std::filesystem::path cases{};    ///< folder for counterexamples; empty: none are written
    size_t threads = 0;               ///< how many triers; 0: one for each processor
    size_t mostCounterexamples = 10;  ///< of all strategies, after which it ends
    TrierMaker trier{};               ///< of several at once; none: one context of OpenGL in this process tries all blocks
};

/// Tries random views until all blocks are done, a stop is requested, or there are enough counterexamples. One certificate for
/// each strategy, with the same blocks done. Throws Error(Usage) where there is no strategy, or one twice, or the state is of
/// another request.
[[nodiscard]] std::vector<Certificate> certify(const CertifyRequest& request, const Progress& progress = {});

/// One block, on the calling thread with its current context, of each strategy. Nothing is written.
[[nodiscard]] std::vector<BlockResult> certifyBlock(const CertifyRequest& request, uint64_t block, Renderer& renderer,
                                                    const Progress& progress = {});

/// The results of a block as a line of JSON, and back. Throws Error(Input) for another text.
[[nodiscard]] std::string blockJson(const std::vector<BlockResult>& results);
[[nodiscard]] std::vector<BlockResult> blockFromJson(const std::string& text);

/// A file holds one certificate, or a list of those of several strategies.
[[nodiscard]] std::vector<Certificate> readCertificates(const std::filesystem::path& file);
void writeCertificates(const std::filesystem::path& file, const std::vector<Certificate>& certificates);
[[nodiscard]] std::string certificateJson(const Certificate& certificate);
/// As a file holds them.
[[nodiscard]] std::string certificatesJson(const std::vector<Certificate>& certificates);
/// The certificates of several shards, or of one, as one for each strategy, in the order in which they come. Throws Error(Usage)
/// where those of a strategy are of other seeds, numbers or versions of views, or two of them tried the same block.
[[nodiscard]] std::vector<Certificate> merged(const std::vector<Certificate>& certificates);
/// What they say, in a few lines.
[[nodiscard]] std::string certificateText(const Certificate& certificate);

}  // namespace cullscope::certify
