// Questions about parts of objects: the order in which they are drawn, and the leaves in which they lie.

#include "tests/ui/shown_window.h"
#include "ui/dialogs/answer_dialog.h"
#include "ui/models/prediction_model.h"

namespace cullscope::ui::question_first_test {
namespace {

/// The lecture's quiz with the tree of its planes in the first view.
struct QuestionAboutParts : Window {
    void SetUp() override {
        Window::SetUp();
        openAndWait(session, QStringLiteral("quiz"));
        choose("bsp", "plane", "given");
    }

    void choose(const char* strategy, const char* key, const char* value) {
        session.setActiveView(0);
        ParameterSet parameters(findStrategy(strategy).info.parameters);
        parameters.setFromText(key, value);
        session.slot(0).choose(strategy);
        session.slot(0).setParameters(parameters);
        ASSERT_TRUE(waitUntil([&] {
            return session.buffers() && !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy();
        }));
        QApplication::processEvents();
    }

    void ask(Prediction::Question question) {
        window.actions().questionFirst->trigger();
        window.questionBar().question().setCurrentIndex(int(question));
        emit window.questionBar().question().activated(int(question));
    }

    /// Clicks a place of the scene in the first view's picture, and waits until so many items are named.
    void click(const Vec3& place, size_t named) {
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        const ViewRequest request = *session.viewRequest(0);
        const View view(request.viewing, request.size);
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(place - view.eye(), 1.0);
        session.pickAt(0, int((clip.x / clip.w * 0.5 + 0.5) * request.size.width),
                       int((clip.y / clip.w * 0.5 + 0.5) * request.size.height));
        ASSERT_TRUE(waitUntil([&] { return session.question()->items.size() == named; }));
    }

    [[nodiscard]] AnswerDialog* reveal() {
        window.questionBar().revealButton().click();
        EXPECT_TRUE(waitUntil([&] { return !session.question(); }));
        return window.findChild<AnswerDialog*>();
    }

    static QString cell(AnswerDialog& answer, int row, int column) { return answer.model().index(row, column).data().toString(); }

    // Places of B, A2, A1, C2 and C1 that the camera sees.
    const std::vector<Vec3> inOrder{{-2.5, -0.5, -2.5}, {-1, 1.3, -0.8}, {-1, 1.3, 0.9}, {1, 0.8, -0.9}, {1, 0.5, 0.9}};
};

TEST_F(QuestionAboutParts, stepsDoNotAnswerAnOpenQuestion) {
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return session.step().has_value(); }));
    ask(Prediction::Question::Order);
    EXPECT_FALSE(session.step());
    EXPECT_FALSE(window.actions().stepThrough->isChecked());
    EXPECT_FALSE(window.actions().stepThrough->isEnabled());
    window.actions().questionFirst->trigger();
    EXPECT_TRUE(window.actions().stepThrough->isEnabled());
}

TEST_F(QuestionAboutParts, orderIsThatOfTheKeyWithTheParts) {
    ask(Prediction::Question::Order);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    EXPECT_EQ(session.question()->of, Prediction::Items::Parts);
    EXPECT_TRUE(window.questionBar().place().isHidden());
    for (size_t i = 0; i < inOrder.size(); ++i) click(inOrder[i], i + 1);
    AnswerDialog* answer = reveal();
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->model().score(), QStringLiteral("Right: 5 of 5"));
    QStringList inAnswer;
    for (int row = 0; row < 5; ++row) {
        inAnswer << cell(*answer, row, PredictionModel::Item);
        EXPECT_EQ(cell(*answer, row, PredictionModel::Actual), QString::number(row + 1));
    }
    EXPECT_EQ(inAnswer.join(QStringLiteral(", ")), QStringLiteral("B, A2, A1, C2, C1")) << "read like the key";
    EXPECT_EQ(answer->model().headerData(0, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("Part"));
    answer->close();
}

TEST_F(QuestionAboutParts, leafIsNamedForEachPart) {
    ask(Prediction::Question::Place);
    QComboBox& leaves = window.questionBar().place();
    ASSERT_TRUE(waitUntil([&] { return leaves.isVisible(); }));
    EXPECT_EQ(leaves.count(), 9) << "C1 to C8, and none";
    EXPECT_FALSE(leaves.isEnabled()) << "nothing is named yet";
    click(inOrder[0], 1);  // B
    ASSERT_TRUE(leaves.isEnabled());
    const auto say = [&](int leaf) {
        leaves.setCurrentIndex(leaf);
        emit leaves.activated(leaf);
    };
    say(1);
    EXPECT_EQ(session.question()->places.back(), std::optional<size_t>(0));
    click(inOrder[4], 2);  // C1
    EXPECT_EQ(leaves.currentIndex(), 0) << "the next part has no leaf yet";
    say(7);
    AnswerDialog* answer = reveal();
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->model().rowCount(), 2);
    EXPECT_EQ(answer->model().score(), QStringLiteral("Right: 1 of 2"));
    EXPECT_EQ(cell(*answer, 0, PredictionModel::Item), QStringLiteral("B"));
    EXPECT_EQ(cell(*answer, 0, PredictionModel::Actual), QStringLiteral("C1"));
    EXPECT_EQ(cell(*answer, 1, PredictionModel::Item), QStringLiteral("C1"));
    EXPECT_EQ(cell(*answer, 1, PredictionModel::Expected), QStringLiteral("C7"));
    EXPECT_EQ(cell(*answer, 1, PredictionModel::Actual), QStringLiteral("C8"));
    answer->close();
}

TEST_F(QuestionAboutParts, strategyWithoutLeavesSaysSo) {
    choose("bsp", "plane", "balance");
    ask(Prediction::Question::Place);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    EXPECT_TRUE(window.questionBar().place().isHidden());
    EXPECT_TRUE(window.questionBar().words().contains(QStringLiteral("no leaves")));
    ask(Prediction::Question::Vanish);
    EXPECT_FALSE(session.question() && session.question()->of == Prediction::Items::Parts);
}

TEST_F(QuestionAboutParts, anotherStrategyAsksAboutItsOwnParts) {
    ask(Prediction::Question::Order);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    click(inOrder[1], 1);
    Camera camera = session.camera();
    camera.eye += Vec3(0.1, 0.0, 0.0);
    session.setCamera(camera);
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && !session.pictures()->busy(); }));
    EXPECT_EQ(session.question()->items.size(), 1u) << "the parts of a tree stay when the eye moves";
}

}  // namespace
}  // namespace cullscope::ui::question_first_test
