#pragma once

#include <vector>

#include "core/experiments/advice/adviser.h"
#include "core/experiments/certify/certify.h"
#include "core/experiments/stability/battery.h"
#include "core/experiments/store/report.h"
#include "core/experiments/suite/judge.h"
#include "core/experiments/worst/worst_view.h"

namespace cullscope {

// What is found without frames to keep, as a result store has it. `command` is left to the caller.

[[nodiscard]] store::Report reportOf(const certify::Certificate& certificate);
[[nodiscard]] store::Report reportOf(const advice::Advice& advice);
[[nodiscard]] store::Report reportOf(const worst::WorstResult& result);
[[nodiscard]] store::Report reportOf(const std::vector<stability::CaseResult>& battery, const GlInfo& gl);
[[nodiscard]] store::Report reportOf(const suite::Judgement& judgement, const suite::JudgeRequest& request, const GlInfo& gl);

}  // namespace cullscope
