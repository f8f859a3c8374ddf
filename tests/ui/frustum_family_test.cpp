// Strategies that require OpenGL, in the desktop: culled on the thread with the context, refused with the reason if the context
// does not support them; and the colours and tables of frustum planes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QStandardItemModel>

#include "core/scene/camera_moves.h"
#include "core/visibility/registry.h"
#include "tests/ui/test_scene.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/plane_table.h"
#include "ui/panels/strategy_panel.h"
#include "ui/panels/structure_tree.h"
#include "ui/panels/why_panel.h"
#include "ui/session/object_pick.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui::frustum_family_test {
namespace {

using ::testing::HasSubstr;

const Viewport kSize{320, 240};
const QString kScene = QStringLiteral("field:mesh=sphere:triangles=80,n=6,spacing=2.5");

/// A simulated machine whose driver offers core profiles only, and whose context can be lost on demand.
struct Machine {
    std::atomic<bool> core = false;
    std::atomic<int> reset = 0;

    Session::Options options() {
        Session::Options options = sessionOptions(true);
        options.gpu.lost = [this] { return reset > 0 && --reset == 0; };
        options.gpu.context = [this] {
            QSurfaceFormat format = QSurfaceFormat::defaultFormat();
            if (core) {
                format.setProfile(QSurfaceFormat::CoreProfile);
                format.setOption(QSurfaceFormat::DeprecatedFunctions, false);
            }
            auto context = std::make_unique<QOpenGLContext>();
            context->setFormat(format);
            return context->create() ? std::move(context) : nullptr;
        };
        return options;
    }
};

/// Two views, so close that some objects lie outside the frustum.
struct FrustumFamily : ::testing::Test {
    void begin(bool core = false) {
        machine.core = core;
        session = std::make_unique<Session>(machine.options());
        QObject::connect(session.get(), &Session::messageRaised,
                         [this](Severity, const Message& message) { said.push_back(message.english()); });
        for (int view = 0; view < 2; ++view) session->setViewport(view, kSize);
        session->setActiveView(0);
        openAndWait(*session, kScene);
        session->setCamera(zoomed(session->camera(), session->camera().target, 0.4, 1.0));
    }
    void choose(const std::string& first, const std::string& second) {
        session->slot(0).choose(first);
        session->slot(1).choose(second);
        settle();
    }
    void settle() {
        ASSERT_TRUE(waitUntil([&] {
            for (const int view : session->shownViews())
                if (session->slot(view).building()) return false;
            return session->metricsSettled() && !session->pictures()->busy();
        }));
    }

