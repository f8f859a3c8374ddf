#include "ui/session/session.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/visibility/registry.h"
#include "tests/ui/test_scene.h"
#include "ui/jobs/background.h"

namespace cullscope::ui::session_test {
namespace {

/// Loads "slow" until it is told to stop, refuses "bad", and leaves the rest to core.
OpenedScene slowOrBad(const std::string& specification, const Progress& progress) {
    if (specification == "bad") throwInput("%1 is bad.", {"bad"});
    while (specification == "slow") {
        progress.tell(0.5, "Reading the file");
        progress.check();
        std::this_thread::yield();
    }
    return openScene(specification, {}, progress);
}

TEST(Session, failedAndCancelledLoadingLeavesTheSceneAsItWas) {
    Session::Options options = sessionOptions(false);
    options.opener = slowOrBad;
    Session session(options);
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    const OpenedScenePointer before = session.opened();
    ASSERT_TRUE(before);
    const Camera camera = session.camera();

    openAndWait(session, QStringLiteral("bad"));
    EXPECT_EQ(session.opened(), before);
    session.open(QStringLiteral("slow"));
    EXPECT_TRUE(session.loader().loading());
    session.loader().cancel();
    EXPECT_FALSE(session.loader().loading());
    EXPECT_EQ(session.opened(), before);
    EXPECT_EQ(session.camera(), camera);
    EXPECT_EQ(said, (std::vector<std::string>{"bad is bad.", "Opening slow was cancelled."}));
}

TEST(Session, strategiesAreBuiltForShownViewsAlone) {
    Session session{sessionOptions(false)};
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    const auto built = [&](int view) {
        return session.slot(view).built() && session.slot(view).built()->id() == session.slot(view).id();
    };
    const auto areBuilt = [&](int first, int last) {
        for (int view = first; view <= last; ++view)
            if (!waitUntil([&] { return built(view); })) return false;
        return true;
    };
    ASSERT_TRUE(areBuilt(0, 1));
    QTest::qWait(50);
    for (int view = 2; view < Session::kMostViews; ++view)
        EXPECT_FALSE(session.slot(view).built() || session.slot(view).building()) << "view " << view << " is not shown";
    session.slot(3).choose("bsp");
    EXPECT_FALSE(session.slot(3).building());
    session.setViewCount(4);
    ASSERT_TRUE(areBuilt(0, 3));
    EXPECT_EQ(session.slot(3).built()->id(), "bsp");
    EXPECT_FALSE(session.slot(4).built());
    // A view that watches a hidden one needs what that one culls with; so does one that is compared with it.
    session.observe(0, 5);
    ASSERT_TRUE(areBuilt(5, 5));
    ViewSetup setup = session.setup(1);
    setup.wipe = {Wipe::Mode::OtherView, 6, 0.5};
    session.setSetup(1, setup);
    ASSERT_TRUE(areBuilt(6, 6));
    EXPECT_FALSE(session.slot(7).built());
    // What was built once stays, and is not built again.
    const size_t before = session.structures()->built();
    session.setViewCount(1);
    session.setViewCount(4);
    QTest::qWait(20);
    EXPECT_EQ(session.structures()->built(), before);
}

TEST(Session, tooManyNestedGeneratorsAreRefusedLikeAnyScene) {
    Session session{sessionOptions(false)};
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    const OpenedScenePointer before = session.opened();
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    openAndWait(session, QStringLiteral("mesh:").repeated(100) + QStringLiteral("sphere:triangles=80"));
    EXPECT_EQ(session.opened(), before);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("More than 64 generators"), std::string::npos) << said[0];
}

TEST(Session, aNewerOpenTakesThePlaceOfAnOlderOne) {
    Session::Options options = sessionOptions(false);
    options.opener = slowOrBad;
    Session session(options);
    int scenes = 0;
    QObject::connect(&session, &Session::sceneChanged, [&] { ++scenes; });
    session.open(QStringLiteral("slow"));
    session.open(QStringLiteral("sphere:triangles=320"));
    ASSERT_TRUE(waitUntil([&] { return !session.loader().loading(); }));
    ASSERT_TRUE(session.opened());
    EXPECT_EQ(session.opened()->specification, "sphere:triangles=320");
    EXPECT_EQ(scenes, 1);
}

TEST(Session, openingKeepsStrategiesAndLayout) {
    Session session(sessionOptions(false));
    session.slot(0).choose("all");
    session.setViewCount(1);
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    openAndWait(session, QStringLiteral("torus:triangles=400"));
    EXPECT_EQ(session.slot(0).id(), "all");
    EXPECT_EQ(session.viewCount(), 1);
}

TEST(Session, manyQuickChangesOfAParameterEndWithTheLast) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    StrategySlot& slot = session.slot(1);
    slot.choose("frustum");
    ParameterSet parameters = slot.parameters();
    for (int i = 0; i < 101; ++i) {
        parameters.setFromText("box", i % 2 == 0 ? "length" : "p-vertex");
        slot.setParameters(parameters);
    }
    ASSERT_TRUE(waitUntil([&] { return slot.built() && !slot.building(); }));
    EXPECT_EQ(slot.built()->parameters(), parameters);
    EXPECT_EQ(slot.parameters().choice("box"), "length");
}

