#include "ui/jobs/view_frames.h"

#include <malloc.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "core/scene/camera_moves.h"
#include "tests/ui/test_scene.h"
#include "ui/panels/structure_panel.h"
#include "ui/panels/why_panel.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui::view_frames_test {
namespace {

/// A session with two views of a field of boxes, and all panels that read decisions.
class ViewFramesTest : public testing::Test {
protected:
    ViewFramesTest() {
        session.setViewCount(2);
        session.setViewport(0, {160, 120});
        session.setViewport(1, {160, 120});
        openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=320,n=4"));
        reader.readFor(&why);
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            return session.pictures()->isCurrent(0) && session.pictures()->isCurrent(1) && !session.pictures()->busy() &&
                   session.metricsSettled() && (!why.isVisible() || reader.fresh());
        }));
    }

    [[nodiscard]] size_t decided(int view) const { return session.frames()->decided(view); }

    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    WhyPanel why{session, reader};
};

TEST_F(ViewFramesTest, aFrameIsDecidedOnceForPictureVerdictsPanelsFiguresAndPick) {
    session.setMeasuring(true);
    session.slot(1).choose("frustum-octree");
    session.setActiveView(1);
    why.show();
    settle();
    const size_t before = decided(1);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    settle();
    EXPECT_EQ(decided(1), before + 1) << "picture, panels and figures";
    EXPECT_EQ(session.figures(1).frame, session.picture(1)->frame) << "the frame that is timed and judged repeats the shown one";
    EXPECT_EQ(reader.reading()->frame, session.picture(1)->frame);
    ViewSetup setup = session.setup(1);
    setup.look.show("verdicts", true);
    setup.look.show("boxes", true);
    session.setSetup(1, setup);
    settle();
    session.pickAt(1, 80, 60);
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    settle();
    EXPECT_FALSE(reader.reading()->why.empty());
    EXPECT_EQ(decided(1), before + 1) << "colours, boxes, pick and why";
}

