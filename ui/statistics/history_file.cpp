#include "ui/statistics/history_file.h"

#include <QFileInfo>
#include <QSettings>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace cullscope::ui {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "cullscope history";
constexpr std::uintmax_t kMostBytes = 4'000'000;  // fifty experiments take a tenth of that

Json jsonOf(const ResultRow& row) {
    Json json{{"name", row.name.toStdString()}, {"strategy", row.id.toStdString()}, {"baseline", row.baseline}};
    if (row.speedup) {
        json["ratio"] = row.speedup->ratio;
        if (row.speedup->hasInterval) json["ratio_ci95"] = row.speedup->ci95;
    }
    if (row.missedPpm) json["missed_ppm"] = *row.missedPpm;
    return json;
}

ResultRow rowOf(const nlohmann::json& json) {
    ResultRow row;
    row.name = QString::fromStdString(json.at("name").get<std::string>());
    row.id = QString::fromStdString(json.at("strategy").get<std::string>());
    row.baseline = json.at("baseline").get<std::string>();
    if (json.contains("ratio")) {
        RatioEstimate ratio;
        ratio.ratio = json.at("ratio").get<double>();
        ratio.hasInterval = json.contains("ratio_ci95");
        ratio.ci95 = {2.0 * ratio.ratio, 2.0 * ratio.ratio};
        if (ratio.hasInterval) ratio.ci95 = json.at("ratio_ci95").get<std::array<double, 2>>();
        row.speedup = ratio;
    }
    if (json.contains("missed_ppm")) row.missedPpm = json.at("missed_ppm").get<double>();
    return row;
}

[[noreturn]] void throwNoHistory(const std::filesystem::path& file) {
    throwInput(
        QT_TRANSLATE_NOOP("core", "%1 is no history of experiments: it is passed over, and the next experiment replaces it."),
        {file.string()});
}

}  // namespace

std::filesystem::path historyFile() {
    return (QFileInfo(QSettings().fileName()).absolutePath() + QStringLiteral("/experiments.json")).toStdString();
}

std::vector<PastExperiment> readHistory(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::exists(file, failure)) return {};
    if (!std::filesystem::is_regular_file(file, failure) || std::filesystem::file_size(file, failure) > kMostBytes)
        throwNoHistory(file);
    std::ifstream in(file, std::ios::binary);
    try {
        const nlohmann::json json = nlohmann::json::parse(in);
        if (json.at("format") != kFormat) throwNoHistory(file);
        std::vector<PastExperiment> experiments;
        for (const nlohmann::json& each : json.at("experiments")) {
            PastExperiment experiment;
            experiment.scene = QString::fromStdString(each.at("scene").get<std::string>());
            experiment.what = QString::fromStdString(each.at("what").get<std::string>());
            experiment.when =
                QDateTime::fromString(QString::fromStdString(each.at("when").get<std::string>()), Qt::ISODateWithMs);
            if (!experiment.when.isValid()) throwNoHistory(file);
            for (const nlohmann::json& row : each.at("rows")) experiment.rows.push_back(rowOf(row));
            experiments.push_back(std::move(experiment));
        }
        return experiments;
    } catch (const nlohmann::json::exception&) {
        throwNoHistory(file);
    }
}

void writeHistory(const std::filesystem::path& file, const std::vector<PastExperiment>& experiments) {
    Json json{{"format", kFormat}, {"version", 1}, {"experiments", Json::array()}};
    for (const PastExperiment& experiment : experiments) {
        Json each{{"scene", experiment.scene.toStdString()},
                  {"what", experiment.what.toStdString()},
                  {"when", experiment.when.toUTC().toString(Qt::ISODateWithMs).toStdString()},
                  {"rows", Json::array()}};
        for (const ResultRow& row : experiment.rows) each["rows"].push_back(jsonOf(row));
        json["experiments"].push_back(std::move(each));
    }
    std::error_code failure;  // where the folder cannot be made, writing says so
    std::filesystem::create_directories(file.parent_path(), failure);
    writeFileAtomically(file, [&](std::ostream& out) { out << json.dump(1) << '\n'; });
}

}  // namespace cullscope::ui
