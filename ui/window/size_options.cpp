#include "ui/window/size_options.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <array>

#include "core/image/picture_metadata.h"
#include "core/scene/viewport_text.h"
#include "ui/dialogs/size_dialog.h"
#include "ui/jobs/view_setup.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr std::array kUsualSizes{Viewport{320, 240}, kUsualPictureSize, Viewport{1280, 720}};
constexpr const char* kWindow = "window";

QString words(const char* english) { return QCoreApplication::translate("ViewMenu", english); }

}  // namespace

void addSizeOptions(QMenu& menu, const std::optional<Viewport>& size, const Viewport& shown,
                    std::function<void(const std::optional<Viewport>&)> choose) {
    auto* one = new QActionGroup(&menu);
    const auto add = [&](const QString& text, bool chosen) {
        QAction* action = menu.addAction(text);
        action->setCheckable(true);
        action->setChecked(chosen);
        one->addAction(action);
        return action;
    };
    bool usual = !size;
    for (const Viewport& each : kUsualSizes) {
        usual = usual || size == each;
        QObject::connect(add(pixelText(each), size == each), &QAction::triggered, &menu, [choose, each] { choose(each); });
    }
    const QString other = usual ? words(QT_TRANSLATE_NOOP("ViewMenu", "Other…"))
                                : words(QT_TRANSLATE_NOOP("ViewMenu", "Other (%1)…")).arg(pixelText(*size));
    QObject::connect(add(other, !usual), &QAction::triggered, &menu, [choose, shown, parent = menu.parentWidget()] {
        SizeDialog dialog(shown, parent);
        if (dialog.exec() == QDialog::Accepted) choose(dialog.size());
    });
    QObject::connect(add(words(QT_TRANSLATE_NOOP("ViewMenu", "Fits the window")), !size), &QAction::triggered, &menu,
                     [choose] { choose(std::nullopt); });
}

QString pictureSizeText(const std::optional<Viewport>& size) {
    return size ? QString::fromStdString(sizeText(*size)) : QLatin1String(kWindow);
}

std::optional<std::optional<Viewport>> pictureSizeFromText(const QString& text) {
    if (text == QLatin1String(kWindow)) return std::optional<Viewport>();
    if (const std::optional<Viewport> size = viewportFromText(text.toStdString())) return std::optional(size);
    return std::nullopt;
}

}  // namespace cullscope::ui
