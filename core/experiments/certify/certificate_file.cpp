// The JSON form of a certificate, and several as one.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/experiments/certify/certify.h"
#include "core/experiments/result_file.h"

namespace cullscope::certify {
namespace {

/// Blocks as ranges "0-41", so that a million views take a line.
Json rangesOfBlocks(const std::vector<bool>& done) {
    Json ranges = Json::array();
    for (size_t i = 0; i < done.size();) {
        if (!done[i]) {
            ++i;
            continue;
        }
        size_t end = i;
        while (end < done.size() && done[end]) ++end;
        ranges.push_back({i, end - 1});
        i = end;
    }
    return ranges;
}

Json jsonOf(const std::vector<Counterexample>& counterexamples) {
    Json examples = Json::array();
    for (const Counterexample& one : counterexamples)
        examples.push_back({{"block", one.block},
                            {"view", one.view},
                            {"lost_pixels", one.lostPixels},
                            {"triangles", one.triangles},
                            {"objects", one.objects},
                            {"size", {one.size.width, one.size.height}},
                            {"file", one.file},
                            {"file_shows_it", one.fileShowsIt}});
    return examples;
}

Json jsonOf(const Certificate& certificate) {
    return {{"certificate", certificate.viewsVersion},
            {"tool", {{"name", "cullscope"}, {"version", toolVersion().version}, {"commit", toolVersion().commit}}},
            {"strategy", certificate.strategy},
            {"seed", certificate.seed},
            {"blocks", certificate.blocks},
            {"views_of_a_block", kViewsOfABlock},
            {"shard", certificate.shard},
            {"shards", certificate.shards},
            {"complete", certificate.complete()},
            {"views", certificate.views},
            {"promised_views", certificate.promised},
            {"refused_views", certificate.refused},
            {"covered_pixels", certificate.coveredPixels},
            {"lost_views", certificate.counterexamples.size()},
            {"counterexamples", jsonOf(certificate.counterexamples)},
            {"blocks_done", rangesOfBlocks(certificate.done)}};
}

/// Throws Json::exception as below.
std::vector<Counterexample> counterexamplesOf(const Json& list) {
    std::vector<Counterexample> counterexamples;
    for (const Json& one : list)
        counterexamples.push_back({one.at("block").get<uint64_t>(), one.at("view").get<uint64_t>(),
                                   one.at("lost_pixels").get<uint64_t>(), one.at("triangles").get<uint64_t>(),
                                   one.at("objects").get<uint64_t>(),
                                   Viewport{one.at("size").at(0).get<int>(), one.at("size").at(1).get<int>()},
                                   one.at("file").get<std::string>(), one.at("file_shows_it").get<bool>()});
    return counterexamples;
}

/// Throws Json::exception where fields are missing or of other kinds.
Certificate certificateOf(const Json& root, const std::filesystem::path& file) {
    constexpr uint64_t kMostBlocks = 10'000'000'000 / kViewsOfABlock;  // as many views as certify takes
    Certificate certificate;
    certificate.viewsVersion = root.at("certificate").get<uint64_t>();
    if (certificate.viewsVersion < 1 || certificate.viewsVersion > kViewsVersion || root.at("views_of_a_block") != kViewsOfABlock)
        throwInput(CULLSCOPE_TR("%1 was written by another version: its blocks are not those of this one."), {file.string()});
    certificate.strategy = root.at("strategy").get<std::string>();
    certificate.seed = root.at("seed").get<uint64_t>();
    certificate.blocks = root.at("blocks").get<uint64_t>();
    certificate.shard = root.at("shard").get<uint64_t>();
    certificate.shards = root.at("shards").get<uint64_t>();
    certificate.views = root.at("views").get<uint64_t>();
    certificate.promised = root.at("promised_views").get<uint64_t>();
    certificate.refused = root.at("refused_views").get<uint64_t>();
    certificate.coveredPixels = root.at("covered_pixels").get<uint64_t>();
    if (certificate.blocks < 1 || certificate.blocks > kMostBlocks || certificate.shard < 1 ||
        certificate.shard > certificate.shards)
        throwInput(
            CULLSCOPE_TR("%1 is no state of cullbench certify that can be read. Name another file, or remove it and begin anew."),
            {file.string()});
    certificate.done.assign(certificate.blocks, false);
    uint64_t next = 0;
    for (const Json& range : root.at("blocks_done")) {
        const auto first = range.at(0).get<uint64_t>();
        const auto last = range.at(1).get<uint64_t>();
        // They are written in order; a file in which they overlap would be read for hours.
        if (first < next || last < first || last >= certificate.blocks)
            throwInput(
                CULLSCOPE_TR(
                    "%1 is no state of cullbench certify that can be read. Name another file, or remove it and begin anew."),
                {file.string()});
        std::fill(certificate.done.begin() + int64_t(first), certificate.done.begin() + int64_t(last) + 1, true);
        next = last + 1;
    }
    certificate.counterexamples = counterexamplesOf(root.at("counterexamples"));
    return certificate;
}

/// Adds what another shard of the same run tried.
void addTo(Certificate& all, const Certificate& one) {
    if (one.seed != all.seed || one.blocks != all.blocks)
        throwUsage(CULLSCOPE_TR("The state files are of different runs: %1 with seed %2 and %3 blocks, and %4 with seed %5 and "
                                "%6 blocks."),
                   {all.strategy, std::to_string(all.seed), std::to_string(all.blocks), one.strategy, std::to_string(one.seed),
                    std::to_string(one.blocks)});
    if (one.viewsVersion != all.viewsVersion)
        throwUsage(CULLSCOPE_TR("The state files are of different versions: the same blocks are other views."));
    for (uint64_t block = 0; block < all.blocks; ++block) {
        if (!one.done[block]) continue;
        if (all.done[block])
            throwUsage(CULLSCOPE_TR("Two of the state files tried block %1: each shard is to be merged once."),
                       {std::to_string(block)});
        all.done[block] = true;
    }
    all.views += one.views;
    all.promised += one.promised;
    all.refused += one.refused;
    all.coveredPixels += one.coveredPixels;
    all.counterexamples.insert(all.counterexamples.end(), one.counterexamples.begin(), one.counterexamples.end());
}

}  // namespace

std::string blockJson(const std::vector<BlockResult>& results) {
    Json list = Json::array();
    for (const BlockResult& one : results)
        list.push_back({{"views", one.views},
                        {"promised_views", one.promised},
                        {"refused_views", one.refused},
                        {"covered_pixels", one.coveredPixels},
                        {"counterexamples", jsonOf(one.counterexamples)}});
    return list.dump();
}

std::vector<BlockResult> blockFromJson(const std::string& text) {
    try {
        std::vector<BlockResult> results;
        for (const Json& one : Json::parse(text))
            results.push_back({one.at("views").get<uint64_t>(), one.at("promised_views").get<uint64_t>(),
                               one.at("refused_views").get<uint64_t>(), one.at("covered_pixels").get<uint64_t>(),
                               counterexamplesOf(one.at("counterexamples"))});
        return results;
    } catch (const Json::exception&) {
        throwInput(CULLSCOPE_TR("These are no results of a block of cullbench certify: %1"), {text});
    }
}

std::string certificateJson(const Certificate& certificate) { return jsonOf(certificate).dump(1) + "\n"; }

std::string certificatesJson(const std::vector<Certificate>& certificates) {
    if (certificates.size() == 1) return certificateJson(certificates.front());
    Json list = Json::array();
    for (const Certificate& certificate : certificates) list.push_back(jsonOf(certificate));
    return list.dump(1) + "\n";
}

void writeCertificates(const std::filesystem::path& file, const std::vector<Certificate>& certificates) {
    writeFileAtomically(file, [&](std::ostream& out) { out << certificatesJson(certificates); });
}

std::vector<Certificate> readCertificates(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {file.string()});
    try {
        const Json root = Json::parse(in);
        std::vector<Certificate> certificates;
        if (!root.is_array()) return {certificateOf(root, file)};
        for (const Json& one : root) certificates.push_back(certificateOf(one, file));
        if (!certificates.empty()) return certificates;
    } catch (const Json::exception&) {
        // Said below.
    }
    throwInput(
        CULLSCOPE_TR("%1 is no state of cullbench certify that can be read. Name another file, or remove it and begin anew."),
        {file.string()});
}

