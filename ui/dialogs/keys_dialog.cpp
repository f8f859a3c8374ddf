#include "ui/dialogs/keys_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

struct Line {
    QString keys, effect;
};

struct KeyGroup {
    QString title;
    std::vector<Line> lines;
};

QLabel* bold(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

void addSection(QGridLayout& grid, const KeyGroup& section) {
    int row = grid.rowCount();
    QLabel* title = bold(section.title);
    title->setForegroundRole(QPalette::Link);
    title->setContentsMargins(0, row > 1 ? 10 : 0, 0, 2);
    grid.addWidget(title, row++, 0, 1, 2);
    for (const Line& line : section.lines) {
        grid.addWidget(bold(line.keys), row, 0);
        grid.addWidget(new QLabel(line.effect), row++, 1);
    }
}

}  // namespace

KeysDialog::KeysDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Mouse and keys"));
    const KeyGroup mouse{tr("Mouse"),
                         {{tr("Left drag"), tr("turn about what is under the pointer, or the centre of rotation")},
                          {tr("Wheel"), tr("zoom to the pointer")},
                          {tr("Middle drag, or Shift + left drag"), tr("pan")},
                          {tr("Ctrl + left drag"), tr("in an open question: name all within the rectangle")},
                          {tr("Click"), tr("select triangle and object; on an axis' end: look from there")},
                          {tr("Double click"), tr("set the centre of rotation")},
                          {tr("Right drag"), tr("look around")},
                          {tr("Right click, or the menu key"), tr("menu of the view")},
                          {tr("Ctrl + wheel"), tr("near plane")},
                          {tr("Shift + wheel"), tr("field of view")}}};
    const KeyGroup cameras{tr("Cameras"),
                           {{tr("W A S D, Q E"), tr("fly forward, left, back, right, down, up (Shift: faster)")},
                            {tr("[ and ]"), tr("fly slower, faster; the speed follows what is ahead")},
                            {tr("Arrow keys"), tr("turn; with Shift: pan")},
                            {tr("+ and −"), tr("zoom")},
                            {QStringLiteral("5"), tr("parallel view, or perspective")},
                            {tr("Home"), tr("back to the first view")},
                            {tr(". (full stop)"), tr("show the whole scene")},
                            {tr("Alt + 1 … 4"), tr("go to a kept camera; with Shift: keep this one")},
                            {tr("Ctrl + K"), tr("add this pose to the path")},
                            {tr("Space"), tr("play the path, or pause")},
                            {tr("Alt + ← and →"), tr("one pose of the path back, on")}}};
    const KeyGroup pictures{tr("Pictures"),
                            {{QStringLiteral("F"), tr("freeze culling and fly on")},
                             {QStringLiteral("O"), tr("watch from outside, in another view")},
                             {QStringLiteral("V"), tr("colours by verdict")},
                             {QStringLiteral("T"), tr("wipe between truth and strategy")},
                             {QStringLiteral("M"), tr("missed and added pixels")},
                             {QStringLiteral("N"), tr("next loss")},
                             {QStringLiteral("L"), tr("loupe")},
                             {QStringLiteral("X"), tr("axes")}}};
    const KeyGroup window{tr("Window and files"),
                          {{tr("Ctrl + 1, 2, 4, 6, 8"), tr("number of views")},
                           {tr("Tab"), tr("next view or panel")},
                           {QStringLiteral("F5"), tr("lecture: R shows figures, P points, B blanks, Esc leaves")},
                           {tr("Page Up, Page Down"), tr("in a lesson: step back, step on")},
                           {QStringLiteral("F8"), tr("step through the frame; Page Up and Page Down step")},
                           {QStringLiteral("F9"), tr("question first: name what you expect, then reveal")},
                           {tr("Ctrl + O, Ctrl + S"), tr("open; save the session")},
                           {tr("Ctrl + Z, Ctrl + Shift + Z"), tr("undo, redo")},
                           {QStringLiteral("F12"), tr("screenshot; with Ctrl: without overlays; with Ctrl + Shift: ask")},
                           {tr("F1, H"), tr("help; this page")}}};
    auto* columns = new QHBoxLayout;
    columns->setSpacing(40);
    for (const auto& [upper, lower] : {std::pair(&mouse, &pictures), std::pair(&cameras, &window)}) {
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(24);
        grid->setVerticalSpacing(6);
        addSection(*grid, *upper);
        addSection(*grid, *lower);
        grid->setRowStretch(grid->rowCount(), 1);
        columns->addLayout(grid);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns);
    layout->addSpacing(8);
    layout->addWidget(buttons);
}

}  // namespace cullscope::ui
