#include "ui/statistics/measure_command.h"

#include <QRegularExpression>
#include <QStringList>

#include "core/visibility/strategy_request.h"
#include "ui/session/cullbench_command.h"

namespace cullscope::ui {

namespace {

QString shellWord(const QString& word) {
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_./:=,+-]+$"));
    if (plain.match(word).hasMatch()) return word;
    return QLatin1Char('\'') + QString(word).replace(QLatin1Char('\''), QStringLiteral("'\\''")) + QLatin1Char('\'');
}

}  // namespace

QString measureCommand(const MeasureRequest& request, const SceneOrigin& origin) {
    PictureRequest picture;
    picture.scene = origin.specification;
    picture.modelFolders = origin.modelFolders;
    // The words up to the scene are those of a picture; folders are absolute, so that none of them reads "render".
    const QStringList ofPicture = cullbenchArguments(picture, {});
    const qsizetype verb = ofPicture.indexOf(QStringLiteral("render"));
    QStringList words{QStringLiteral("cullbench")};
    words << ofPicture.mid(0, verb) << QStringLiteral("measure") << ofPicture.at(verb + 1);
    QStringList strategyWords;
    for (const StrategyRequest& strategy : request.strategies) strategyWords << QString::fromStdString(strategyText(strategy));
    words << QStringLiteral("-s") << strategyWords.join(QLatin1Char(',')) << QStringLiteral("--path")
          << QString::fromStdString(request.path.name)
          << QStringLiteral("--size=%1x%2").arg(request.size.width).arg(request.size.height);
    if (request.windows != 1) words << QStringLiteral("--windows") << QString::number(request.windows);
    if (request.upload == Upload::VertexArray) words << QStringLiteral("--upload") << QStringLiteral("vertex-array");
    if (request.timing.fixedRepetitions > 0)
        words << QStringLiteral("--repeat") << QString::number(request.timing.fixedRepetitions);
    if (!request.accuracy) words << QStringLiteral("--no-accuracy");
    for (QString& word : words) word = shellWord(word);
    return words.join(QLatin1Char(' '));
}

}  // namespace cullscope::ui
