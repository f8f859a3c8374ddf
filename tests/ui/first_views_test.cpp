// The views of a scene that is named at the start.
#include "ui/startup/first_views.h"

#include <set>

#include "tests/ui/test_scene.h"

namespace cullscope::ui::first_views_test {
namespace {

struct FirstViews : ::testing::Test {
    void SetUp() override { openAndWait(session, QStringLiteral("torus:triangles=800")); }

    Session session{sessionOptions(false)};
};

TEST_F(FirstViews, ofANamedSceneEightShowEightStrategiesAndTwoOneThatIsWatched) {
    showFirstViews(session, {});
    EXPECT_EQ(session.setup(1).role, Role::Observer);
    for (const int count : {4, 6, 8}) {
        session.setViewCount(count);
        std::set<std::string> shown;
        for (const int view : session.shownViews()) {
            EXPECT_EQ(session.setup(view).role, Role::Linked) << view;
            shown.insert(session.slot(session.culledBy(view)).id());
        }
        EXPECT_EQ(shown.size(), size_t(count));
        session.setViewCount(2);
        EXPECT_EQ(session.setup(1).role, Role::Observer) << "two views again";
        EXPECT_EQ(session.culledBy(1), 0);
        EXPECT_TRUE(session.setup(1).look.has(Show::Kind::Frustum));
    }
}

TEST_F(FirstViews, whatTheUserChangesStays) {
    showFirstViews(session, {});
    session.setLinked(1);
    session.setViewCount(8);
    session.setViewCount(2);
    EXPECT_EQ(session.setup(1).role, Role::Linked);
    session.observe(1, 0);
    session.setViewCount(8);
    EXPECT_EQ(session.setup(1).role, Role::Observer) << "the user's own observer";
}

}  // namespace
}  // namespace cullscope::ui::first_views_test