std::vector<Certificate> merged(const std::vector<Certificate>& certificates) {
    if (certificates.empty()) throwUsage(CULLSCOPE_TR("There is nothing to merge: name state files."));
    std::vector<Certificate> all;
    for (const Certificate& one : certificates) {
        const auto same = std::ranges::find(all, one.strategy, &Certificate::strategy);
        if (same != all.end()) {
            addTo(*same, one);
            continue;
        }
        all.push_back(one);
        all.back().shard = all.back().shards = 1;
    }
    for (Certificate& one : all)
        std::ranges::sort(one.counterexamples, {},
                          [](const Counterexample& found) { return std::pair(found.block, found.view); });
    return all;
}

std::string certificateText(const Certificate& certificate) {
    const size_t lost = certificate.counterexamples.size();
    std::string text = fmt::format("{}: {} of {} blocks of {} views, {} views tried", certificate.strategy,
                                   certificate.blocksDone(), certificate.blocksToDo(), kViewsOfABlock, certificate.views);
    if (certificate.shards > 1) text += fmt::format(", shard {} of {}", certificate.shard, certificate.shards);
    text += fmt::format("\n{} views within its promise, {} covered pixels: {} lost a pixel", certificate.promised,
                        certificate.coveredPixels, lost);
    if (lost == 0 && certificate.promised > 0)
        text += fmt::format(" (rate below 3/{} = {:.1e}, with 95 % confidence)", certificate.promised,
                            3.0 / double(certificate.promised));
    text += "\n";
    if (certificate.refused > 0) text += fmt::format("{} views of scenes that it does not serve\n", certificate.refused);
    if (certificate.promised == 0) text += "It promises nothing at these views: there is nothing to certify.\n";
    for (const Counterexample& one : certificate.counterexamples) {
        text += fmt::format("block {} view {}: {} pixels lost; shrunk to {} triangles in {} objects, {}x{}", one.block, one.view,
                            one.lostPixels, one.triangles, one.objects, one.size.width, one.size.height);
        if (!one.file.empty())
            text += fmt::format("; {}.obj and .json{}", one.file,
                                one.fileShowsIt ? "" : ", which the rounding of the file's numbers mends: see the block");
        text += "\n";
    }
    return text;
}

}  // namespace cullscope::certify
