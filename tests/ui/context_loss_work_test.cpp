// Work in progress when a driver reset destroys the OpenGL context: uploads, screenshots, experiments; and objects that were made
// in a lost context.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "tests/support/small_experiment.h"
#include "tests/ui/context_loss.h"
#include "ui/jobs/experiment_runner.h"
#include "ui/screenshots/screenshot.h"
#include "ui/views/view_pane.h"

namespace cullscope::ui::context_loss_work_test {
namespace {

using ::testing::HasSubstr;

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
        one->setViewport(0, kLossSize);
        one->setViewport(1, kLossSize);
        openAndWait(*one, QStringLiteral("sphere:triangles=1e6"));
        settle(*one);
    }
    EXPECT_EQ(uploads, 2);
    EXPECT_EQ(seenIn(session), seenIn(other));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(said.front(), HasSubstr("uploaded again"));
    EXPECT_TRUE(session.uploadFailure().empty());
}

TEST_F(ContextLoss, aScreenshotUnderWaySaysSoAndLeavesNoFile) {
    setUp(session);
    settle(session);
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("large.png")).toStdString();
    ScreenshotOptions options;
    options.size = Viewport{4096, 4096};
    Screenshot screenshot(*session.gpu(), session.frames(),
                          planScreenshot(
                              session, options, [](int) { return PictureExtras(); }, false),
                          file);
    std::vector<std::string> failures;
    bool done = false;
    QObject::connect(&screenshot, &Screenshot::failed, [&](const Message& message) { failures.push_back(message.english()); });
    QObject::connect(&screenshot, &Screenshot::done, [&] { done = true; });
    const std::vector<size_t> drawnBefore = drawn();
    driver.reset = 2;  // after one tile was drawn
    screenshot.start();
    ASSERT_TRUE(waitUntil([&] { return !failures.empty() || done; }));
    EXPECT_FALSE(done);
    EXPECT_THAT(failures, ::testing::ElementsAre(HasSubstr("Take the picture again")));
    EXPECT_FALSE(std::filesystem::exists(file));
    waitForRedrawing(drawnBefore);
    EXPECT_EQ(said.size(), 1u);
    Screenshot again(*session.gpu(), session.frames(),
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
    GpuThread gpu(driver.options());
    ExperimentRunner runner(&gpu, std::make_shared<StructureStore>());
    std::vector<MeasureResult> results;
    std::vector<std::string> failures;
    size_t partials = 0;
    QObject::connect(&runner, &ExperimentRunner::finished, [&](const MeasureResult& result) { results.push_back(result); });
    QObject::connect(&runner, &ExperimentRunner::failed, [&](const Message& message) { failures.push_back(message.english()); });
    QObject::connect(&runner, &ExperimentRunner::partial, [&] { driver.reset = ++partials == 2 ? 1 : 0; });
    MeasureRequest request = test::smallExperiment({"frustum"});
    request.path = cameraPath("walk:5000", *request.scene);
    request.baselinesToo = true;
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
    request.path = cameraPath("walk:3", *request.scene);
    runner.start(request);
    ASSERT_TRUE(waitUntil([&] { return results.size() == 2; }));
    EXPECT_FALSE(results[1].interrupted);
    EXPECT_EQ(failures.size(), 1u);
}

/// Object names of the old context name other objects in the new one.
TEST(GpuThread, buffersOfALostContextLeaveThoseOfTheNewOne) {
    Driver driver;
    GpuThread gpu(driver.options());
    const ScenePointer scene = openScene("star:seed=7,triangles=2000").scene;
    const View view(homeCamera(*scene, UpAxis::Y, 4.0 / 3.0), kLossSize);
    const auto picture = [&](const SceneBuffersPointer& buffers) {
        std::vector<uint8_t> pixels;
        gpu.run([&] {
            EXPECT_TRUE(gpu.holds(buffers));
            Renderer renderer;
            Framebuffer target(kLossSize);
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

/// A widget's context is destroyed with its window: no part of a picture may belong to it.
TEST(ViewPane, keepsItsPictureOnTheWayToAnotherWindow) {
    Session session(sessionOptions(true));
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* pane = new ViewPane(session, 0, &window);
    pane->setFixedSize(400, 360);
    layout->addWidget(pane);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    openAndWait(session, kLossScene);
    session.setViewCount(1);
    session.setActiveView(0);
    settle(session);
    const auto shown = [&] {
        QApplication::processEvents();
        return pixelsAlone(pane->picture().grab().toImage());
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
}  // namespace cullscope::ui::context_loss_work_test
