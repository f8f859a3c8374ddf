// Questions about a lecturer's own polygons, of which one lies in a plane that divides space.

#include <QTemporaryDir>
#include <fstream>

#include "tests/ui/shown_window.h"
#include "ui/dialogs/answer_dialog.h"
#include "ui/models/prediction_model.h"

namespace cullscope::ui::own_polygons_question_test {
namespace {

struct OwnPolygonsQuestion : Window {
    QTemporaryDir folder;
    std::vector<std::string> told;

    void SetUp() override {
        Window::SetUp();
        const QString file = folder.filePath(QStringLiteral("own.polygons"));
        std::ofstream(file.toStdString()) << "polygon Tisch 0 0 0  2 0 0  2 0 2  0 0 2\n"
                                             "polygon Boden 0 -1 0  1 -1 0  1 -1 1  0 -1 1\n"
                                             "plane E1 0 1 0 0\nplane E2 1 0 0 -3\neye 5 5 5\n";
        openAndWait(session, file);
        session.setActiveView(0);
        ParameterSet parameters(findStrategy("bsp").info.parameters);
        parameters.setFromText("plane", "given");
        session.slot(0).choose("bsp");
        session.slot(0).setParameters(parameters);
        ASSERT_TRUE(waitUntil([&] {
            return session.buffers() && !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy();
        }));
        QObject::connect(&session, &Session::messageRaised, &session,
                         [this](Severity, const Message& message) { told.push_back(message.english()); });
        window.actions().questionFirst->trigger();
        const int entry = QuestionBar::entryOf(Prediction::Question::Place, Prediction::Items::Objects);
        window.questionBar().question().setCurrentIndex(entry);
        emit window.questionBar().question().activated(entry);
        ASSERT_TRUE(waitUntil([&] { return session.questionParts() && row("E1").isValid(); }));
    }

    [[nodiscard]] QModelIndex row(const char* text) {
        QStandardItemModel& model = window.questionTree().model();
        const QModelIndexList found =
            model.match(model.index(0, 0), Qt::DisplayRole, QString::fromLatin1(text), 1, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? QModelIndex() : found.front();
    }
    void click(const char* text) { emit window.questionTree().view().clicked(row(text)); }
    /// Names a part as a click on it in a view does.
    void name(const char* part) {
        const NamedParts& parts = *session.questionParts();
        Prediction named = *session.question();
        named.toggle(uint64_t(std::ranges::find(parts.parts, part, &NamedParts::Part::name) - parts.parts.begin()));
        session.setQuestion(named);
    }

    /// The rows of the answer: item, expected, actual, right or wrong.
    [[nodiscard]] QStringList revealed() {
        window.questionBar().revealButton().click();
        EXPECT_TRUE(waitUntil([&] { return !session.question(); }));
        auto* answer = window.findChild<AnswerDialog*>();
        QStringList rows;
        for (int i = 0; i < answer->model().rowCount(); ++i) {
            QStringList cells;
            for (int column = 0; column < PredictionModel::ColumnCount; ++column)
                cells << answer->model().index(i, column).data().toString();
            rows << cells.join(QStringLiteral(" | "));
        }
        answer->close();
        return rows;
    }
};

TEST_F(OwnPolygonsQuestion, thePlaneInWhichAPolygonLiesIsAmongTheAnswers) {
    QComboBox& places = window.questionBar().place();
    EXPECT_GE(places.findText(QStringLiteral("in E1")), 0);
    EXPECT_LT(places.findText(QStringLiteral("in E2")), 0) << "nothing lies there";
    name("Tisch");
    emit places.activated(places.findText(QStringLiteral("in E1")));
    EXPECT_EQ(revealed(), QStringList{QStringLiteral("Tisch | in E1 | in E1 | ✓ right")});
}

TEST_F(OwnPolygonsQuestion, whatWasNotAnsweredIsNotRight) {
    name("Tisch");
    name("Boden");
    click("C1");
    const QStringList rows = revealed();
    ASSERT_EQ(rows.size(), 2);
    EXPECT_EQ(rows.front(), QStringLiteral("Tisch | – | in E1 | ✗ wrong"));
}

TEST_F(OwnPolygonsQuestion, aClickThatIsNoAnswerSaysWhy) {
    click("E1");
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told.back(), "First click the part, then the leaf in which it lies.");
    name("Tisch");
    click("E2");
    ASSERT_EQ(told.size(), 2u);
    EXPECT_EQ(told.back(), "E2 is no answer here: the list beside the question has all of them.");
    EXPECT_FALSE(session.question()->places.back());
    click("E1");
    EXPECT_EQ(told.size(), 2u);
    EXPECT_TRUE(session.question()->places.back());
}

}  // namespace
}  // namespace cullscope::ui::own_polygons_question_test
