// What is left of everything when a driver's reset takes the OpenGL context. No driver resets on demand: the tests answer for it
// when the GPU thread asks whether its context is lost, and the old context then is as gone for the thread as a lost one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <atomic>

#include "core/base/error.h"
#include "tests/core/measure/small_experiment.h"
#include "tests/ui/test_scene.h"
#include "ui/session/experiment_runner.h"
#include "ui/session/screenshot.h"
#include "ui/session/undo_recorder.h"
#include "ui/views/view_pane.h"

namespace cullscope::ui {
namespace {

using ::testing::HasSubstr;

const Viewport kSize{320, 240};
const QString kScene = QStringLiteral("field:mesh=star:seed=7,triangles=2000,n=4,spacing=2.5");

/// What a driver does to a context, and whether it then gives another one.
struct Driver {
    std::atomic<int> reset = 0;        ///< the question about the context, from 1, that is answered with its loss; 0: none
    std::atomic<bool> always = false;  ///< all of them
    std::atomic<bool> broken = false;  ///< no new context

    GpuThread::Options options() {
        return {[this] { return (reset > 0 && --reset == 0) || always; },
                [this]() -> std::unique_ptr<QOpenGLContext> {
                    if (broken) return nullptr;
                    auto context = std::make_unique<QOpenGLContext>();
                    context->setFormat(QSurfaceFormat::defaultFormat());
                    return context->create() ? std::move(context) : nullptr;
                }};
    }
};

/// What a view shows and what is known of it.
struct Seen {
    std::vector<QImage> pictures;
    std::vector<std::tuple<uint64_t, uint64_t, uint64_t, uint64_t>> counts;  ///< missed, extra, covered, considered

    bool operator==(const Seen&) const = default;
};

Seen seenIn(const Session& session) {
    Seen seen;
    for (const int view : session.shownViews()) {
        seen.pictures.push_back(session.picture(view) ? session.picture(view)->colour : QImage());
        const Figures& figures = session.figures(view);
        seen.counts.emplace_back(figures.accuracy.missedPixels, figures.accuracy.extraPixels, figures.accuracy.coveredPixels,
                                 figures.consideredTriangles);
    }
    return seen;
}

void settle(Session& session) {
    ASSERT_TRUE(waitUntil([&] {
        for (const int view : session.shownViews())
            if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
        return session.figuresSettled() && !session.pictures()->busy();
    }));
}

/// Four views: a linked pair that uploads in both ways, an observer with verdict colours, and a frozen one.
void setUp(Session& session) {
    session.setViewCount(4);
    for (int view = 0; view < 4; ++view) session.setViewport(view, kSize);
    openAndWait(session, kScene);
    session.slot(0).choose("frustum");
    session.slot(1).choose("backface");
    session.slot(3).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 1.0));
    ViewSetup arrays = session.setup(1);
    arrays.upload = Upload::VertexArray;
    session.setSetup(1, arrays);
    session.observe(2, 0);
    ViewSetup observer = session.setup(2);
    observer.look = {Colouring::Verdicts, true, true, true};
    session.setSetup(2, observer);
    session.setFrozen(3, true);
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[5] = true;
    session.setHidden(hidden);
}

struct ContextLoss : ::testing::Test {
    ContextLoss() {
        QObject::connect(&session, &Session::messageRaised, [this](Severity severity, const Message& message) {
            said.push_back(message.english());
            severities.push_back(severity);
        });
    }

    static Session::Options optionsOf(Driver& driver) {
        Session::Options options = sessionOptions(true);
        options.gpu = driver.options();
        return options;
    }
    /// The driver resets while nothing is drawn; ends when the loss is known.
    void lose() {
        const size_t before = said.size();
        driver.reset = 1;
        session.gpu()->run([] {});
        ASSERT_TRUE(waitUntil([&] { return said.size() > before; }));
    }
    /// Until every shown view was drawn anew since.
    void waitForRedrawing(const std::vector<size_t>& drawn) {
        ASSERT_TRUE(waitUntil([&] {
            for (const int view : session.shownViews())
                if (session.pictures()->drawn(view) <= drawn[size_t(view)]) return false;
            return true;
        }));
        settle(session);
    }
    [[nodiscard]] std::vector<size_t> drawn() {
        std::vector<size_t> counts;
        for (int view = 0; view < Session::kMostViews; ++view) counts.push_back(session.pictures()->drawn(view));
        return counts;
    }