    Machine machine;
    std::vector<std::string> said;
    std::unique_ptr<Session> session;
};

TEST_F(FrustumFamily, strategyThatAsksOpenGlIsDrawnMeasuredAndPicked) {
    begin();
    for (const char* id : {"frustum-select", "frustum-query"}) {
        choose("all", id);
        const ViewMetrics& figures = session->figures(1);
        ASSERT_EQ(figures.state, ViewMetrics::State::Ready) << id << ": " << figures.failure.english();
        EXPECT_TRUE(figures.timed);
        EXPECT_EQ(figures.accuracy.missedPixels, 0u) << id;
        EXPECT_LT(figures.consideredTriangles, figures.sceneTriangles) << id;
        ASSERT_TRUE(session->picture(1));
        EXPECT_EQ(session->picture(1)->request.strategy->id(), id);
        session->setPick(std::nullopt);
        session->pickAt(1, kSize.width / 2, kSize.height / 2);
        session->pickAt(1, kSize.width / 2, kSize.height / 3);
        EXPECT_TRUE(waitUntil([&] { return session->pick().has_value(); })) << id;
    }
    EXPECT_TRUE(said.empty()) << said.front();
}

TEST_F(FrustumFamily, whatAStrategyThatAsksDecidedIsReadAlsoAfterALoss) {
    begin();
    QWidget watcher;
    SnapshotReader reader(*session);
    reader.readFor(&watcher);
    watcher.show();
    choose("frustum-query", "all");
    pickObject(*session, 0);
    const auto read = [&] { return waitUntil([&] { return reader.fresh() && reader.reading()->triangle.has_value(); }); };
    ASSERT_TRUE(read());
    const PlaneCounts counts = countByPlane(*reader.reading()->snapshot);
    EXPECT_EQ(reader.reading()->snapshot->nodes.size(), 36u);
    EXPECT_GT(counts.kept, 0u);
    EXPECT_GT(counts.withoutPlane, 0u) << "OpenGL names no plane";
    EXPECT_EQ(counts.kept + counts.withoutPlane, 36u);
    EXPECT_FALSE(reader.reading()->why.empty());
    EXPECT_EQ(reader.reading()->planes.size(), 6u);
    // The result of a cull in a lost context is not shown, and the cull is repeated.
    const size_t begun = reader.begun();
    machine.reset = 1;
    session->setCamera(turned(session->camera(), UpAxis::Y, Angle::fromDegrees(10.0), {}));
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    ASSERT_TRUE(read());
    EXPECT_GT(reader.begun(), begun);
    EXPECT_EQ(reader.reading()->culling, session->cullingCamera(0));
    EXPECT_TRUE(reader.reading()->failure.empty());
    EXPECT_THAT(said.front(), HasSubstr("nothing is lost"));
}

TEST_F(FrustumFamily, theTwinsKeepEquallyManyBoxes) {
    begin();
    QWidget watcher;
    SnapshotReader reader(*session);
    reader.readFor(&watcher);
    watcher.show();
    std::vector<uint64_t> kept;
    for (const char* id : {"frustum-select", "frustum-query"}) {
        choose(id, "all");
        ASSERT_TRUE(waitUntil([&] { return reader.fresh() && reader.reading()->strategy->id() == id; }));
        kept.push_back(countByPlane(*reader.reading()->snapshot).kept);
    }
    EXPECT_EQ(kept[0], kept[1]);
}

TEST_F(FrustumFamily, selectionWithoutItsProfileIsRefusedWithTheReason) {
    begin(true);
    const StrategyInfo& info = findStrategy("frustum-select").info;
    ASSERT_FALSE(session->gpu()->info().compatibilityProfile);
    ASSERT_TRUE(session->unavailable(info));
    EXPECT_FALSE(session->unavailable(findStrategy("frustum-query").info));
    for (int view = 0; view < Session::kMostViews; ++view) EXPECT_NE(session->slot(view).id(), info.id);
    choose("frustum", "frustum-query");
    EXPECT_EQ(session->figures(1).accuracy.missedPixels, 0u);
    EXPECT_TRUE(said.empty());
    // The strategy can still be named by a session, by a picture or on the command line.
    choose("frustum-select", "frustum-query");
    EXPECT_TRUE(session->slot(0).refused());
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(said.back(), HasSubstr("gives no compatibility profile"));
    EXPECT_EQ(session->figures(0).state, ViewMetrics::State::Failed);
    EXPECT_EQ(session->figures(0).failure.english(), said.back());
    EXPECT_FALSE(session->picture(0)) << "the picture of another strategy stands under its name";
    EXPECT_TRUE(session->picture(1));
    choose("frustum", "frustum-query");
    EXPECT_FALSE(session->slot(0).refused());
    EXPECT_TRUE(session->picture(0));
    EXPECT_EQ(session->figures(0).state, ViewMetrics::State::Ready);
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(FrustumFamily, choiceOfWhatIsRefusedIsGreyWithTheReason) {
    for (const bool core : {true, false}) {
        begin(core);
        StrategyPanel panel(*session);
        const auto* choice = panel.findChild<QComboBox*>();
        ASSERT_NE(choice, nullptr);
        for (int row = 0; row < choice->count(); ++row) {
            const QModelIndex index = choice->model()->index(row, 0);
            const bool refused = core && index.data(StrategyModel::IdRole) == QStringLiteral("frustum-select");
            EXPECT_EQ(index.flags().testFlag(Qt::ItemIsEnabled), !refused) << row;
            EXPECT_EQ(index.data(Qt::ToolTipRole).toString().contains(QStringLiteral("compatibility profile")), refused) << row;
        }
    }
}

TEST_F(FrustumFamily, whyNamesAllSixPlanesWherePlanesDecideAndElseThoseThatWereTested) {
    begin();
    SnapshotReader reader(*session);
    WhyPanel why(*session, reader);
    reader.readFor(&why);
    why.show();
    auto* table = why.findChild<PlaneTable*>();
    ASSERT_NE(table, nullptr);
    for (const char* id : {"frustum", "frustum-octree", "frustum-select", "frustum-query"}) {
        choose(id, "all");
        std::set<bool> verdicts;
        for (uint32_t object = 0; object < 36; object += 5) {
            pickObject(*session, object);
            ASSERT_TRUE(waitUntil([&] { return reader.fresh() && reader.reading()->strategy->id() == id; }));
            // OpenGL answers about the others' boxes: at most the near and the far plane are tested.
            if (reader.reading()->strategy->info().first(Show::Kind::Planes) != nullptr)
                ASSERT_EQ(table->rowCount(), 6) << id << ", object " << object;
            else
                ASSERT_LE(table->rowCount(), 2) << id << ", object " << object;
            bool outside = false;
            for (const PlaneDistance& plane : reader.reading()->planes)
                outside = outside || plane.containment == Containment::Outside;
            verdicts.insert(outside);
            // `frustum` tests all six planes of an object that it keeps.
            if (std::string(id) == "frustum" && !outside) {
                EXPECT_FALSE(table->showsUntested()) << object;
            }
            if (std::string(id) == "frustum-select") {
                EXPECT_EQ(table->rowCount(), 0) << object << ": it tests no planes itself";
            }
        }
        EXPECT_EQ(verdicts.size(), 2u) << "not both kinds were picked";
    }
    choose("backface", "all");
    ASSERT_TRUE(waitUntil([&] { return reader.fresh() && reader.reading()->strategy->id() == "backface"; }));
    EXPECT_EQ(table->rowCount(), 0) << "it tests no box";
}

TEST_F(FrustumFamily, legendCountsTheBoxesOfThePicture) {
    begin();
    choose("frustum-octree", "all");
    LegendPanel legend(*session);
    legend.show();
    auto* planes = legend.findChild<PlaneLegend*>();
    ASSERT_NE(planes, nullptr);
    EXPECT_FALSE(planes->isVisible());
    ViewSetup setup = session->setup(0);
    setup.look.showWithAll(commonShow(Show::Kind::Planes), true);
    session->setSetup(0, setup);
    settle();
    ASSERT_TRUE(session->picture(0) && session->picture(0)->request.look.has(Show::Kind::Planes));
    EXPECT_TRUE(planes->isVisible());
    const PlaneCounts& counts = session->picture(0)->planes;
    uint64_t all = counts.kept + counts.withoutPlane;
    for (const uint64_t count : counts.rejected) all += count;
    EXPECT_EQ(all, 36u);
    EXPECT_GT(counts.kept, 0u);
    EXPECT_LT(counts.kept, 36u);
    QStringList texts;
    for (const QLabel* label : planes->findChildren<QLabel*>()) texts << label->text();
    EXPECT_TRUE(texts.contains(QString::number(counts.kept))) << texts.join(QLatin1Char('|')).toStdString();
    setup = session->setup(0);
    setup.look.showWithAll(commonShow(Show::Kind::Planes), false);
    EXPECT_TRUE(setup.look.shows("boxes")) << "they stay, by verdict";
    session->setSetup(0, setup);
    EXPECT_FALSE(planes->isVisible());
}

}  // namespace
}  // namespace cullscope::ui::frustum_family_test
