#include "ui/statistics/run_sweeps.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>

namespace cullscope::ui {

namespace {

class SweepWords {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::SweepWords)
};

/// Whether that value leaves the choice to the strategy.
bool automatic(const std::string& strategy, const std::string& key, const std::string& value) {
    return std::any_of(builtInSweeps().begin(), builtInSweeps().end(), [&](const ParameterSweep& sweep) {
        return sweep.strategy == strategy && sweep.key == key && !sweep.automatic.empty() && sweep.automatic == value;
    });
}

/// All that two runs of a sweep have in common.
std::string othersThan(const std::string& key, const ParameterSet& parameters) {
    std::string text;
    for (const ParameterDeclaration& declaration : parameters.declarations())
        if (declaration.key != key) text += declaration.key + '=' + toText(parameters.value(declaration.key)) + '\n';
    return text;
}

RunSweep sweepOf(const std::vector<RunFigures>& runs, const ParameterDeclaration& declaration, std::vector<size_t> members) {
    const std::string id = runs[members.front()].id.toStdString();
    const auto value = [&](size_t run) { return runs[run].parameters.value(declaration.key); };
    const auto rank = [&](size_t run) { return std::pair(automatic(id, declaration.key, toText(value(run))), value(run)); };
    std::stable_sort(members.begin(), members.end(), [&](size_t a, size_t b) { return rank(a) < rank(b); });
    RunSweep sweep{runs[members.front()].id, declaration.key, std::move(members), {}};
    for (const size_t run : sweep.runs) sweep.values << sweptValueText(id, declaration, value(run));
    return sweep;
}

}  // namespace

std::vector<RunSweep> runSweeps(const std::vector<RunFigures>& runs) {
    std::vector<RunSweep> found;
    for (size_t first = 0; first < runs.size(); ++first)
        for (const ParameterDeclaration& declaration : runs[first].parameters.declarations()) {
            const std::string common = othersThan(declaration.key, runs[first].parameters);
            std::vector<size_t> members;
            for (size_t run = 0; run < runs.size(); ++run)
                if (runs[run].id == runs[first].id && othersThan(declaration.key, runs[run].parameters) == common)
                    members.push_back(run);
            if (members.size() > 1 && members.front() == first) found.push_back(sweepOf(runs, declaration, members));
        }
    return found;
}

QString sweptValueText(const std::string& strategy, const ParameterDeclaration& declaration, const ParameterValue& value) {
    const std::string text = toText(value);
    if (automatic(strategy, declaration.key, text)) return SweepWords::tr("auto", "a parameter's value that a strategy chooses");
    const QString unit = QString::fromStdString(declaration.unit);
    const QString between = unit.isEmpty() || unit == QStringLiteral("°") ? QString() : QStringLiteral(" ");
    return QString::fromStdString(text) + between + unit;
}

QString sweepName(const QString& strategy, const std::string& key) {
    //: A strategy and the parameter that is varied, as in "spherical by rows".
    return SweepWords::tr("%1 by %2").arg(strategy, QString::fromStdString(key));
}

QString sweepWords(const ParameterSweep& sweep) {
    ParameterSet parameters(findStrategy(sweep.strategy).info.parameters);
    QStringList values;
    for (const ParameterDeclaration& declaration : parameters.declarations())
        for (size_t i = 0; declaration.key == sweep.key && i < sweep.values.size(); ++i) {
            parameters.setFromText(sweep.key, sweep.values[i]);
            values << sweptValueText(sweep.strategy, declaration, parameters.value(sweep.key));
        }
    return SweepWords::tr("%1: %2", "what is varied, its values")
        .arg(sweepName(QString::fromStdString(sweep.strategy), sweep.key), values.join(QStringLiteral(", ")));
}

}  // namespace cullscope::ui
