// Stepping through the frame of a view, and questions that are asked before it is shown.

#include <QTableView>

#include "core/gpu/gpu_frame.h"
#include "core/measure/render_frame.h"
#include "tests/ui/stepped_window.h"
#include "ui/dialogs/answer_dialog.h"
#include "ui/models/metrics_words.h"
#include "ui/models/prediction_model.h"

namespace cullscope::ui::stepping_test {
namespace {

/// A field of spheres, of which some lie outside the active view's frustum.
struct Stepping : SteppedWindow {
    void SetUp() override {
        Window::SetUp();
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=80,n=4"));
        session.setActiveView(0);
        session.slot(0).choose("frustum-octree");
        Camera camera = session.camera();
        camera.eye = camera.target + 0.3 * (camera.eye - camera.target);
        session.setCamera(camera);
        settleAll();
    }
};

TEST_F(Stepping, pictureAtAStepIsTheReplayUpToIt) {
    begin();
    const size_t count = stepper().place()->count();
    ASSERT_GT(count, 10u);
    for (const size_t step : {size_t{0}, count / 3, count - 1, count}) {
        showStep(step);
        EXPECT_EQ(shown(), replay(stepper().place()->entries())) << step;
    }
    EXPECT_NE(replay(0), replay(count));
}

TEST_F(Stepping, lastStepIsTheFrameAndLeavingShowsItAgain) {
    begin();
    showStep(stepper().place()->count());
    const QImage last = session.picture(0)->colour;
    const LogPlace end = session.step()->place;
    EXPECT_EQ(end.entries, end.whole);
    window.actions().stepThrough->trigger();
    EXPECT_FALSE(session.step());
    EXPECT_TRUE(window.stepBar().isHidden());
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
    // Without the bar the view is higher again: its frame is compared where the size is the same.
    if (session.picture(0)->colour.size() == last.size()) {
        EXPECT_EQ(shown(), pixelsAlone(last));
    }
    EXPECT_FALSE(session.picture(0)->request.upTo);
}

TEST_F(Stepping, backAndJumpShowWhatForwardShowed) {
    begin();
    const size_t count = stepper().place()->count();
    showStep(count - 4);
    std::vector<QImage> forward;
    for (int i = 0; i < 4; ++i) {
        window.actions().stepOn->trigger();
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        forward.push_back(shown());
    }
    EXPECT_EQ(stepper().place()->step(), count);
    for (int i = 2; i >= 0; --i) {
        window.actions().stepBack->trigger();
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        EXPECT_EQ(shown(), forward[size_t(i)]) << i;
    }
    for (const size_t i : {3u, 0u, 2u}) {
        showStep(count - 3 + i);
        EXPECT_EQ(shown(), forward[i]) << i;
    }
}

TEST_F(Stepping, pageKeysStepOnlyWhileAViewIsStepped) {
    EXPECT_FALSE(window.actions().stepOn->isEnabled());
    begin();
    EXPECT_EQ(stepper().place()->step(), 0u);
    WindowActions& actions = window.actions();
    EXPECT_EQ(actions.stepOn->shortcut(), QKeySequence(Qt::Key_PageDown));
    EXPECT_EQ(actions.stepBack->shortcut(), QKeySequence(Qt::Key_PageUp));
    actions.stepOn->trigger();
    actions.stepOn->trigger();
    EXPECT_EQ(stepper().place()->step(), 2u);
    actions.stepBack->trigger();
    EXPECT_EQ(stepper().place()->step(), 1u);
    actions.stepLast->trigger();
    EXPECT_EQ(stepper().place()->step(), stepper().place()->count());
    actions.stepThrough->trigger();
    EXPECT_FALSE(actions.stepOn->isEnabled());
}

TEST_F(Stepping, panelsShowTheStateAtTheStep) {
    begin();
    StructurePanel& panel = window.structurePanel();
    panel.tabs().setCurrentWidget(&panel.listing());
    const FrameLog& log = session.step()->frame->log;
    const BuiltStrategy& strategy = *session.step()->frame->request.strategy;
    const size_t count = stepper().place()->count();
    for (const size_t step : {count / 2, count / 4}) {
        showStep(step);
        const ListingState expected = *strategy.listing(log.upTo(step));
        ListingModel& model = panel.listing().model();
        const auto mark = [&] { return model.index(expected.current - 1, ListingModel::Mark).data().toString(); };
        const auto total = [&] { return panel.listing().summary().contains(QString::number(expected.total())); };
        EXPECT_TRUE(waitUntil([&] { return mark() == QStringLiteral("▶") && total(); })) << step;
    }
    // The box in hand is the selected row.
    size_t step = 0;
    while (!session.step()->shape.node && step < count) showStep(++step);
    ASSERT_TRUE(session.step()->shape.node);
    EXPECT_TRUE(waitUntil([&] {
        const QModelIndexList rows = panel.tree().view().selectionModel()->selectedRows();
        return !rows.isEmpty() && panel.tree().model().index(rows.front().row(), 0, rows.front().parent()) ==
                                      panel.tree().model().indexOfGroup(*session.step()->shape.node);
    }));
    EXPECT_FALSE(session.step()->shape.boxes.empty());
    EXPECT_FALSE(window.stepBar().sentence().isEmpty());
    EXPECT_TRUE(window.views().pane(0).header().secondLine().contains(QString::number(count)));
}

TEST_F(Stepping, headerOfANarrowViewKeepsTheStepAndAllFigures) {
    begin();
    showStep(5);
    ViewHeader& header = window.views().pane(0).header();
    const QFontMetrics metrics(header.font());
    const QString whole = header.secondLine(), figures = metricsLine(session.figures(0));
    EXPECT_EQ(header.secondLine(metrics, metrics.horizontalAdvance(whole)), whole);
    const QString narrow = header.secondLine(metrics, metrics.horizontalAdvance(whole) - 1);
    EXPECT_LT(metrics.horizontalAdvance(narrow), metrics.horizontalAdvance(whole) * 9 / 10);
    EXPECT_TRUE(narrow.contains(QLatin1Char('5'))) << narrow.toStdString();
    EXPECT_TRUE(narrow.endsWith(figures)) << narrow.toStdString();
}

TEST_F(Stepping, observerShowsTheStepOfTheViewThatItWatches) {
    session.observe(1, 0);
    settleAll();
    begin();
    showStep(stepper().place()->count() / 2);
    EXPECT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(1); }));
    EXPECT_EQ(session.picture(1)->request.upTo, session.step()->place);
    EXPECT_NE(session.stepOf(1), nullptr);
}

