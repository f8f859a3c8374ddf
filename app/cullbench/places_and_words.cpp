// Where results go, and the words of a command line.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

#include "app/cullbench/commands.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope::cullbench {
namespace {

/// Two names of one file are equal so, where it exists or not.
std::string placeOf(const std::string& path) {
    std::error_code unknown;
    const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(path, unknown), unknown);
    return unknown ? path : place.string();
}

bool isDatabase(const std::string& path) {
    constexpr std::string_view kBegin = "SQLite format 3";
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) return false;
    std::string begin(kBegin.size(), ' ');
    std::ifstream(path, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
    return begin == kBegin;
}

/// Devices, such as /dev/null, take any number of files.
bool isReplaced(const std::string& path) {
    std::error_code unknown;
    return !path.empty() && path != "-" &&
           (std::filesystem::is_regular_file(path, unknown) || !std::filesystem::exists(path, unknown));
}

}  // namespace

void checkOutputPlaces(const std::vector<std::string>& paths, const std::string& store) {
    std::vector<std::string> places;
    for (const std::string& path : paths) {
        requireWritable(path);
        if (!isReplaced(path)) continue;
        const std::string place = placeOf(path);
        const auto besideStore = [&](const char* ending) { return place == placeOf(store) + ending; };
        const bool isStore = !store.empty() && (besideStore("") || besideStore("-wal") || besideStore("-shm"));
        if (isDatabase(path) || isStore)
            throwUsage(CULLSCOPE_TR("%1 is a result store, which a result file would replace. Name another file."), {path});
        if (std::ranges::find(places, place) != places.end())
            throwUsage(CULLSCOPE_TR("%1 is named for two result files, of which the second would replace the first. Name "
                                    "another file for one of them."),
                       {path});
        places.push_back(place);
    }
}

std::string commandLine(const std::vector<std::string>& words) {
    std::string line = "cullbench";
    for (const std::string& word : words) {
        constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=:,./@%";
        if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
            line.append(" ").append(word);
            continue;
        }
        line += " '";
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += "'";
    }
    return line;
}

std::pair<uint64_t, uint64_t> shardFromText(const std::string& text) {
    uint64_t shard = 0, shards = 0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard);
    const auto second = first.ptr < end && *first.ptr == '/' ? std::from_chars(first.ptr + 1, end, shards) : first;
    constexpr uint64_t kMostShards = 100'000;
    if (second.ec != std::errc() || second.ptr != end || shard < 1 || shard > shards || shards > kMostShards)
        throwUsage(CULLSCOPE_TR("--shard %1 is not I/N with I from 1 to N, as in 3/16."), {text});
    return {shard, shards};
}

}  // namespace cullscope::cullbench
