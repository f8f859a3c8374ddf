// Names come from files and may contain markup: no label and no tool tip renders it.
#include <QLabel>
#include <QMessageBox>
#include <QToolTip>

#include "tests/ui/shown_window.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/generate_dialog.h"
#include "ui/dialogs/keys_dialog.h"

namespace cullscope::ui::plain_words_test {
namespace {

constexpr const char* kMarkup = "<h1>BIG</h1><img src=\"local-picture.png\" width=300 height=150>";

/// The only label that is composed as HTML: of the strategy's description and id, both escaped.
bool composed(const QLabel& label) { return label.textFormat() == Qt::RichText && !label.text().contains(QLatin1String("BIG")); }

void expectPlainLabels(QWidget& widget) {
    for (QLabel* label : widget.findChildren<QLabel*>()) {
        label->ensurePolished();
        EXPECT_TRUE(label->textFormat() == Qt::PlainText || composed(*label)) << label->text().toStdString();
    }
}

TEST_F(Window, everyLabelShowsPlainText) {
    session.raise(Severity::Error, Message{"%1 cannot be opened.", {kMarkup}});
    QApplication::processEvents();
    EXPECT_TRUE(window.message().isVisible());
    EXPECT_TRUE(window.message().text().contains(QLatin1String(kMarkup)));
    EXPECT_GT(window.findChildren<QLabel*>().size(), 30);
    expectPlainLabels(window);
    // The bar is as high as the line of plain text asks for: a rendered heading and picture would take hundreds of pixels.
    EXPECT_LT(window.message().height(), 80);
}

TEST_F(Window, dialogsAndMessageBoxesShowPlainText) {
    AboutDialog about(GlInfo{}, &window);
    KeysDialog keys(&window);
    GenerateDialog generate(sceneGenerators().back(), &window);
    QMessageBox box(QMessageBox::Critical, QString(), QLatin1String(kMarkup), QMessageBox::Close, &window);
    for (QWidget* dialog : {static_cast<QWidget*>(&about), static_cast<QWidget*>(&keys), static_cast<QWidget*>(&generate),
                            static_cast<QWidget*>(&box)})
        expectPlainLabels(*dialog);
}

TEST_F(Window, toolTipsShowPlainText) {
    QToolTip::showText(window.mapToGlobal(QPoint(20, 20)), QLatin1String(kMarkup), &window);
    const QLabel* tip = nullptr;
    for (const QWidget* widget : QApplication::topLevelWidgets())
        if (const auto* label = qobject_cast<const QLabel*>(widget); label && label->text() == QLatin1String(kMarkup))
            tip = label;
    ASSERT_TRUE(tip);
    EXPECT_EQ(tip->textFormat(), Qt::PlainText);
    QToolTip::hideText();
}

}  // namespace
}  // namespace cullscope::ui::plain_words_test
