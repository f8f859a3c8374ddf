#pragma once

#include <gtest/gtest.h>

#include <QProcess>
#include <QTemporaryDir>

#include "tests/ui/test_scene.h"
#include "ui/session/cullbench_command.h"

namespace cullscope::ui {

/// The picture that `cullbench render` draws for a view, as pixels in RGB888. Null if it draws none, which also fails the test.
inline QImage cullbenchPicture(const PictureRequest& request) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("view.png"));
    QProcess cullbench;
    cullbench.setWorkingDirectory(folder.path());
    cullbench.start(QStringLiteral(CULLSCOPE_CULLBENCH), cullbenchArguments(request, file));
    EXPECT_TRUE(cullbench.waitForFinished(kPatience)) << cullbench.errorString().toStdString();
    EXPECT_EQ(cullbench.exitCode(), 0) << cullbench.readAllStandardError().toStdString();
    return pixelsAlone(QImage(file), QImage::Format_RGB888);
}

}  // namespace cullscope::ui
