#include "ui/dialogs/about_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace cullscope::ui {

AboutDialog::AboutDialog(const GlInfo& gl, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("About Cullscope"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    const auto paragraph = [&](const QString& text) {
        auto* label = new QLabel(text, this);
        label->setWordWrap(true);
        label->setMinimumWidth(460);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        layout->addWidget(label);
        return label;
    };
    QLabel* title = paragraph(QStringLiteral("Cullscope %1").arg(QStringLiteral(CULLSCOPE_VERSION)));
    QFont large = title->font();
    large.setPixelSize(20);
    title->setFont(large);
    paragraph(tr("Shows what each culling strategy draws, how fast, and what it loses, measured against what is truly visible."));
    const QString version = QString::fromStdString(gl.version);
    const QString renderer = QString::fromStdString(gl.renderer);
    paragraph(
        tr("Qt %1\nOpenGL %2\n%3", "versions, then the OpenGL renderer").arg(QString::fromLatin1(qVersion()), version, renderer));
    paragraph(tr("Cullscope's own sources are under the MIT licence."));
    paragraph(tr("It uses Qt under the LGPL version 3, linked dynamically: you may replace Qt by a version of your own."));
    paragraph(
        tr("Also: OpenMesh and libepoxy, GLM, meshoptimizer, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, "
           "nlohmann-json and fmt, each under its own free licence."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
}

}  // namespace cullscope::ui
