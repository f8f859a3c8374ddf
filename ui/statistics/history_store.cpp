#include "ui/statistics/history_store.h"

#include <QFileInfo>
#include <QSettings>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

namespace {

constexpr const char* kFormat = "cullscope history";
constexpr std::uintmax_t kMostBytes = 4'000'000;  // fifty experiments took a tenth of that

store::KeptFigures figuresFrom(const nlohmann::json& json) {
    // Its name is the strategy with the parameters that are not at their defaults, as a store has them after colons.
    const QString name = QString::fromStdString(json.at("name").get<std::string>());
    return store::keptFigures(QString(name).replace(QLatin1Char(' '), QLatin1Char(':')).toStdString(), json.dump());
}

[[noreturn]] void throwNoHistory(const std::filesystem::path& file) {
    throwInput(QT_TRANSLATE_NOOP("core", "%1 is no history of experiments: it is passed over."), {file.string()});
}

/// Path and size as a history had them in one text, "tour:16 · 640 × 480".
void splitPathAndSize(const QString& text, store::OldExperiment& experiment) {
    const QStringList parts = text.split(QStringLiteral(" · "));
    experiment.path = parts.front().toStdString();
    const QStringList sides = parts.size() > 1 ? parts.back().split(QStringLiteral(" × ")) : QStringList();
    if (sides.size() == 2) experiment.size = {sides[0].toInt(), sides[1].toInt()};
}

store::OldExperiment experimentFrom(const nlohmann::json& json, const std::filesystem::path& file) {
    store::OldExperiment experiment;
    const QDateTime when = QDateTime::fromString(QString::fromStdString(json.at("when").get<std::string>()), Qt::ISODateWithMs);
    if (!when.isValid()) throwNoHistory(file);
    experiment.started = when.toUTC().toString(Qt::ISODateWithMs).toStdString();
    experiment.scene = json.at("scene").get<std::string>();
    splitPathAndSize(QString::fromStdString(json.at("what").get<std::string>()), experiment);
    for (const nlohmann::json& row : json.at("rows")) experiment.rows.push_back(figuresFrom(row));
    return experiment;
}

ResultRow rowOf(const store::KeptFigures& figures) {
    ResultRow row;
    row.name = QString::fromStdString(figures.strategy).replace(QLatin1Char(':'), QLatin1Char(' '));
    row.id = row.name.section(QLatin1Char(' '), 0, 0);
    row.baseline = figures.baseline;
    row.speedup = figures.ratio;
    row.missedPpm = figures.missedPpm;
    return row;
}

}  // namespace

std::filesystem::path historyStore() {
    return (QFileInfo(QSettings().fileName()).absolutePath() + QStringLiteral("/experiments.store")).toStdString();
}

void keepReport(Session& session, const store::Report& report) {
    try {
        (void)store::ResultStore(historyStore()).add(report);
    } catch (const Error& failure) {
        session.raise(Severity::Warning, failure.message());
    }
}

void takeOldHistory(const std::filesystem::path& json, const store::ResultStore& into) {
    std::error_code failure;
    if (!std::filesystem::exists(json, failure)) return;
    if (!std::filesystem::is_regular_file(json, failure) || std::filesystem::file_size(json, failure) > kMostBytes)
        throwNoHistory(json);
    std::ifstream in(json, std::ios::binary);
    std::vector<store::OldExperiment> experiments;
    try {
        const nlohmann::json history = nlohmann::json::parse(in);
        if (history.at("format") != kFormat) throwNoHistory(json);
        for (const nlohmann::json& each : history.at("experiments")) experiments.push_back(experimentFrom(each, json));
    } catch (const nlohmann::json::exception&) {
        throwNoHistory(json);
    }
    into.addOld(experiments);
    std::filesystem::remove(json, failure);
}

std::vector<PastExperiment> pastExperiments(const store::ResultStore& from, size_t most) {
    std::vector<store::Listed> listed = from.list();
    if (listed.size() > most) listed.erase(listed.begin(), listed.end() - std::ptrdiff_t(most));
    std::vector<PastExperiment> experiments;
    for (const store::Listed& each : listed) {
        PastExperiment experiment;
        experiment.number = each.number;
        experiment.scene = QString::fromStdString(each.scene);
        experiment.what = pathAndSize(each.path, each.size);
        experiment.when = QDateTime::fromString(QString::fromStdString(each.started), Qt::ISODateWithMs);
        for (const store::KeptFigures& figures : from.figures(each.number)) experiment.rows.push_back(rowOf(figures));
        experiments.push_back(std::move(experiment));
    }
    return experiments;
}

}  // namespace cullscope::ui
