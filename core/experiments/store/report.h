#pragma once

#include <cstdint>
#include <string>

namespace cullscope::store {

/// What was found by drawing and has no frames of its own to keep: a certificate, advice, a worst view, a run of the battery, or
/// the judgement of another program's sets.
struct Report {
    std::string kind;      ///< one of those below
    std::string scene;     ///< its name; empty: it is of no one scene
    std::string strategy;  ///< strategyText; empty: it is of no one strategy
    std::string command;   ///< that repeats it; empty: it was asked for in the desktop
    std::string words;     ///< what it says, in lines; empty: of a certificate that an older program put there
    std::string document;  ///< the same as JSON, as the command's result file has it
};

inline constexpr const char* kCertificate = "certificate";
inline constexpr const char* kAdvice = "advice";
inline constexpr const char* kWorstView = "worst view";
inline constexpr const char* kBattery = "battery";
inline constexpr const char* kJudgement = "judgement";

/// A report of the store.
struct StoredReport {
    int64_t number = 0;  ///< among reports; measurements have numbers of their own
    std::string added;   ///< UTC, as a measurement's start
    Report report;
};

}  // namespace cullscope::store
