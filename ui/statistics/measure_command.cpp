#include "ui/statistics/measure_command.h"

#include "core/visibility/strategy_request.h"
#include "ui/session/cullbench_command.h"

namespace cullscope::ui {

QString measureCommand(const MeasureRequest& request, const SceneOrigin& origin) {
    QStringList words = sceneWords(QStringLiteral("measure"), origin.specification, origin.modelFolders);
    QStringList strategyWords;
    for (const StrategyRequest& strategy : request.strategies) strategyWords << QString::fromStdString(strategyText(strategy));
    words << QStringLiteral("-s") << strategyWords.join(QLatin1Char(',')) << QStringLiteral("--path")
          << QString::fromStdString(request.path.name)
          << QStringLiteral("--size=") + QString::fromStdString(sizeText(request.size));
    if (request.windows != 1) words << QStringLiteral("--windows") << QString::number(request.windows);
    if (request.upload == Upload::VertexArray) words << QStringLiteral("--upload") << QStringLiteral("vertex-array");
    if (request.timing.fixedRepetitions > 0)
        words << QStringLiteral("--repeat") << QString::number(request.timing.fixedRepetitions);
    if (!request.accuracy) words << QStringLiteral("--no-accuracy");
    return shellLine(words);
}

}  // namespace cullscope::ui
