// What a view shows besides the drawn triangles: what is chosen, what is seen of it, and what files and command lines call it.

#include "core/image/view_picture.h"
#include "core/visibility/registry.h"
#include "tests/support/gl_environment.h"

namespace cullscope::test::view_look_test {
namespace {

using Names = std::vector<std::string>;
using Unusual = std::vector<std::pair<std::string, std::string>>;
using Kind = Show::Kind;

TEST(ViewLook, showsWhatWasLeftOutByDefaultAndNothingElse) {
    const ViewLook look;
    EXPECT_TRUE(look.shows("culled_too"));
    EXPECT_TRUE(look.shown().empty()) << "it is a part of the verdicts, which are not shown";
    EXPECT_TRUE(overlayIds(look).empty());
    EXPECT_TRUE(unusualOf(look).empty());
    EXPECT_TRUE(legendOf(look).empty());
    EXPECT_FALSE(needsDecisions(look));
    EXPECT_EQ(look, ViewLook{});
}

TEST(ViewLook, isCalledInTheOrderOfTheCommandLine) {
    EXPECT_EQ(overlayIds({"kernel", "frustum", "bands", "boxes", "verdicts"}),
              (Names{"verdicts", "boxes", "frustum", "bands", "kernel"}));
    EXPECT_EQ(overlayIds({"frustum", "verdicts", "spherical-model"}), Names{"spherical-model"}) << "nothing else is seen";
}

TEST(ViewLook, saysWhatIsNotAsByDefaultWhereItIsSeen) {
    ViewLook look{"planes"};
    look.show("culled_too", false);
    EXPECT_TRUE(unusualOf(look).empty()) << "neither boxes nor verdicts are shown";
    EXPECT_FALSE(look.has(Kind::Planes));
    look.show("boxes", true);
    EXPECT_TRUE(look.has(Kind::Planes));
    EXPECT_EQ(unusualOf(look), (Unusual{{"box_colouring", "plane"}}));
    look.show("verdicts", true);
    EXPECT_EQ(unusualOf(look), (Unusual{{"box_colouring", "plane"}, {"drawn_only", "true"}}));
    look.show("spherical-model", true);
    EXPECT_TRUE(unusualOf(look).empty());
}

TEST(ViewLook, coloursByPlaneComeWithTheBoxesAndLeaveThem) {
    ViewLook look;
    look.showWithAll(commonShow(Kind::Planes), true);
    EXPECT_TRUE(look.shows("boxes") && look.has(Kind::Planes));
    look.showWithAll(commonShow(Kind::Planes), false);
    EXPECT_TRUE(look.shows("boxes")) << "by verdict";
    EXPECT_FALSE(look.shows("planes"));
}

TEST(ViewLook, legendHasTheColoursThatAreSeen) {
    using enum TriangleState;
    EXPECT_EQ(legendOf({"boxes"}), (std::set{Visible, OutsideFrustum}));
    EXPECT_EQ(legendOf({"bands"}), (std::set{Visible, Hidden}));
    ViewLook drawn{"verdicts"};
    EXPECT_EQ(legendOf(drawn), (std::set{Visible, InVain, OutsideFrustum, BackFacing, Hidden, TooSmall, WronglyCulled}));
    drawn.show("culled_too", false);
    EXPECT_EQ(legendOf(drawn), (std::set{Visible, InVain}));
}

TEST(ViewLook, losesItsLinesOrAllButWhatStandsInPlace) {
    ViewLook look{"verdicts", "boxes", "frustum", "bands", "spherical-model"};
    EXPECT_TRUE(look.inPlace());
    EXPECT_EQ(look.inPlaceAlone(), ViewLook{"spherical-model"});
    look.leaveOutOverlays();
    EXPECT_EQ(look, (ViewLook{"verdicts", "spherical-model"}));
    ViewLook watching{"boxes"};
    watching.watch();
    EXPECT_EQ(watching, (ViewLook{"verdicts", "boxes", "frustum"}));
}

}  // namespace
}  // namespace cullscope::test::view_look_test
