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
        choose(QuestionBar::entryOf(question, Prediction::Items::Objects));
    }

    void choose(int entry) {
        window.questionBar().question().setCurrentIndex(entry);
        emit window.questionBar().question().activated(entry);
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

TEST_F(QuestionAboutParts, nothingIsRevealedBeforeSomethingWasPredicted) {
    QPushButton& button = window.questionBar().revealButton();
    const auto expectClosed = [&](const char* why) {
        EXPECT_FALSE(button.isEnabled()) << why;
        EXPECT_TRUE(button.toolTip().contains(QStringLiteral("Nothing was predicted"))) << why;
        emit button.clicked();
        EXPECT_TRUE(waitUntil([&] { return !session.pictures()->busy() && session.metricsSettled(); }));
        QApplication::processEvents();
        EXPECT_TRUE(session.question()) << why;
        EXPECT_EQ(window.findChild<AnswerDialog*>(), nullptr) << why;
    };
    ask(Prediction::Question::Order);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    expectClosed("nothing is named");
    click(inOrder[1], 1);
    EXPECT_TRUE(button.isEnabled());
    EXPECT_TRUE(button.toolTip().isEmpty());
    click(inOrder[1], 0);
    expectClosed("it was taken back");
    choose(QuestionBar::entryOf(Prediction::Question::Place, Prediction::Items::Objects));
    ASSERT_TRUE(waitUntil([&] { return window.questionBar().place().isVisible(); }));
    click(inOrder[0], 1);
    expectClosed("a part without a leaf");
    window.questionBar().place().setCurrentIndex(1);
    emit window.questionBar().place().activated(1);
    EXPECT_TRUE(button.isEnabled());
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
    choose("painter", "sort", "newell");
    ask(Prediction::Question::Place);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    EXPECT_TRUE(window.questionBar().place().isHidden());
    EXPECT_TRUE(window.questionBar().words().contains(QStringLiteral("no leaves")));
    ask(Prediction::Question::Vanish);
    EXPECT_FALSE(session.question() && session.question()->of == Prediction::Items::Parts);
}

TEST_F(QuestionAboutParts, partsThatWereNamedStayWhenTheEyeMoves) {
    ask(Prediction::Question::Order);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    click(inOrder[1], 1);
    const NamedPartsPointer before = session.questionParts();
    Camera camera = session.camera();
    camera.eye += Vec3(0.1, 0.0, 0.0);
    session.setCamera(camera);
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && !session.pictures()->busy(); }));
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != before; })) << "those of the new frame";
    EXPECT_EQ(session.question()->items.size(), 1u) << "a tree's parts are the same";
}

TEST_F(QuestionAboutParts, anotherStrategyAsksAboutItsOwnParts) {
    ask(Prediction::Question::Order);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    click(inOrder[1], 1);
    // The painter cuts nothing here: the question is about objects, and what was named is none of them.
    choose("painter", "sort", "newell");
    ASSERT_TRUE(waitUntil([&] { return session.question()->of == Prediction::Items::Objects; }));
    EXPECT_TRUE(session.question()->items.empty());
    EXPECT_EQ(session.questionParts(), nullptr);
    click(inOrder[1], 1);
    choose("bsp", "plane", "given");
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    EXPECT_EQ(session.question()->of, Prediction::Items::Parts);
    EXPECT_TRUE(session.question()->items.empty()) << "an object is no part";
}

/// The row of the tree with a text.
QModelIndex rowOf(QuestionTree& tree, const QString& text) {
    const QModelIndexList found =
        tree.model().match(tree.model().index(0, 0), Qt::DisplayRole, text, 1, Qt::MatchExactly | Qt::MatchRecursive);
    return found.isEmpty() ? QModelIndex() : found.front();
}

TEST_F(QuestionAboutParts, rowsOfTheTreeAnswerAsPlacesInTheViewDo) {
    ask(Prediction::Question::Place);
    QuestionTree& tree = window.questionTree();
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() && rowOf(tree, QStringLiteral("C8")).isValid(); }));
    EXPECT_TRUE(tree.isVisibleTo(&window));
    EXPECT_FALSE(window.structurePanel().isVisible()) << "its counts would answer the question";
    const std::vector<QString> planes{QStringLiteral("P1"), QStringLiteral("P2"), QStringLiteral("P3")};
    for (const QString& plane : planes) EXPECT_TRUE(rowOf(tree, plane).isValid()) << plane.toStdString();
    const auto clickRow = [&](const char* text) { emit tree.view().clicked(rowOf(tree, QString::fromLatin1(text))); };
    clickRow("C1");
    EXPECT_TRUE(session.question()->items.empty()) << "no part is named yet";
    click(inOrder[0], 1);  // B
    clickRow("C1");
    EXPECT_EQ(session.question()->places.back(), std::optional<size_t>(0));
    clickRow("P1");
    EXPECT_EQ(session.question()->places.back(), std::optional<size_t>(0)) << "a plane is no leaf";
    clickRow("C3");
    EXPECT_EQ(session.question()->places.back(), std::optional<size_t>(2));
    // In an order a row stands for what lies there.
    ask(Prediction::Question::Order);
    ask(Prediction::Question::Order);
    ASSERT_TRUE(waitUntil([&] { return session.question() && session.questionParts(); }));
    for (const char* leaf : {"C1", "C2", "C4", "C6", "C8"}) clickRow(leaf);
    AnswerDialog* answer = reveal();
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->model().score(), QStringLiteral("Right: 5 of 5"));
    answer->close();
    EXPECT_FALSE(tree.isVisible());
    EXPECT_TRUE(window.structurePanel().isVisible());
}