    Driver driver;
    std::vector<std::string> said;
    std::vector<Severity> severities;
    Session session{optionsOf(driver)};
};

TEST_F(ContextLoss, isOneSentenceAndThenAllIsAsItWas) {
    setUp(session);
    settle(session);
    UndoRecorder undo(session);
    const Camera first = session.camera();
    session.setCamera(turned(first, UpAxis::Y, Angle::fromDegrees(10.0), {}));
    undo.settle();
    session.setPick(Pick{2, 4100, Vec3(1.0, 2.0, 3.0)});
    settle(session);
    const Seen before = seenIn(session);
    const SessionState state = captureState(session);
    const size_t references = session.meter()->referencesComputed();
    EXPECT_GT(std::get<0>(before.counts[1]) + std::get<2>(before.counts[1]), 1000u);
    for (int loss = 1; loss <= 2; ++loss) {
        const std::vector<size_t> drawnBefore = drawn();
        lose();
        EXPECT_EQ(seenIn(session), before) << "while the scene was on its way";
        waitForRedrawing(drawnBefore);
        EXPECT_EQ(seenIn(session), before) << "loss " << loss;
        EXPECT_EQ(captureState(session), state);
        EXPECT_EQ(session.pick(), (Pick{2, 4100, Vec3(1.0, 2.0, 3.0)}));
        ASSERT_EQ(said.size(), size_t(loss));
        EXPECT_EQ(severities.back(), Severity::Warning);
        EXPECT_THAT(said.back(), HasSubstr("nothing is lost"));
    }
    EXPECT_EQ(session.meter()->referencesComputed(), references) << "known figures were measured again";
    EXPECT_TRUE(undo.canUndo());
    undo.undo();
    EXPECT_EQ(session.camera(), first);
}

