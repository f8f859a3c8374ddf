#include "ui/statistics/run_fronts.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>

namespace cullscope::ui {

namespace {

class FrontWords {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::FrontWords)
};

/// Whether that value leaves the choice to the strategy.
bool automatic(const std::string& strategy, const std::string& key, const std::string& value) {
    return std::any_of(fronts().begin(), fronts().end(), [&](const ParameterSweep& front) {
        return front.strategy == strategy && front.key == key && !front.automatic.empty() && front.automatic == value;
    });
}

/// All that two runs of a front have in common.
std::string othersThan(const std::string& key, const ParameterSet& parameters) {
    std::string text;
    for (const ParameterDeclaration& declaration : parameters.declarations())
        if (declaration.key != key) text += declaration.key + '=' + toText(parameters.value(declaration.key)) + '\n';
    return text;
}

RunFront frontOf(const std::vector<RunFigures>& runs, const ParameterDeclaration& declaration, std::vector<size_t> members) {
    const std::string id = runs[members.front()].id.toStdString();
    const auto value = [&](size_t run) { return runs[run].parameters.value(declaration.key); };
    const auto rank = [&](size_t run) { return std::pair(automatic(id, declaration.key, toText(value(run))), value(run)); };
    std::stable_sort(members.begin(), members.end(), [&](size_t a, size_t b) { return rank(a) < rank(b); });
    RunFront front{runs[members.front()].id, declaration.key, std::move(members), {}};
    for (const size_t run : front.runs) front.values << sweptValueText(id, declaration, value(run));
    return front;
}

}  // namespace

std::vector<RunFront> runFronts(const std::vector<RunFigures>& runs) {
    std::vector<RunFront> found;
    for (size_t first = 0; first < runs.size(); ++first)
        for (const ParameterDeclaration& declaration : runs[first].parameters.declarations()) {
            const std::string common = othersThan(declaration.key, runs[first].parameters);
            std::vector<size_t> members;
            for (size_t run = 0; run < runs.size(); ++run)
                if (runs[run].id == runs[first].id && othersThan(declaration.key, runs[run].parameters) == common)
                    members.push_back(run);
            if (members.size() > 1 && members.front() == first) found.push_back(frontOf(runs, declaration, members));
        }
    return found;
}

QString sweptValueText(const std::string& strategy, const ParameterDeclaration& declaration, const ParameterValue& value) {
    const std::string text = toText(value);
    if (automatic(strategy, declaration.key, text)) return FrontWords::tr("auto", "a parameter's value that a strategy chooses");
    const QString unit = QString::fromStdString(declaration.unit);
    const QString between = unit.isEmpty() || unit == QStringLiteral("°") ? QString() : QStringLiteral(" ");
    return QString::fromStdString(text) + between + unit;
}

QString frontName(const QString& strategy, const std::string& key) {
    //: A strategy and the parameter that is varied, as in "spherical by rows".
    return FrontWords::tr("%1 by %2").arg(strategy, QString::fromStdString(key));
}

QString frontWords(const ParameterSweep& front) {
    ParameterSet parameters(findStrategy(front.strategy).info.parameters);
    QStringList values;
    for (const ParameterDeclaration& declaration : parameters.declarations())
        for (size_t i = 0; declaration.key == front.key && i < front.values.size(); ++i) {
            parameters.setFromText(front.key, front.values[i]);
            values << sweptValueText(front.strategy, declaration, parameters.value(front.key));
        }
    return FrontWords::tr("%1: %2", "what is varied, its values")
        .arg(frontName(QString::fromStdString(front.strategy), front.key), values.join(QStringLiteral(", ")));
}

}  // namespace cullscope::ui