TEST_F(ViewFramesTest, aFrameOfManyObjectsIsDecidedOnceThoughItsDecisionsAreReadLater) {
    openAndWait(session, QStringLiteral("field:mesh=sphere:triangles=20,n=160"));
    ASSERT_GE(session.opened()->scene->instances().size(), 25'000u);
    session.slot(1).choose("frustum-octree");
    session.setActiveView(1);
    settle();
    const size_t before = decided(1);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    settle();
    EXPECT_EQ(decided(1), before + 1) << "the picture";
    why.show();
    ViewSetup setup = session.setup(1);
    setup.look.show("verdicts", true);
    setup.look.show("boxes", true);
    session.setSetup(1, setup);
    settle();
    session.pickAt(1, 80, 60);
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    settle();
    EXPECT_FALSE(reader.reading()->why.empty());
    EXPECT_EQ(decided(1), before + 1) << "colours, boxes, pick and why";
}

TEST_F(ViewFramesTest, aPickOfALostPixelIsTheTriangleThatIsMissingThere) {
    session.setMeasuring(true);
    session.slot(1).choose("draw-distance");
    ParameterSet parameters = session.slot(1).parameters();
    parameters.setFromText("distance", "0.01");
    session.slot(1).setParameters(parameters);
    session.setActiveView(1);
    settle();
    ASSERT_TRUE(waitUntil([&] { return !session.figures(1).holes.empty(); }));
    const Hole hole = session.figures(1).holes.front();
    const auto picked = [&] {
        if (!waitUntil([&] { return session.pick().has_value(); })) return false;
        const TriangleStates& states = *session.figures(1).states;
        return states.states[session.pick()->triangle] == TriangleState::WronglyCulled;
    };
    session.pickAt(1, hole.x, hole.y);
    EXPECT_TRUE(picked()) << "nothing is drawn there";
    session.pickLostAt(1, hole.x, hole.y);
    EXPECT_TRUE(picked());
    EXPECT_FALSE(session.pointBefore()) << "the next loss is not measured from a click";
    // Beside the truth and beside another view, too, and near the mark of one.
    session.slot(0).choose("all");
    for (const Wipe::Mode mode : {Wipe::Mode::Truth, Wipe::Mode::Loss, Wipe::Mode::OtherView, Wipe::Mode::Difference}) {
        ViewSetup setup = session.setup(1);
        setup.wipe = {mode, 0, 0.5};
        session.setSetup(1, setup);
        settle();
        const bool marked = mode == Wipe::Mode::Loss || mode == Wipe::Mode::Difference;
        session.setPick(std::nullopt);
        session.pickAt(1, hole.x, hole.y);
        EXPECT_TRUE(picked()) << int(mode);
        if (!marked) continue;
        session.setPick(std::nullopt);
        session.pickAt(1, hole.x + 1, hole.y + 1);
        EXPECT_TRUE(picked()) << int(mode);
    }
    why.show();
    settle();
    EXPECT_FALSE(why.decided().isEmpty());
}

TEST_F(ViewFramesTest, anObserverReplaysTheFrameOfItsView) {
    session.slot(1).choose("frustum");
    settle();
    const size_t before = decided(0);
    session.observe(1, 0);
    settle();
    session.setViewingCamera(1, turned(session.viewingCamera(1), UpAxis::Y, Angle::fromDegrees(20.0), {}));
    settle();
    EXPECT_EQ(decided(0), before);
}

/// The first view's picture beside the second one's strategy.
void compare(Session& session) {
    ViewSetup setup = session.setup(0);
    setup.wipe = {Wipe::Mode::OtherView, 1};
    session.setSetup(0, setup);
}

TEST_F(ViewFramesTest, aFrameBesideAnotherViewsPictureIsDecidedOnceWithItsViewsMemory) {
    openAndWait(session, QStringLiteral("layers:count=8,triangles=200"));
    ParameterSet late(findStrategy("octree-query").info.parameters);
    late.setFromText("latency", "1");
    session.slot(1).choose("octree-query");
    session.slot(1).setParameters(late);
    settle();
    ASSERT_EQ(session.slot(1).built()->parameters(), late);
    compare(session);
    settle();
    Camera front = session.camera();
    front.up = {0, 1, 0};
    front.eye = front.target + Vec3(0, 0, 0.6 * session.scene()->bounds().diagonal());
    for (int move = 1; move <= 4; ++move) {
        const size_t before = decided(1);
        session.setActiveView(move % 2);  // whose picture is drawn first
        session.setCamera(zoomed(front, front.target, 1.0 - 0.001 * move, 1.0));
        settle();
        EXPECT_EQ(decided(1), before + 1) << move;
        ASSERT_TRUE(session.picture(0)->otherFrame);
        EXPECT_EQ(session.picture(0)->otherFrame, session.picture(1)->frame) << move;
        EXPECT_EQ(pixelsAlone(session.picture(0)->other), pixelsAlone(session.picture(1)->colour)) << move;
    }
    EXPECT_LT(session.picture(1)->consideredTriangles, session.scene()->triangleCount()) << "the answers hide something";
    // Without the second view on screen, its memory goes on with the frames beside the first one's picture.
    session.setViewCount(1);
    for (int move = 1; move <= 3; ++move) {
        const size_t before = decided(1);
        session.setCamera(zoomed(front, front.target, 1.0 - 0.001 * move, 1.0));
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && !session.pictures()->busy(); }));
        EXPECT_EQ(decided(1), before + 1) << move;
        const uint64_t drawn = session.picture(0)->otherFrame->log.consideredTriangles();
        EXPECT_LT(drawn, session.scene()->triangleCount()) << move;
        ViewSetup setup = session.setup(0);
        setup.look.show("frustum", !setup.look.shows("frustum"));
        session.setSetup(0, setup);
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && !session.pictures()->busy(); }));
        EXPECT_EQ(decided(1), before + 1) << "another look of the same frames";
    }
}

TEST_F(ViewFramesTest, viewsOfOneStrategyShareItsStructure) {
    for (int view = 2; view < Session::kMostViews; ++view) session.slot(view).choose("all");
    session.slot(0).choose("frustum");
    session.slot(1).choose("frustum");
    settle();
    const size_t before = session.structures()->built();
    session.slot(0).choose("spherical-lossless");
    session.slot(1).choose("spherical-lossless");
    settle();
    EXPECT_EQ(session.structures()->built(), before + 1);
    EXPECT_EQ(session.slot(0).built()->structure(), session.slot(1).built()->structure());
    for (const char* key : {"cones", "horizon"}) {
        ParameterSet parameters = session.slot(1).parameters();
        parameters.set(key, false);
        session.slot(1).setParameters(parameters);
        settle();
        EXPECT_EQ(session.slot(1).built()->parameters(), parameters);
    }
    EXPECT_EQ(session.structures()->built(), before + 1) << "a parameter that is read when culling builds nothing";
    ParameterSet parameters = session.slot(1).parameters();
    parameters.setFromText("level", "3");
    session.slot(1).setParameters(parameters);
    ASSERT_TRUE(waitUntil([&] { return session.slot(1).built()->parameters() == parameters; }));
    settle();
    EXPECT_EQ(session.structures()->built(), before + 2);
}

