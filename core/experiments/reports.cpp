#include "core/experiments/reports.h"

namespace cullscope {

store::Report reportOf(const certify::Certificate& certificate) {
    return {store::kCertificate, "", certificate.strategy, "", certificateText(certificate), certificateJson(certificate)};
}

store::Report reportOf(const advice::Advice& advice) {
    const std::string best = advice.best ? strategyText(advice.strategies[*advice.best].strategy) : "";
    return {store::kAdvice, advice.request.scene->name(), best, "", adviceText(advice), adviceJson(advice)};
}

store::Report reportOf(const worst::WorstResult& result) {
    return {store::kWorstView, result.request.scene->name(), strategyText(result.request.strategy), "", worstText(result),
            worstJson(result)};
}

store::Report reportOf(const std::vector<stability::CaseResult>& battery, const GlInfo& gl) {
    return {store::kBattery, "", "", "", batteryText(battery, battery.size() == 1), batteryJson(battery, gl)};
}

store::Report reportOf(const suite::Judgement& judgement, const suite::JudgeRequest& request, const GlInfo& gl) {
    // The strategy that draws the same sets, so that a list tells whose they are.
    const std::string recorded = "recorded:file=" + request.drawn.file;
    return {store::kJudgement,
            request.scene->name(),
            recorded,
            "",
            judgementText(judgement, request),
            judgementJson(judgement, request, gl)};
}

}  // namespace cullscope
