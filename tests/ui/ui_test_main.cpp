#include <gtest/gtest.h>

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "ui/startup/display.h"

// Runs the tests of the desktop in a QApplication on a display with OpenGL, which the program requires too. Settings are written
// to a temporary folder.
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