/// Bytes that the program has allocated. Freed memory is not counted.
double allocated() {
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
}

/// Bytes of the program that are in memory.
double resident() {
    long pages = 0;
    if (std::ifstream statm("/proc/self/statm"); !(statm >> pages >> pages)) ADD_FAILURE() << "/proc/self/statm";
    return double(pages) * double(sysconf(_SC_PAGESIZE));
}

/// Bytes by account: of the structures in use, by the store that made them, and of what each shown view has for itself.
struct CountedBytes {
    std::set<StructurePointer> structures;  ///< of the shown views
    uint64_t ofStructures = 0, ofPictures = 0;
};

CountedBytes countedBytes(const Session& session) {
    CountedBytes bytes;
    for (const int view : session.shownViews()) {
        bytes.structures.insert(session.slot(view).built()->structure());
        const ViewPicture& picture = *session.picture(view);
        bytes.ofPictures += uint64_t(picture.colour.sizeInBytes()) + picture.depth.size() * sizeof(float) +
                            picture.frame->log.frameBytes() + picture.frame->log.decisions.size() * sizeof(Decision) +
                            session.scene()->triangleCount() * sizeof(TriangleState);
    }
    bytes.ofStructures = session.structures()->bytes();
    return bytes;
}

TEST_F(ViewFramesTest, eightViewsOfOneStrategyTakeNoMoreThanOneStructureAndTheirPictures) {
    for (int view = 0; view < Session::kMostViews; ++view) {
        session.setViewport(view, {160, 120});
        session.slot(view).choose(view == 0 ? "spherical-lossless" : "all");
    }
    session.setActiveView(0);
    openAndWait(session, QStringLiteral("star:seed=7,triangles=60000"));
    const auto shown = [&](int views) {
        session.setViewCount(views);
        EXPECT_TRUE(waitUntil([&] {
            for (const int view : session.shownViews()) {
                const BuiltStrategyPointer& built = session.slot(view).built();
                if (!built || session.slot(view).building()) return false;
                if (built->id() != "spherical-lossless" || built->scenePointer() != session.scene()) return false;
                if (!session.pictures()->isCurrent(view)) return false;
            }
            return !session.pictures()->busy() && session.metricsSettled();
        }));
        const CountedBytes bytes = countedBytes(session);
        // What the program has allocated and what of it is in memory changes with the driver's work, and is only reported.
        const std::string with = "_with_" + std::to_string(views);
        RecordProperty("structures" + with, std::to_string(bytes.ofStructures));
        RecordProperty("pictures" + with, std::to_string(bytes.ofPictures));
        RecordProperty("allocated" + with, std::to_string(allocated()));
        RecordProperty("resident" + with, std::to_string(resident()));
        return bytes;
    };
    const CountedBytes one = shown(1);
    const size_t built = session.structures()->built();
    for (int view = 1; view < Session::kMostViews; ++view) session.slot(view).choose("spherical-lossless");
    const CountedBytes eight = shown(Session::kMostViews);
    EXPECT_EQ(session.structures()->built(), built) << "views that choose it later build nothing";
    EXPECT_LE(double(eight.ofStructures), 1.15 * double(one.ofStructures)) << "by the store's account";
    ASSERT_EQ(eight.structures.size(), 1u);
    EXPECT_EQ(eight.structures, one.structures);
    EXPECT_EQ(eight.structures.begin()->use_count(), Session::kMostViews + 2) << "of the views, and of the sets here";
    EXPECT_GT(one.ofStructures, one.ofPictures) << "the structure is the larger part";
}

TEST_F(ViewFramesTest, aPictureForTheClipboardReplaysTheFrame) {
    session.slot(1).choose("frustum-octree");
    settle();
    const size_t before = decided(1);
    (void)session.pictures()->drawNow(*session.viewRequest(1));
    EXPECT_EQ(decided(1), before);
}

}  // namespace
}  // namespace cullscope::ui::view_frames_test
