// Every strategy can be stepped: the picture of a step is the replay up to it, from wherever the step was reached.

#include "core/geometry/random.h"
#include "core/visibility/registry.h"
#include "tests/support/long_mode.h"
#include "tests/ui/stepped_window.h"
#include "ui/panels/curve_panel.h"
#include "ui/panels/listing_panel.h"

namespace cullscope::ui::stepped_strategies_test {
namespace {

/// Triangles anywhere in a cube that meet each other, with edges of a third of it at most.
MeshPointer polygons(uint64_t seed, size_t count) {
    TriangleMesh::Data data;
    data.name = "polygons";
    Random random(seed);
    const auto within = [&](double reach) {
        return Vec3f(float(random.between(-reach, reach)), float(random.between(-reach, reach)),
                     float(random.between(-reach, reach)));
    };
    for (size_t i = 0; i < count; ++i) {
        const Vec3f middle = within(1.0);
        for (int corner = 0; corner < 3; ++corner) data.positions.push_back(middle + within(0.3));
        for (uint32_t corner = 0; corner < 3; ++corner) data.indices.push_back(uint32_t(3 * i) + corner);
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

struct SteppedStrategies : SteppedWindow {
    void SetUp() override {
        Window::SetUp();
        session.setViewCount(1);
        session.setActiveView(0);
        ViewSetup setup = session.setup(0);
        setup.size = Viewport{240, 180};
        session.setSetup(0, setup);
    }

    void showPolygons() {
        const MeshPointer mesh = polygons(17, 500);
        auto opened = std::make_shared<OpenedScene>();
        opened->scene =
            std::make_shared<const Scene>("500 polygons", std::vector{mesh}, std::vector<Instance>{{0, Mat4(1.0), "polygons"}});
        session.show(opened);
        settleAll();
    }

    /// Steps a strategy's frame, and compares pictures at some steps.
    void check(const std::string& id) {
        session.slot(0).choose(id);
        settleAll();
        begin();
        const size_t count = stepper().place()->count();
        ASSERT_GT(count, 1u);
        const FrameLog& log = session.step()->frame->log;
        std::map<size_t, QImage> shownAt;
        // On, by jumps.
        for (const size_t step : {size_t{0}, count / 5, count / 2, count - 2, count - 1, count}) {
            showStep(step);
            shownAt[step] = shown();
            EXPECT_EQ(shownAt[step], replay(stepper().place()->entries())) << "step " << step << " of " << count;
        }
        EXPECT_EQ(shownAt[count], pictureOf(log)) << "the last step is the frame";
        EXPECT_NE(shownAt[count], shownAt[0]);
        // Back step by step, and on again.
        window.actions().stepBack->trigger();
        window.actions().stepBack->trigger();
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        EXPECT_EQ(shown(), shownAt[count - 2]) << "two steps back";
        window.actions().stepOn->trigger();
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        EXPECT_EQ(shown(), shownAt[count - 1]) << "one step on";
        // By single steps to where a jump was.
        const size_t from = count / 2 > 3 ? count / 2 - 3 : 0;
        showStep(from);
        for (size_t step = from; step < count / 2; ++step) window.actions().stepOn->trigger();
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        EXPECT_EQ(shown(), shownAt[count / 2]) << "single steps to the middle";
        // Every entry has words and, where it is a decision at a line, that line is the listing's current one.
        const BuiltStrategy& strategy = *session.step()->frame->request.strategy;
        for (const size_t step : {size_t{1}, count / 2, count}) {
            showStep(step);
            EXPECT_FALSE(stepper().sentence().isEmpty());
            ASSERT_TRUE(strategy.listing(log.upTo(stepper().place()->entries()))) << "every strategy has a listing";
            const std::optional<FrameEntry> entry = stepper().place()->current();
            if (entry->decision && entry->decision->line > 0) {
                EXPECT_EQ(strategy.listing(log.upTo(stepper().place()->entries()))->current, entry->decision->line);
            }
        }
        window.actions().stepThrough->trigger();
        ASSERT_FALSE(session.step());
        settleAll();
    }

    /// Those of the registry that this OpenGL can run; every third one where samples are small.
    [[nodiscard]] std::vector<std::string> available() {
        std::vector<std::string> ids;
        const size_t every = test::fewSamples() ? 3 : 1;
        for (size_t i = 0; i < strategies().size(); i += every)
            if (!unavailable(strategies()[i].info, session.gpu()->info())) ids.push_back(strategies()[i].info.id);
        return ids;
    }
};

TEST_F(SteppedStrategies, theQuizByEveryStrategy) {
    openAndWait(session, QStringLiteral("quiz"));
    settleAll();
    for (const std::string& id : available()) {
        SCOPED_TRACE(id);
        ASSERT_NO_FATAL_FAILURE(check(id));
    }
}

TEST_F(SteppedStrategies, fiveHundredPolygonsByEveryStrategy) {
    showPolygons();
    for (const std::string& id : available()) {
        SCOPED_TRACE(id);
        ASSERT_NO_FATAL_FAILURE(check(id));
    }
}

TEST_F(SteppedStrategies, aBodyBySphericalCoordinatesSeenWholeAndCut) {
    openAndWait(session, QStringLiteral("star:seed=3,triangles=%1").arg(test::longMode() ? 144'000 : 8'000));
    settleAll();
    ASSERT_NO_FATAL_FAILURE(check("spherical"));
    Camera camera = session.camera();
    camera.fovy = Angle::fromDegrees(14.0);
    session.setCamera(camera);
    ASSERT_NO_FATAL_FAILURE(check("spherical"));
    ASSERT_NO_FATAL_FAILURE(check("spherical-horizon"));
    ASSERT_NO_FATAL_FAILURE(check("spherical-lossless"));
}

/// A body that is tested by bands, with the panel of its structure beside it.
struct SteppedBands : SteppedStrategies {
    void SetUp() override {
        SteppedStrategies::SetUp();
        openAndWait(session, QStringLiteral("star:seed=3,triangles=8000"));
        session.slot(0).choose("spherical");
        settleAll();
    }

    /// Goes to the first step, from this one on, about a kind of subject.
    void goTo(Subject::Kind kind) {
        stepper().setBreakpoints({{EntryKind::Trait::Subject, uint8_t(kind)}});
        stepper().toBreakpoint(true);
        ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0); }));
        ASSERT_TRUE(stepper().place()->current()->decision);
        ASSERT_EQ(stepper().place()->current()->decision->subject.kind, kind);
    }
};