TEST(Session, homeFollowsTheUpAxis) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    session.setUpAxis(UpAxis::Z);
    EXPECT_EQ(session.camera().up, Vec3(0, 0, 1));
    session.setUpAxis(UpAxis::Y);
    EXPECT_EQ(session.camera().up, Vec3(0, 1, 0));
}

TEST(Session, aSceneThatSaysWhatIsUpOpensStandingAndLeavesTheChoiceForOthers) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("plant:pipelines=1"));
    EXPECT_EQ(session.upAxis(), UpAxis::Z);
    EXPECT_EQ(session.camera().up, Vec3(0, 0, 1));
    EXPECT_GT(session.camera().eye.z, session.camera().target.z);
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    EXPECT_EQ(session.upAxis(), UpAxis::Y);
    EXPECT_EQ(session.camera().up, Vec3(0, 1, 0));
    session.setUpAxis(UpAxis::Z);
    openAndWait(session, QStringLiteral("torus:triangles=320"));
    EXPECT_EQ(session.upAxis(), UpAxis::Z) << "chosen for scenes that do not say it";
}

TEST(Session, picturesOfAllViewsHaveOneLimitTogether) {
    Session session{sessionOptions(false)};
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    const Viewport large{8192, 8192}, small{640, 480}, of4k{3840, 2160};
    session.setPictureSize({0, 1, 2, 3, 4, 5, 6, 7}, of4k);
    EXPECT_TRUE(said.empty());
    EXPECT_EQ(session.setup(7).size, of4k);
    session.setPictureSize({3}, large);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("126 million pixels together, and at most 67 million"), std::string::npos) << said[0];
    EXPECT_EQ(session.setup(3).size, of4k) << "nothing is changed";
    session.setPictureSize({0, 1, 2, 3, 4, 5, 6, 7}, std::nullopt);
    session.setPictureSize({3}, large);
    EXPECT_EQ(session.setup(3).size, large);
    // A session may have asked for more: then everything that makes it less is possible.
    ViewSetup asked = session.setup(4);
    asked.size = large;
    session.setSetup(4, asked);
    session.setPictureSize({5}, small);
    EXPECT_EQ(session.setup(5).size, std::nullopt);
    session.setPictureSize({4}, Viewport{8192, 4096});
    EXPECT_EQ(session.setup(4).size, (Viewport{8192, 4096}));
    EXPECT_EQ(said.size(), 2u);
}

/// Pixels that `backface` misses because of snapping are counted apart from losses.
TEST(ViewMetrics, edgePixelsOfBackfaceAreNoLoss) {
    ViewMetrics figures;
    figures.accuracy.missedPixels = 1;
    EXPECT_EQ(figures.lostPixels(), 1u);
    figures.missedBeyondSnapping = 0;
    EXPECT_EQ(figures.lostPixels(), 0u);
}

TEST(Session, aFailedUploadFailsTheFiguresUntilOneSucceeds) {
    Session::Options options = sessionOptions(true);
    bool fail = true;
    options.uploader = [&fail](GpuThread& gpu, const ScenePointer& scene) {
        if (fail) throw std::bad_alloc();
        return gpu.upload(scene);
    };
    Session session(options);
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    session.setViewport(0, {160, 120});
    session.setViewport(1, {160, 120});
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    ASSERT_TRUE(
        waitUntil([&] { return !session.uploadFailure().empty() && session.slot(0).built() && session.slot(1).built(); }));
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(30.0), {}));
    EXPECT_TRUE(session.metricsSettled());
    EXPECT_EQ(session.figures(0).state, ViewMetrics::State::Failed);
    EXPECT_EQ(said.size(), 1u);
    fail = false;
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    ASSERT_TRUE(waitUntil([&] { return session.figures(0).state == ViewMetrics::State::Ready; }));
}