TEST_F(ContextLoss, afterItEverythingIsDrawnMeasuredAndPickedAsInAnotherSession) {
    setUp(session);
    settle(session);
    lose();
    Session other(sessionOptions(true));
    setUp(other);
    for (Session* one : {&session, &other}) {
        one->setCamera(turned(one->camera(), UpAxis::Y, Angle::fromDegrees(25.0), {}));
        one->slot(0).choose("all");
        settle(*one);
    }
    EXPECT_EQ(seenIn(session), seenIn(other));
    for (Session* one : {&session, &other}) one->pickAt(0, kSize.width / 2, kSize.height / 3);
    ASSERT_TRUE(waitUntil([&] { return session.pick() && other.pick(); }));
    EXPECT_EQ(session.pick(), other.pick());
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(ContextLoss, inTheMiddleOfMeasuringTheFiguresComeAllTheSame) {
    bool lost = false;
    QObject::connect(&session, &Session::figuresChanged, [&](int view) {
        const Figures& figures = session.figures(view);
        if (figures.state == Figures::State::Ready && !figures.timed && !std::exchange(lost, true)) driver.reset = 1;
    });
    setUp(session);
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    settle(session);
    Session other(sessionOptions(true));
    setUp(other);
    settle(other);
    EXPECT_EQ(seenIn(session), seenIn(other));
    for (const int view : {0, 1, 3}) EXPECT_TRUE(session.figures(view).timed) << view;
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(ContextLoss, whileAPictureIsDrawnNothingOfItIsShown) {
    setUp(session);
    settle(session);
    std::vector<QImage> shown;
    QObject::connect(&session, &Session::pictureChanged, [&](int view) {
        if (view == 0) shown.push_back(session.picture(view) ? session.picture(view)->colour : QImage());
    });
    session.setActiveView(0);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    driver.reset = 2;  // after the question whether drawing may begin
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    settle(session);
    ASSERT_FALSE(shown.empty());
    for (const QImage& picture : shown) EXPECT_EQ(picture, session.picture(0)->colour);
}

TEST_F(ContextLoss, objectsHiddenBeforeItIsKnownAreHiddenAfterIt) {
    setUp(session);
    settle(session);
    driver.reset = 1;
    session.gpu()->run([] {});
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[0] = hidden[10] = true;
    session.setHidden(hidden);  // shares buffers of a context that is gone
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    settle(session);
    Session other(sessionOptions(true));
    setUp(other);
    other.setHidden(hidden);
    settle(other);
    EXPECT_EQ(seenIn(session), seenIn(other));
    EXPECT_EQ(said.size(), 1u);
}

TEST(ContextLossWhileUploading, theSceneIsUploadedAgain) {
    Driver driver;
    Session::Options options = sessionOptions(true);
    options.gpu = driver.options();
    std::atomic<int> uploads = 0;
    options.uploader = [&](GpuThread& gpu, const ScenePointer& scene) {
        SceneBuffersPointer buffers = gpu.upload(scene);
        if (++uploads == 1) driver.reset = 1;
        return buffers;
    };
    Session session(options);
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    Session other(sessionOptions(true));
    for (Session* one : {&session, &other}) {
        one->setViewport(0, kSize);
        one->setViewport(1, kSize);
        openAndWait(*one, QStringLiteral("sphere:triangles=1e6"));
        settle(*one);
    }
    EXPECT_EQ(uploads, 2);
    EXPECT_EQ(seenIn(session), seenIn(other));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(said.front(), HasSubstr("uploaded again"));
    EXPECT_TRUE(session.uploadFailure().empty());
}

TEST_F(ContextLoss, withoutANewContextWhatIsShownStays) {
    setUp(session);
    settle(session);
    const Seen before = seenIn(session);
    driver.broken = true;
    lose();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(severities.back(), Severity::Error);
    EXPECT_THAT(said.back(), HasSubstr("no new one can be made"));
    EXPECT_EQ(seenIn(session), before);
    // Moving on neither waits for ever nor draws nonsense.
    const Camera camera = session.camera();
    session.setCamera(turned(camera, UpAxis::Y, Angle::fromDegrees(10.0), {}));
    ASSERT_TRUE(waitUntil([&] { return session.figuresSettled() && !session.pictures()->busy(); }));
    EXPECT_EQ(session.picture(0)->colour, before.pictures[0]);
    EXPECT_EQ(session.figures(0).state, Figures::State::Failed);
    EXPECT_EQ(said.size(), 1u);
    session.setCamera(camera);
    ASSERT_TRUE(waitUntil([&] { return session.figuresSettled(); }));
    // Another scene says it again, once.
    openAndWait(session, QStringLiteral("torus:triangles=2000"));
    ASSERT_TRUE(waitUntil([&] { return said.size() == 2; }));
    session.gpu()->run([] {});
    QTest::qWait(50);
    EXPECT_EQ(said.size(), 2u);
    EXPECT_EQ(said.back(), said.front());
}

TEST_F(ContextLoss, thatComesAgainAndAgainIsGivenUp) {
    setUp(session);
    settle(session);
    const Seen before = seenIn(session);
    driver.always = true;
    session.gpu()->run([] {});
    ASSERT_TRUE(waitUntil([&] { return !severities.empty() && severities.back() == Severity::Error; }));
    QTest::qWait(100);
    EXPECT_EQ(said.size(), 5u);
    EXPECT_EQ(seenIn(session), before);
}

TEST_F(ContextLoss, aScreenshotUnderWaySaysSoAndLeavesNoFile) {
    setUp(session);
    settle(session);
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("large.png")).toStdString();
    ScreenshotOptions options;
    options.size = Viewport{4096, 4096};
    Screenshot screenshot(*session.gpu(),
                          planScreenshot(
                              session, options, [](int) { return PictureExtras(); }, false),
                          file);
    std::vector<std::string> failures;
    bool done = false;
    QObject::connect(&screenshot, &Screenshot::failed, [&](const Message& message) { failures.push_back(message.english()); });
    QObject::connect(&screenshot, &Screenshot::done, [&] { done = true; });
    const std::vector<size_t> drawnBefore = drawn();
    driver.reset = 2;  // with a tile drawn
    screenshot.start();
    ASSERT_TRUE(waitUntil([&] { return !failures.empty() || done; }));
    EXPECT_FALSE(done);
    EXPECT_THAT(failures, ::testing::ElementsAre(HasSubstr("Take the picture again")));
    EXPECT_FALSE(std::filesystem::exists(file));
    waitForRedrawing(drawnBefore);
    EXPECT_EQ(said.size(), 1u);
    Screenshot again(*session.gpu(),
                     planScreenshot(
                         session, options, [](int) { return PictureExtras(); }, false),
                     file);
    QObject::connect(&again, &Screenshot::done, [&] { done = true; });
    again.start();
    ASSERT_TRUE(waitUntil([&] { return done; }));
    EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(ContextLossInAnExperiment, endsItWithWhatWasMeasured) {
    Driver driver;
    ExperimentRunner runner(nullptr, driver.options());
    std::vector<MeasureResult> results;
    std::vector<std::string> failures;
    size_t partials = 0;
    QObject::connect(&runner, &ExperimentRunner::finished, [&](const MeasureResult& result) { results.push_back(result); });
    QObject::connect(&runner, &ExperimentRunner::failed, [&](const Message& message) { failures.push_back(message.english()); });
    QObject::connect(&runner, &ExperimentRunner::partial, [&] { driver.reset = ++partials == 2 ? 1 : 0; });
    const MeasureRequest small = test::smallExperiment({"frustum"});
    ExperimentRunner::Request request;
    request.scene = small.scene;
    request.strategies = small.strategies;
    request.path = cameraPath("walk:5000", *small.scene);
    request.size = small.size;
    request.repetitions = 3;
    runner.start(request);
    ASSERT_TRUE(waitUntil([&] { return !failures.empty(); }));
    EXPECT_FALSE(runner.running());
    EXPECT_THAT(failures, ::testing::ElementsAre(HasSubstr("ended the experiment")));
    ASSERT_EQ(results.size(), 1u);
    EXPECT_TRUE(results[0].interrupted);
    ASSERT_EQ(results[0].runs.size(), 3u);
    const size_t poses = results[0].runs[0].frames.size();
    EXPECT_GT(poses, 0u);
    EXPECT_LT(poses, 5000u);
    for (const FrameMeasurement& frame : results[0].runs[0].frames) EXPECT_EQ(frame.accuracy->missedPixels, 0u);
    request.path = cameraPath("walk:3", *small.scene);
    runner.start(request);
    ASSERT_TRUE(waitUntil([&] { return results.size() == 2; }));
    EXPECT_FALSE(results[1].interrupted);
    EXPECT_EQ(failures.size(), 1u);
}

/// Numbers of the old context name other things in the new one.
TEST(GpuThread, buffersOfALostContextLeaveThoseOfTheNewOne) {
    Driver driver;
    GpuThread gpu(driver.options());
    const ScenePointer scene = openScene("star:seed=7,triangles=2000").scene;
    const View view(homeCamera(*scene, UpAxis::Y, 4.0 / 3.0), kSize);
    const auto picture = [&](const SceneBuffersPointer& buffers) {
        std::vector<uint8_t> pixels;
        gpu.run([&] {
            EXPECT_TRUE(gpu.holds(buffers));
            Renderer renderer;
            Framebuffer target(kSize);
            renderer.draw(*buffers, view, everything(*scene, Facing::TwoSided), target);
            pixels = target.readColour();
        });
        return pixels;
    };
    SceneBuffersPointer before, now;
    gpu.run([&] { before = gpu.upload(scene); });
    const std::vector<uint8_t> expected = picture(before);
    driver.reset = 1;
    gpu.run([] {});
    gpu.run([&] {
        EXPECT_FALSE(gpu.holds(before));
        EXPECT_THROW(gpu.requireHeld(before), Error);
        now = gpu.upload(scene);
    });
    before = nullptr;
    gpu.run([] {});
    EXPECT_EQ(picture(now), expected);
}

/// A window's context dies with the window: nothing of a picture may live there.
TEST(ViewPane, keepsItsPictureOnTheWayToAnotherWindow) {
    Session session(sessionOptions(true));
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* pane = new ViewPane(session, 0, &window);
    pane->setFixedSize(400, 360);
    layout->addWidget(pane);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    openAndWait(session, kScene);
    session.setViewCount(1);
    session.setActiveView(0);
    settle(session);
    const auto shown = [&] {
        QApplication::processEvents();
        return pixelsAlone(pane->picture().grabFramebuffer());
    };
    const QImage before = shown();
    const QImage picture = session.picture(0)->colour;
    EXPECT_GT(picture.width(), 100);
    for (int i = 0; i < 2; ++i) {
        layout->removeWidget(pane);
        pane->setParent(nullptr);
        pane->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(pane, kPatience));
        settle(session);
        EXPECT_EQ(shown(), before) << "floating";
        pane->setParent(&window);
        layout->addWidget(pane);
        pane->show();
        settle(session);
        EXPECT_EQ(shown(), before) << "back";
        EXPECT_EQ(session.picture(0)->colour, picture);
    }
}

}  // namespace
}  // namespace cullscope::ui
