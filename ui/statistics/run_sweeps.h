#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "core/experiments/sweeps.h"
#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

/// Runs of one strategy that differ in one parameter alone.
struct RunSweep {
    QString id;                ///< of the strategy
    std::string key;           ///< of the parameter
    std::vector<size_t> runs;  ///< in the order of its values, a strategy's own choice last
    QStringList values;        ///< of each of them, as labels have it
};

/// Every sweep with two runs or more. A run may lie on several, one of each parameter.
[[nodiscard]] std::vector<RunSweep> runSweeps(const std::vector<RunFigures>& runs);

/// A parameter's value with its unit: "180", "5°", "auto".
[[nodiscard]] QString sweptValueText(const std::string& strategy, const ParameterDeclaration& declaration,
                                     const ParameterValue& value);
/// "spherical by rows"
[[nodiscard]] QString sweepName(const QString& strategy, const std::string& key);
/// "spherical by rows: 45, 90, 180, 360"
[[nodiscard]] QString sweepWords(const ParameterSweep& sweep);

}  // namespace cullscope::ui