TEST(GpuThread, buffersMayOutliveIt) {
    SceneBuffersPointer late;
    {
        GpuThread gpu;
        const ScenePointer scene = openScene("sphere:triangles=80").scene;
        gpu.run([&] { late = gpu.upload(scene); });
    }
    EXPECT_EQ(late->scene().triangleCount(), 80u);
    late = nullptr;
}

/// The whole pipeline: upload to OpenGL, strategies, truth.
TEST(Session, figuresComeAndALosslessStrategyMissesNothing) {
    Session session(sessionOptions(true));
    session.slot(0).choose("backface");
    session.slot(1).choose("frustum");
    session.setViewport(0, {160, 120});
    session.setViewport(1, {160, 120});
    openAndWait(session, QStringLiteral("sphere:triangles=1280"));
    ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled(); }));
    for (const int view : {0, 1}) {
        const ViewMetrics& figures = session.figures(view);
        ASSERT_EQ(figures.state, ViewMetrics::State::Ready);
        EXPECT_EQ(figures.lostPixels(), 0u);
        EXPECT_EQ(figures.missedBeyondSnapping.has_value(), view == 0);
        EXPECT_GT(figures.accuracy.coveredPixels, 1000u);
        EXPECT_EQ(figures.sceneTriangles, session.opened()->scene->triangleCount());
        EXPECT_TRUE(figures.speedup.has_value());
    }
    // The strategy `backface` and its baseline are one measurement.
    EXPECT_EQ(*session.figures(0).speedup, (RatioEstimate{1.0, {1.0, 1.0}, false}));
}

TEST(Session, truthIsComputedOnceForViewsThatShareIt) {
    Session session(sessionOptions(true));
    session.slot(0).choose("frustum");
    session.slot(1).choose("frustum");
    session.setViewport(0, {160, 120});
    session.setViewport(1, {160, 120});
    openAndWait(session, QStringLiteral("sphere:triangles=1280"));
    ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled(); }));
    const size_t before = session.meter()->referencesComputed();
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(30.0), {}));
    EXPECT_EQ(session.figures(0).state, ViewMetrics::State::Stale);
    ASSERT_TRUE(waitUntil([&] { return session.metricsSettled(); }));
    EXPECT_EQ(session.figures(0).truthFacing, session.figures(1).truthFacing);
    EXPECT_EQ(session.meter()->referencesComputed(), before + 1);
}

TEST(Session, viewsOfOneCameraHaveTimesOfOneMomentSoThatTheirRatiosAndFpsAgree) {
    Session session(sessionOptions(true));
    session.slot(0).choose("all");
    session.slot(1).choose("frustum");
    session.setViewport(0, {160, 120});
    session.setViewport(1, {160, 120});
    openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=320,n=4"));
    ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled(); }));
    const size_t references = session.meter()->referencesComputed();
    for (const char* id : {"frustum-octree", "backface", "spherical"}) {
        size_t untimed = 0;
        QObject guard;
        QObject::connect(&session, &Session::metricsChanged, &guard,
                         [&](int view) { untimed += view == 0 && !session.figures(0).timed ? 1 : 0; });
        session.slot(1).choose(id);
        ASSERT_TRUE(waitUntil([&] { return session.slot(1).built()->id() == id && session.metricsSettled(); })) << id;
        // What back-face culling took is the same by both views' figures, whichever baseline their × is over.
        const auto baseline = [&](int view) {
            const ViewMetrics& figures = session.figures(view);
            return figures.speedupOverFrontFaces.value_or(*figures.speedup).ratio * figures.frameMilliseconds;
        };
        EXPECT_NEAR(baseline(0), baseline(1), 1e-9 * baseline(0)) << id;
        EXPECT_EQ(untimed, 0u) << "the other view's figures stayed until its new times were there";
    }
    EXPECT_LE(session.meter()->referencesComputed(), references + 1) << "losses that are known are not counted anew";
}

TEST(Session, movingTheCameraMakesFiguresStale) {
    Session::Options options = sessionOptions(true);
    options.restBeforeMeasuring = 200;  // between two moves nothing is measured
    Session session(options);
    session.setViewport(0, {160, 120});
    session.setViewport(1, {160, 120});
    openAndWait(session, QStringLiteral("sphere:triangles=1280"));
    for (int i = 0; i < 20; ++i) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(1.0), {}));
        QTest::qWait(5);
        EXPECT_EQ(session.figures(1).state, ViewMetrics::State::Stale);
    }
}

}  // namespace
}  // namespace cullscope::ui::session_test