TEST_F(Stepping, movedCameraIsSteppedAtTheSameShare) {
    begin();
    showStep(stepper().place()->count() / 2);
    const ViewFramePointer before = session.step()->frame;
    Camera camera = session.camera();
    camera.eye = camera.target + 0.8 * (camera.eye - camera.target);
    session.setCamera(camera);
    ASSERT_TRUE(waitUntil([&] { return session.step()->frame != before && session.pictures()->isCurrent(0); }));
    const double share = double(stepper().place()->entries()) / double(stepper().place()->log().entries());
    EXPECT_NEAR(share, 0.5, 0.05);
    EXPECT_EQ(shown(), replay(stepper().place()->entries()));
}

TEST_F(Stepping, playingStopsAtABreakpointAndAtTheEnd) {
    begin();
    stepper().setSpeed(Stepper::kMostSpeed);
    const EntryKind culled{EntryKind::Trait::Outcome, uint8_t(Decision::Outcome::Culled)};
    stepper().setBreakpoints({culled});
    stepper().play(true);
    ASSERT_TRUE(waitUntil([&] { return !stepper().playing(); }));
    ASSERT_LT(stepper().place()->step(), stepper().place()->count());
    EXPECT_TRUE(isOfKind(*stepper().place()->current(), {culled}));
    stepper().setBreakpoints({});
    stepper().play(true);
    ASSERT_TRUE(waitUntil([&] { return !stepper().playing(); }));
    EXPECT_EQ(stepper().place()->step(), stepper().place()->count());
}

