// The dialogs of advice, of the worst view, of a paper's figures and of kept reports, with their answers, in every language.
#include <QSignalSpy>

#include "tests/ui/looks/desktop.h"
#include "tests/ui/looks/kept_picture.h"
#include "tests/ui/looks/shown_texts.h"
#include "ui/dialogs/advise_dialog.h"
#include "ui/dialogs/figures_dialog.h"
#include "ui/dialogs/reports_dialog.h"
#include "ui/dialogs/worst_dialog.h"

namespace cullscope::ui::advice_look_test {
namespace {

void expectWhole(QWidget& dialog, const QString& name) {
    QApplication::processEvents();
    EXPECT_EQ(cutTexts(dialog), QStringList()) << name.toStdString();
    keepToLookAt(dialog, name);
}

TEST(Advice, dialogsCutNoTextInAnyLanguage) {
    for (const QString& language : {QStringLiteral("en"), QStringLiteral("ko"), QStringLiteral("zh_CN")}) {
        Desktop desktop({.size = {1280, 800}, .language = language, .scene = QStringLiteral("star:seed=7,triangles=500")});
        desktop.window.actions().advise->trigger();
        desktop.window.actions().worst->trigger();
        desktop.window.actions().figures->trigger();
        auto* advise = desktop.window.findChild<AdviseDialog*>();
        auto* worst = desktop.window.findChild<WorstDialog*>();
        auto* figures = desktop.window.findChild<FiguresDialog*>();
        ASSERT_TRUE(advise && worst && figures);
        expectWhole(*advise, QStringLiteral("advise-start-") + language);
        expectWhole(*worst, QStringLiteral("worst-start-") + language);
        expectWhole(*figures, QStringLiteral("figures-") + language);
        advise->path().setCurrentText(QStringLiteral("fibonacci:2"));
        advise->size().setCurrentIndex(0);
        QSignalSpy advised(advise, &AdviseDialog::ended);
        advise->startButton().click();
        ASSERT_TRUE(advised.wait(kPatience));
        expectWhole(*advise, QStringLiteral("advise-") + language);
        worst->views().setValue(24);
        QSignalSpy found(worst, &WorstDialog::ended);
        worst->startButton().click();
        ASSERT_TRUE(found.wait(kPatience));
        expectWhole(*worst, QStringLiteral("worst-") + language);
        desktop.window.actions().reports->trigger();
        auto* reports = desktop.window.findChild<ReportsDialog*>();
        ASSERT_TRUE(reports);
        ASSERT_GE(reports->table().rowCount(), 2);
        expectWhole(*reports, QStringLiteral("reports-") + language);
    }
}

}  // namespace
}  // namespace cullscope::ui::advice_look_test
