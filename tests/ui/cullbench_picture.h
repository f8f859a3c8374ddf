#pragma once

#include <gtest/gtest.h>

#include <QProcess>
#include <QTemporaryDir>

#include "tests/ui/test_scene.h"
#include "ui/session/cullbench_command.h"

namespace cullscope::ui {

/// What `cullbench render` draws for a view, as pixels alone in RGB888; null, with a failure said, where it draws nothing.
inline QImage cullbenchPicture(const PictureSubject& picture) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("view.png"));
    QProcess cullbench;
    cullbench.setWorkingDirectory(folder.path());
    cullbench.start(QStringLiteral(CULLSCOPE_CULLBENCH), cullbenchArguments(picture, file));
    EXPECT_TRUE(cullbench.waitForFinished(kPatience)) << cullbench.errorString().toStdString();
    EXPECT_EQ(cullbench.exitCode(), 0) << cullbench.readAllStandardError().toStdString();
    return pixelsAlone(QImage(file), QImage::Format_RGB888);
}

}  // namespace cullscope::ui
