// The legend of the lecture's window: it names the colours of the pictures and of the map, and no others.
#include "tests/ui/lecture.h"

namespace cullscope::ui::lecture_test {
namespace {

using LectureLegend = Lecture;

TEST_F(LectureLegend, namesTheColourOfWhatAStepHasInHand) {
    watch("frustum");
    LectureWindow& lecture = begin();
    const auto named = [&] { return lecture.legend().words().contains(QStringLiteral("in hand")); };
    EXPECT_FALSE(named());
    window.actions().stepThrough->trigger();
    ASSERT_TRUE(waitUntil([&] { return window.stepper().place() != nullptr; }));
    EXPECT_TRUE(waitUntil(named));
    window.actions().stepThrough->trigger();
    EXPECT_TRUE(waitUntil([&] { return !named(); }));
}

TEST_F(LectureLegend, namesLinesOfAStrategysOwn) {
    watch("bsp");
    LectureWindow& lecture = begin();
    const QString words = QStringLiteral("plane that the eye is before");
    EXPECT_FALSE(lecture.legend().words().contains(words));
    ViewSetup setup = session.setup(1);
    setup.look.show("bsp-planes", true);
    session.setSetup(1, setup);
    EXPECT_TRUE(waitUntil([&] { return lecture.legend().words().contains(words); }));
    session.slot(0).choose("spherical");
    EXPECT_TRUE(waitUntil([&] { return !lecture.legend().words().contains(words); })) << "it has no such planes";
}

TEST_F(LectureLegend, lacksMarksThatThePictureLacks) {
    watch("frustum");
    LectureWindow& lecture = begin();
    ViewSetup setup = session.setup(0);
    setup.wipe.mode = Wipe::Mode::Loss;
    session.setSetup(0, setup);
    ASSERT_TRUE(waitUntil([&] { return lecture.legend().words().contains(QStringLiteral("missed pixels")); }));
    ASSERT_TRUE(waitUntil([&] { return drawn(); }));
    EXPECT_FALSE(lecture.legend().words().contains(QStringLiteral("nearer than the truth"))) << "there are none";
}

TEST_F(LectureLegend, saysWhatTheTonesOfTheMapMean) {
    watch("spherical");
    LectureWindow& lecture = begin();
    // The map is read, and the legend speaks of it, before its colouring changes.
    ASSERT_TRUE(waitUntil([&] { return lecture.legend().words().contains(QStringLiteral("triangles a cell, logarithmic")); }));
    lecture.structure().map().setColouring("radius");
    const QString words = QStringLiteral("farthest R, mesh units");
    EXPECT_TRUE(waitUntil([&] { return lecture.legend().words().contains(words); }));
    lecture.structure().map().setColouring("state");
    EXPECT_TRUE(waitUntil([&] { return !lecture.legend().words().contains(words); })) << "its cells have colours of states";
    session.slot(0).choose("bsp");
    EXPECT_TRUE(waitUntil([&] { return !lecture.structure().map().isVisible(); }));
    EXPECT_FALSE(lecture.legend().words().contains(words));
}

}  // namespace
}  // namespace cullscope::ui::lecture_test
