// Pictures of the window are compared with stored ones. The settings of the user's computer that would change them are fixed
// before the application is made: home folder, fonts, resolution, and language of the system.
#include <gtest/gtest.h>

#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/ui/looks/kept_picture.h"
#include "ui/startup/display.h"

namespace {

// The fonts of the packages fonts-dejavu-core, which fontconfig depends on, and fonts-noto-cjk. The font cache is kept outside
// the new home folder, because filling it takes a second.
constexpr const char* kFonts = R"(<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <dir>/usr/share/fonts/truetype/dejavu</dir>
  <dir>/usr/share/fonts/opentype/noto</dir>
  <cachedir>%1</cachedir>
  <match target="font">
    <edit name="antialias" mode="assign"><bool>true</bool></edit>
    <edit name="hinting" mode="assign"><bool>true</bool></edit>
    <edit name="hintstyle" mode="assign"><const>hintslight</const></edit>
    <edit name="rgba" mode="assign"><const>none</const></edit>
  </match>
  <alias binding="strong"><family>Sans Serif</family><prefer><family>DejaVu Sans</family><family>Noto Sans CJK KR</family></prefer></alias>
  <alias binding="strong"><family>sans-serif</family><prefer><family>DejaVu Sans</family><family>Noto Sans CJK KR</family></prefer></alias>
  <alias binding="strong"><family>monospace</family><prefer><family>DejaVu Sans Mono</family><family>Noto Sans Mono CJK KR</family></prefer></alias>
</fontconfig>
)";

bool makeFresh(const QTemporaryDir& home) {
    const QString fonts = home.filePath(QStringLiteral("fonts.conf"));
    QFile file(fonts);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.write(QString::fromLatin1(kFonts).arg(cullscope::ui::writtenPicturesFolder() + QStringLiteral("/fonts")).toUtf8());
    file.close();
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
        qputenv(place, home.path().toLocal8Bit());
    for (const char* given : {"XDG_CURRENT_DESKTOP", "QT_QPA_PLATFORMTHEME", "QT_STYLE_OVERRIDE", "DBUS_SESSION_BUS_ADDRESS"})
        qunsetenv(given);
    qputenv("FONTCONFIG_FILE", fonts.toLocal8Bit());
    qputenv("QT_FONT_DPI", "96");
    qputenv("LC_ALL", "C.UTF-8");
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
    const QTemporaryDir home;
    if (!makeFresh(home)) {
        std::fprintf(stderr, "%s cannot be written to.\n", qPrintable(home.path()));
        return 1;
    }
    try {
        cullscope::ui::requireDisplay();
        cullscope::ui::setDefaultSurfaceFormat();
        QCoreApplication::setOrganizationName(QStringLiteral("cullscope"));
        QCoreApplication::setApplicationName(QStringLiteral("cullscope"));
        const std::unique_ptr<QApplication> application = cullscope::ui::makeApplication(argc, argv);
        QApplication::setCursorFlashTime(0);
        QApplication::setEffectEnabled(Qt::UI_AnimateMenu, false);
        QApplication::setEffectEnabled(Qt::UI_AnimateTooltip, false);
        return RUN_ALL_TESTS();
    } catch (const cullscope::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