TEST_F(SteppedBands, currentLineOfTheListingIsInSightInALowWindow) {
    window.resize(1366, 600);
    auto* listing = window.structurePanel().findChild<ListingPanel*>();
    ASSERT_TRUE(listing);
    window.structurePanel().tabs().setCurrentWidget(listing);
    ListingView& view = listing->view();
    begin();
    EXPECT_FALSE(listing->summary().contains(QLatin1String("line 0"))) << "before the first step";
    for (const Subject::Kind kind : {Subject::Kind::Object, Subject::Kind::Band}) {
        ASSERT_NO_FATAL_FAILURE(goTo(kind));
        const auto seen = [&] {
            const QModelIndex current = listing->model().index(listing->model().currentRow(), ListingModel::Text);
            return current.isValid() && view.viewport()->visibleRegion().contains(view.visualRect(current).center());
        };
        EXPECT_TRUE(waitUntil(seen)) << "line " << listing->model().currentRow() + 1;
    }
}

TEST_F(SteppedBands, curveShowsTheSectorInHandUpToItsBandAndMarksIt) {
    StructurePanel& panel = window.structurePanel();
    auto* curves = panel.findChild<CurvePanel*>();
    ASSERT_NE(curves, nullptr);
    begin();
    panel.tabs().setCurrentWidget(curves);
    ASSERT_NO_FATAL_FAILURE(goTo(Subject::Kind::Band));
    stepper().jump(stepper().place()->step() + 40);
    const Decision& decision = *stepper().place()->current()->decision;
    ASSERT_EQ(decision.subject.kind, Subject::Kind::Band);
    const auto sector = uint32_t(decision.operands[3]);
    const double alpha = std::min(180.0, decision.operands[2]);
    EXPECT_TRUE(waitUntil([&] { return curves->shownPart() == sector && curves->plot().inHand(); }));
    ASSERT_TRUE(curves->plot().inHand());
    EXPECT_NEAR(curves->plot().inHand()->y, alpha, 1e-9);
    for (const CurveArea& area : curves->plot().curve()->areas)
        for (const CurveArea::Box& box : area.boxes) EXPECT_LT(box.left, alpha) << "later bands are not tested yet";
    window.actions().stepThrough->trigger();
    EXPECT_TRUE(waitUntil([&] { return !curves->plot().inHand(); }));
}

TEST_F(SteppedBands, mapMarksWhatIsInHandAndTheObserverSeesItToo) {
    session.setViewCount(2);
    session.observe(1, 0);
    Camera camera = session.camera();
    camera.fovy = Angle::fromDegrees(14.0);
    session.setCamera(camera);
    settleAll();
    auto* map = window.structurePanel().findChild<MapPanel*>();
    ASSERT_NE(map, nullptr);
    begin();
    for (const auto kind : {Subject::Kind::Cell, Subject::Kind::Cells}) {
        ASSERT_NO_FATAL_FAILURE(goTo(kind));
        window.structurePanel().tabs().setCurrentWidget(map);
        EXPECT_FALSE(session.step()->shape.lines.empty());
        EXPECT_TRUE(
            waitUntil([&] { return !map->map().empty() && map->map().contents().inHand == session.step()->shape.mapLines; }));
        EXPECT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(1); }));
        EXPECT_NE(session.stepOf(1), nullptr);
    }
}

/// Notes which widgets are painted, in their order.
struct Painted : QObject {
    explicit Painted(const std::vector<QWidget*>& watched) {
        for (QWidget* widget : watched) widget->installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) order.push_back(watched);
        return false;
    }
    std::vector<QObject*> order;
};

/// Waits until widgets were not painted for a while, however busy the machine is.
void untilNothingIsPainted(const std::vector<QWidget*>& watched) {
    const Painted painted(watched);
    for (size_t before = 1; painted.order.size() != std::exchange(before, painted.order.size());) QTest::qWait(300);
}

TEST_F(SteppedBands, pictureOfAStepIsPaintedBeforeThePanelsThatFollowIt) {
    MapWidget& map = window.structurePanel().findChild<MapPanel*>()->map();
    begin();
    ASSERT_NO_FATAL_FAILURE(goTo(Subject::Kind::Cells));
    for (int i = 0; i < 3; ++i) {
        untilNothingIsPainted({&picture(0), &map});  // of the step before
        Painted painted({&picture(0), &map});
        i == 1 ? stepper().back() : stepper().forward();
        ASSERT_TRUE(waitUntil([&] { return std::ranges::find(painted.order, &map) != painted.order.end(); }));
        EXPECT_EQ(painted.order.front(), &picture(0));
    }
}

}  // namespace
}  // namespace cullscope::ui::stepped_strategies_test