TEST_F(QuestionAboutParts, trianglesThatVanishAreNamedByClicksRegionsAndRows) {
    session.slot(0).choose("backface");
    ASSERT_TRUE(
        waitUntil([&] { return !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy(); }));
    ask(Prediction::Question::Vanish);
    EXPECT_EQ(session.question()->of, Prediction::Items::Objects) << "of several objects";
    choose(QuestionBar::entryOf(Prediction::Question::Vanish, Prediction::Items::Triangles));
    ASSERT_EQ(session.question()->of, Prediction::Items::Triangles);
    click(inOrder[0], 1);
    const uint64_t clicked = session.question()->items.front();
    EXPECT_EQ(session.scene()->instanceOf(clicked), 1u) << "a triangle of B";
    // All that the view shows.
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
    const Viewport size = session.viewRequest(0)->size;
    session.nameIn(0, {0, 0, size});
    ASSERT_TRUE(waitUntil([&] { return session.question()->items.size() > 1; }));
    const size_t shown = session.question()->items.size();
    EXPECT_EQ(session.question()->items.front(), clicked) << "named before";
    EXPECT_LE(shown, session.scene()->triangleCount());
    session.nameIn(0, {0, 0, size});
    ASSERT_TRUE(waitUntil([&] { return session.question()->items.empty(); })) << "again takes all of it back";
    // A strategy without boxes: the rows are the objects.
    QuestionTree& tree = window.questionTree();
    ASSERT_TRUE(waitUntil([&] { return rowOf(tree, QStringLiteral("A")).isValid(); }));
    emit tree.view().clicked(rowOf(tree, QStringLiteral("A")));
    EXPECT_EQ(session.question()->items.size(), session.scene()->meshOf(0).triangleCount());
    AnswerDialog* answer = reveal();
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->model().rowCount(), int(session.scene()->meshOf(0).triangleCount()));
    EXPECT_TRUE(cell(*answer, 0, PredictionModel::Item).contains(QStringLiteral("(A)")));
    answer->close();
}

TEST_F(QuestionAboutParts, dragWithControlNamesWhatLiesInTheRectangle) {
    session.slot(0).choose("backface");
    ASSERT_TRUE(
        waitUntil([&] { return !session.slot(0).building() && session.metricsSettled() && !session.pictures()->busy(); }));
    SceneView& view = window.views().pane(0).picture();
    const QRectF picture = view.pictureLayout().rect();
    const auto drag = [&] {
        const QPoint from = (picture.topLeft() + QPointF(2, 2)).toPoint(), to = (picture.bottomRight() - QPointF(2, 2)).toPoint();
        QTest::mousePress(&view, Qt::LeftButton, Qt::ControlModifier, from);
        for (const QPoint& at : {(from + to) / 2, to}) {
            QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::ControlModifier);
            QApplication::sendEvent(&view, &move);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::ControlModifier, to);
    };
    ask(Prediction::Question::Vanish);
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && !session.pictures()->busy(); }));
    const Camera before = session.camera();
    drag();
    ASSERT_TRUE(waitUntil([&] { return session.question()->items.size() == 3; })) << "A, B and C";
    EXPECT_EQ(session.camera().eye, before.eye) << "the camera stays";
    window.actions().questionFirst->trigger();
    drag();
    EXPECT_NE(session.camera().eye, before.eye) << "without a question it turns the camera";
}

TEST_F(QuestionAboutParts, leavesAreAskedForInAnyScene) {
    openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=3"));
    choose("octree-query", "leaf", "1");
    ask(Prediction::Question::Place);
    QuestionTree& tree = window.questionTree();
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() && tree.model().rowCount() > 1; }));
    const NamedParts parts = *session.questionParts();
    ASSERT_EQ(parts.parts.size(), 9u);
    ASSERT_EQ(parts.places.size(), 9u);
    EXPECT_EQ(window.questionBar().place().count(), 10);
    const QString object = QString::fromStdString(parts.parts[4].name);
    const QModelIndex row = rowOf(tree, object);
    ASSERT_TRUE(row.isValid());
    EXPECT_FALSE(row.parent().isValid()) << "its place in the tree would be the answer";
    emit tree.view().clicked(row);
    EXPECT_EQ(session.question()->items, std::vector<uint64_t>{4}) << "a row names an object, whether a view shows it or not";
    const auto leafRow = [&](size_t place) {
        return rowOf(tree, QStringLiteral("Node %1").arg(QString::fromStdString(parts.places[place])));
    };
    ASSERT_TRUE(leafRow(*parts.parts[4].place).isValid());
    emit tree.view().clicked(leafRow(*parts.parts[4].place));
    EXPECT_EQ(session.question()->places.back(), parts.parts[4].place);
    emit tree.view().clicked(rowOf(tree, QString::fromStdString(parts.parts[2].name)));
    emit tree.view().clicked(leafRow(*parts.parts[4].place));
    // In a question about something else objects stand where they lie again.
    AnswerDialog* answer = reveal();
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->model().score(), QStringLiteral("Right: 1 of 2"));
    answer->close();
    ask(Prediction::Question::Vanish);
    ASSERT_TRUE(waitUntil([&] { return rowOf(tree, object).isValid() && rowOf(tree, object).parent().isValid(); }));
}

TEST_F(QuestionAboutParts, tooManyLeavesAreCounted) {
    openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=10"));
    choose("octree-query", "leaf", "1");
    ask(Prediction::Question::Place);
    ASSERT_TRUE(waitUntil([&] { return session.questionParts() != nullptr; }));
    EXPECT_TRUE(window.questionBar().place().isHidden());
    EXPECT_TRUE(window.questionBar().words().contains(QStringLiteral("has 100 leaves here: more than 64")))
        << window.questionBar().words().toStdString();
}

}  // namespace
}  // namespace cullscope::ui::question_first_test
