#include "ui/dialogs/keys_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace cullscope::ui {

KeysDialog::KeysDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Mouse and keys"));
    const std::vector<std::pair<QString, QString>> lines{
        {tr("Left drag"), tr("turn about the centre of rotation")},
        {tr("Wheel"), tr("zoom to the pointer")},
        {tr("Middle drag, or Shift + left drag"), tr("pan")},
        {tr("Double click"), tr("set the centre of rotation")},
        {tr("Right drag"), tr("look around")},
        {tr("W A S D, Q E"), tr("fly forward, left, back, right, down, up (Shift: faster)")},
        {tr("Ctrl + wheel"), tr("near plane")},
        {tr("Shift + wheel"), tr("field of view")},
        {tr("Right click, or the menu key"), tr("menu of the view")},
        {tr("Arrow keys"), tr("turn; with Shift: pan")},
        {tr("+ and −"), tr("zoom")},
        {tr("Home"), tr("back to the first view")},
        {tr(". (full stop)"), tr("show the whole scene")},
        {tr("Ctrl + 1, Ctrl + 2"), tr("one view, two views")},
        {tr("Tab"), tr("next view or panel")},
        {tr("Ctrl + O"), tr("open a file")},
        {tr("H"), tr("this page")},
    };
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(24);
    int row = 0;
    for (const auto& [keys, effect] : lines) {
        auto* left = new QLabel(keys, this);
        QFont bold = left->font();
        bold.setBold(true);
        left->setFont(bold);
        grid->addWidget(left, row, 0);
        grid->addWidget(new QLabel(effect, this), row, 1);
        ++row;
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addSpacing(8);
    layout->addWidget(buttons);
}

}  // namespace cullscope::ui
