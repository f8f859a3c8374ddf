// What stays in sight while a question is open: no panel answers it, and the views keep their size.

#include <QRegularExpression>

#include "tests/ui/shown_window.h"
#include "ui/panels/outliner.h"

namespace cullscope::ui::question_hides_test {
namespace {

struct OpenQuestion : Window {
    void SetUp() override {
        Window::SetUp();
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=3"));
        session.setActiveView(0);
        session.slot(0).choose("frustum");
        settleAll();
    }

    void settleAll() {
        ASSERT_TRUE(waitUntil([&] {
            return session.buffers() && !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy();
        }));
        QApplication::processEvents();
    }

    void ask(int entry) {
        if (!session.question()) window.actions().questionFirst->trigger();
        window.questionBar().question().setCurrentIndex(entry);
        emit window.questionBar().question().activated(entry);
        settleAll();
    }
};

/// The texts of a widget's labels that are a number.
QStringList numbersOn(const QWidget& widget) {
    static const QRegularExpression number(QStringLiteral("^(Missed: )?[0-9][0-9.,]*( [kM])?$"));
    QStringList numbers;
    for (const QLabel* label : widget.findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(number)) numbers << label->text();
    return numbers;
}

TEST_F(OpenQuestion, lectureAsksAndTellsNoFigures) {
    window.actions().lecture->trigger();
    LectureWindow* lecture = window.lecture();
    ASSERT_TRUE(lecture);
    settleAll();
    QTest::keyClick(lecture, Qt::Key_R);
    ASSERT_TRUE(waitUntil([&] { return !numbersOn(*lecture).isEmpty(); })) << "the figures that were asked for";
    ask(QuestionBar::entryOf(Prediction::Question::Vanish, Prediction::Items::Objects));
    EXPECT_EQ(numbersOn(*lecture), QStringList());
    const auto says = [&](const QString& words) {
        return std::ranges::any_of(lecture->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->isVisible() && label->text().contains(words); });
    };
    EXPECT_TRUE(says(QStringLiteral("Which objects vanish?")));
    EXPECT_TRUE(says(window.questionBar().words()));
    window.actions().questionFirst->trigger();
    EXPECT_TRUE(waitUntil([&] { return !numbersOn(*lecture).isEmpty(); }));
    EXPECT_FALSE(says(QStringLiteral("Which objects vanish?")));
}

TEST_F(OpenQuestion, outlinerHasNoVerdicts) {
    auto* outliner = window.findChild<Outliner*>();
    ASSERT_TRUE(outliner);
    const auto verdicts = [&] {
        int known = 0;
        for (int row = 0; row < outliner->model().rowCount(); ++row)
            known += outliner->model().index(row, ObjectModel::Verdict).data(Qt::DecorationRole).isValid();
        return known;
    };
    ASSERT_TRUE(waitUntil([&] { return verdicts() == 9; }));
    ask(QuestionBar::entryOf(Prediction::Question::Vanish, Prediction::Items::Objects));
    EXPECT_EQ(verdicts(), 0);
    // A camera that moves has new figures.
    Camera camera = session.camera();
    camera.eye *= 1.1;
    session.setCamera(camera);
    settleAll();
    EXPECT_EQ(verdicts(), 0);
    window.actions().questionFirst->trigger();
    EXPECT_TRUE(waitUntil([&] { return verdicts() == 9; }));
}

TEST_F(OpenQuestion, viewsKeepTheirSizeFromQuestionToQuestion) {
    window.resize(1280, 800);
    for (const char* id : {"en", "ko", "zh_CN"}) {
        language.use(QString::fromLatin1(id));
        settleAll();
        std::vector<QSize> sizes;
        for (int entry = 0; entry < window.questionBar().question().count(); ++entry) {
            ask(entry);
            ASSERT_TRUE(waitUntil([&] { return window.questionBar().isVisible(); }));
            sizes.push_back(picture(0).size());
        }
        for (const QSize& size : sizes) EXPECT_EQ(size, sizes.front()) << id;
        window.actions().questionFirst->trigger();
    }
    language.use(QStringLiteral("en"));
}

TEST_F(OpenQuestion, stepBarHasRoomForTwoLinesInEveryLanguage) {
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return session.step().has_value(); }));
    const auto labels = window.stepBar().findChildren<QLabel*>();
    const auto sentence = std::ranges::find_if(labels, [](const QLabel* label) { return label->wordWrap(); });
    ASSERT_NE(sentence, labels.end());
    for (const QString& line : {QStringLiteral("Åg"), QStringLiteral("한글"), QStringLiteral("中文")}) {
        QLabel probe(line + QLatin1Char('\n') + line);
        probe.setFont((*sentence)->font());
        EXPECT_LE(probe.sizeHint().height(), (*sentence)->height()) << line.toStdString();
    }
}

}  // namespace
}  // namespace cullscope::ui::question_hides_test
