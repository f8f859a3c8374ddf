#include "core/experiments/self_test.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/experiments/occlusion_growth.h"
#include "core/experiments/result_file.h"
#include "core/gpu/context.h"
#include "core/visibility/registry.h"

namespace cullscope {
namespace {

// Shares of the whole time, for the progress.
constexpr double kBatteryEnds = 0.3, kCertificatesEnd = 0.5;

class Run {
public:
    Run(const SelfTestRequest& request, const Progress& progress, const std::function<void(const std::string&)>& finished)
        : m_request(request), m_progress(progress), m_finished(finished) {
        const HeadlessContext gl;
        m_test.gl = gl.info();
        m_test.graphicsCard = request.graphicsCard;
        if (request.graphicsCard) requireGraphicsCard(m_test.gl);
        // What the user names must be there; the battery takes minutes.
        if (!request.court.empty()) (void)openScene(request.court, request.experiments.sceneSource, progress.part(0.0, 0.0));
    }

    SelfTest all() {
        try {
            runBattery();
            certifyAll();
            measureGrowth();
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Interrupted) throw;
            m_test.interrupted = true;
        }
        return std::move(m_test);
    }

private:
    void runBattery() {
        const HeadlessContext gl;
        Renderer renderer;
        const std::vector<stability::StabilityCase>& cases = stability::battery();
        const Progress whole = m_progress.part(0.0, kBatteryEnds);
        for (size_t i = 0; i < cases.size(); ++i)
            m_test.battery.push_back(stability::runCase(
                {renderer, gl.info(), whole.part(double(i) / double(cases.size()), double(i + 1) / double(cases.size()))},
                cases[i]));
        say(stability::batteryText(m_test.battery, false));
    }

    void certifyAll() {
        certify::CertifyRequest request;
        request.views = m_request.certifiedViews;
        request.trier = m_request.trier;
        for (const RegisteredStrategy& known : strategies())
            if (!unavailable(known.info, m_test.gl)) request.strategies.push_back(strategyFromText(known.info.id));
        std::string text;
        for (certify::Certificate& certificate : certify::certify(request, m_progress.part(kBatteryEnds, kCertificatesEnd))) {
            m_progress.check();
            if (certificate.promised == 0) continue;
            text += certify::certificateText(certificate);
            m_test.certificates.push_back(std::move(certificate));
        }
        say(text);
    }

    void measureGrowth() {
        OcclusionGrowthSize size = m_request.graphicsCard ? sizeForGraphicsCard() : OcclusionGrowthSize();
        if (!m_request.court.empty()) size.court = m_request.court;
        const std::vector<Experiment> experiments = occlusionGrowth(size);
        const Progress whole = m_progress.part(kCertificatesEnd, 1.0);
        for (size_t i = 0; i < experiments.size(); ++i) {
            const HeadlessContext gl;
            try {
                m_test.tables.push_back(runExperiment(
                    experiments[i], m_request.experiments,
                    whole.part(double(i) / double(experiments.size()), double(i + 1) / double(experiments.size()))));
            } catch (const Error& error) {
                // A model that is not installed here costs its own table alone.
                if (error.kind() != ErrorKind::Input) throw;
                m_test.missing.push_back(error.message());
                say(error.what() + std::string("\n"));
                continue;
            }
            say(tableText(m_test.tables.back()));
            if (m_test.tables.back().interrupted) throw Error(ErrorKind::Interrupted, {});
        }
    }

    void say(const std::string& text) const {
        if (m_finished && !text.empty()) m_finished(text);
    }

    const SelfTestRequest& m_request;
    const Progress& m_progress;
    const std::function<void(const std::string&)>& m_finished;
    SelfTest m_test;
};

bool holds(const ResultTable& table) { return table.brokenPromises.empty() && !table.checkFailed(); }

}  // namespace

bool SelfTest::right() const {
    return std::ranges::all_of(battery, &stability::CaseResult::right) &&
           std::ranges::all_of(certificates, [](const auto& each) { return each.counterexamples.empty(); }) &&
           std::ranges::all_of(tables, holds);
}

void requireGraphicsCard(const GlInfo& gl) {
    if (gl.software)
        throw Error(ErrorKind::OpenGl, {CULLSCOPE_TR("This OpenGL is %1, which draws on the processor. Leave out --gpu for "
                                                     "sizes that suit it, or run this where a graphics card draws."),
                                        {gl.renderer}});
}

SelfTest selfTest(const SelfTestRequest& request, const Progress& progress,
                  const std::function<void(const std::string& text)>& finished) {
    return Run(request, progress, finished).all();
}

std::string selfTestJson(const SelfTest& test) {
    const ToolVersion tool = toolVersion();
    Json json;
    json["format"] = "cullscope-selftest";
    json["version"] = 1;
    json["tool"] = {{"name", tool.name}, {"version", tool.version}, {"commit", tool.commit}};
    json["processor"] = cpuName();
    json["opengl"] = {{"renderer", test.gl.renderer}, {"version", test.gl.version}, {"software", test.gl.software}};
    json["graphics_card"] = test.graphicsCard;
    json["complete"] = !test.interrupted;
    json["right"] = test.right();
    json["stability"] = test.battery.empty() ? Json() : Json::parse(stability::batteryJson(test.battery, test.gl));
    json["certificates"] = Json::array();
    for (const certify::Certificate& certificate : test.certificates)
        json["certificates"].push_back(Json::parse(certify::certificateJson(certificate)));
    json["experiments"] = test.tables.empty() ? Json() : Json::parse(tablesJson(test.tables));
    json["missing"] = Json::array();
    for (const Message& message : test.missing) json["missing"].push_back(message.english());
    return json.dump(1) + "\n";
}

}  // namespace cullscope