TEST_F(Stepping, closedWindowInTheMiddleOfPlayingEndsIt) {
    begin();
    stepper().setSpeed(20.0);
    stepper().play(true);
    ASSERT_TRUE(waitUntil([&] { return stepper().place()->step() > 0; }));
    window.close();
    EXPECT_FALSE(stepper().playing());
    EXPECT_FALSE(session.step());
}

TEST_F(Stepping, anotherSceneEndsIt) {
    begin();
    openAndWait(session, QStringLiteral("torus:triangles=200"));
    EXPECT_FALSE(stepper().active());
    settleAll();
}

TEST_F(Stepping, barSaysWhereTheMethodRecordsCoarser) {
    begin();
    EXPECT_FALSE(window.stepBar().placeText().contains(QLatin1Char('('))) << "every decision of a small scene is recorded";
    session.slot(0).choose("painter");
    settleAll();
    const auto says = [&] {
        return window.stepBar().placeText().endsWith(QStringLiteral("(without depths and tests 1 and 2, above 1000 triangles)"));
    };
    EXPECT_TRUE(waitUntil(says)) << window.stepBar().placeText().toStdString();
    const QList<QLabel*> labels = window.stepBar().findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
        return label->toolTip().contains(QStringLiteral("\n• without depths and tests 1 and 2"));
    }));
}

TEST_F(Stepping, measuredFramesAreNotRecorded) {
    begin();
    showStep(3);
    const MetricsSubject subject = session.figures(0).subject;
    ASSERT_TRUE(subject.strategy);
    size_t decisions = 1;
    session.gpu()->run([&] {
        Renderer renderer;
        Framebuffer target(subject.size);
        const ViewStatePointer state = subject.strategy->begin();
        decisions =
            renderFrame(renderer, *subject.buffers, *subject.strategy, *state, View(subject.culling, subject.size), target)
                .log.decisions.size();
    });
    EXPECT_EQ(decisions, 0u);
    EXPECT_FALSE(session.step()->frame->log.decisions.empty()) << "the stepped frame is";
}

TEST_F(Stepping, openQuestionTellsNothingUntilItIsRevealed) {
    session.slot(0).choose("frustum");
    settleAll();
    ViewSetup setup = session.setup(0);
    setup.look.show("verdicts", true);
    session.setSetup(0, setup);
    settleAll();
    window.actions().questionFirst->trigger();
    ASSERT_TRUE(session.question());
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
    EXPECT_EQ(session.picture(0)->consideredTriangles, session.scene()->triangleCount()) << "all objects are shown";
    EXPECT_FALSE(session.viewRequest(0)->look.shows("verdicts"));
    EXPECT_FALSE(window.views().pane(0).header().secondLine().contains(QChar(u'×')));
    EXPECT_FALSE(window.tabs().isVisible());
    const std::optional<Pick> before = session.pick();
    session.pickAt(0, session.renderSize(0).width / 2, session.renderSize(0).height / 2);
    ASSERT_TRUE(waitUntil([&] { return session.question()->items.size() == 1; }));
    EXPECT_EQ(session.pick(), before) << "a click answers, it does not pick";
    window.questionBar().revealButton().click();
    ASSERT_TRUE(waitUntil([&] { return !session.question(); }));
    auto* answer = window.findChild<AnswerDialog*>();
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->model().rowCount(), int(session.scene()->instances().size()));
    EXPECT_TRUE(waitUntil([&] { return window.tabs().isVisible(); }));
    answer->close();
}

}  // namespace
}  // namespace cullscope::ui::stepping_test
