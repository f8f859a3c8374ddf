#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include "core/image/picture_metadata.h"
#include "core/scene/camera_path.h"
#include "tests/ui/test_scene.h"

namespace cullscope::ui {

/// What `cullbench measure` says of a strategy at one camera.
inline QJsonObject measuredByCullbench(const PictureSubject& picture, const QString& strategies) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("path.json")), json = folder.filePath(QStringLiteral("out.json"));
    writeCameraPath(path.toStdString(), {"pose",
                                         picture.culling.fovy,
                                         picture.culling.nearDistance,
                                         picture.culling.farDistance,
                                         picture.culling.projection,
                                         picture.culling.height,
                                         {{picture.culling.eye, picture.culling.target, picture.culling.up}}});
    QProcess cullbench;
    cullbench.start(QStringLiteral(CULLSCOPE_CULLBENCH),
                    {QStringLiteral("measure"), QString::fromStdString(picture.scene), QStringLiteral("-s"), strategies,
                     QStringLiteral("--path"), path, QStringLiteral("--size"),
                     QStringLiteral("%1x%2").arg(picture.size.width).arg(picture.size.height), QStringLiteral("--repeat"),
                     QStringLiteral("1"), QStringLiteral("--json"), json});
    EXPECT_TRUE(cullbench.waitForFinished(kPatience));
    QFile file(json);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << cullbench.readAllStandardError().toStdString();
    return QJsonDocument::fromJson(file.readAll()).object();
}

/// The first frame of a strategy in such a result; empty: it has none.
inline QJsonObject firstFrameOf(const QJsonObject& result, const char* strategy) {
    for (const auto& run : result[QStringLiteral("runs")].toArray())
        if (run.toObject()[QStringLiteral("strategy")].toString() == QLatin1String(strategy))
            return run.toObject()[QStringLiteral("frames")].toArray().at(0).toObject();
    return {};
}

}  // namespace cullscope::ui
