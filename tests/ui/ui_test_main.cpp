#include <gtest/gtest.h>

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "ui/startup/display.h"

// Tests of the desktop run in a real application: on a display with OpenGL, as the program itself needs one. Settings go to a
// folder that is thrown away.
int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    try {
        cullscope::ui::requireDisplay();
        cullscope::ui::setDefaultSurfaceFormat();
        const std::unique_ptr<QApplication> application = cullscope::ui::makeApplication(argc, argv);
        return RUN_ALL_TESTS();
    } catch (const cullscope::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
