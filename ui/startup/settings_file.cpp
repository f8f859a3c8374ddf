#include "ui/startup/settings_file.h"

#include <sys/stat.h>

#include <QCoreApplication>
#include <QStandardPaths>
#include <filesystem>

#include "core/base/error.h"

namespace cullscope::ui {

void requireReadableSettings() {
    const QString organization = QCoreApplication::organizationName(), program = QCoreApplication::applicationName();
    for (const QString& folder : QStandardPaths::standardLocations(QStandardPaths::GenericConfigLocation))
        // QSettings reads those of the program, and what they lack from those of the organization.
        for (const QString& name : {organization + QLatin1Char('/') + program, organization}) {
            const std::filesystem::path file = (folder + QLatin1Char('/') + name + QStringLiteral(".conf")).toStdString();
            struct stat known {};
            if (stat(file.c_str(), &known) != 0 || S_ISREG(known.st_mode) || S_ISDIR(known.st_mode)) continue;
            throwInput("%1, the file of the settings, is a pipe or a device. Move it away.", {file.string()});
        }
}

}  // namespace cullscope::ui
