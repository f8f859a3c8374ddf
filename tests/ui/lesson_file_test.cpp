// Lessons as files: what is read, what is refused, and steps that are added.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "core/base/error.h"
#include "ui/session/lesson.h"
#include "ui/session/lesson_player.h"
#include "ui/text/language_ids.h"

namespace cullscope::ui::lesson_file_test {
namespace {

using ::testing::HasSubstr;

const std::string kHead = "title en A lesson\nstep\nsay en One.\n";

Lesson read(const std::string& lines) { return lessonFromText(kHead + lines, "/s/a.lesson"); }

std::string refusal(const std::string& text) {
    try {
        (void)lessonFromText(text, "/s/a.lesson");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        return error.what();
    }
    return {};
}

TEST(LessonFile, everyOwnLessonIsReadAndSpeaksThreeLanguages) {
    EXPECT_EQ(LessonPlayer::known().size(), 9);
    for (const QString& name : LessonPlayer::known()) {
        const Lesson lesson = LessonPlayer::read(name);
        EXPECT_GE(lesson.steps.size(), 8u) << name.toStdString();
        EXPECT_EQ(lesson.title, LessonPlayer::titleOf(name));
        for (const std::string_view id : kLanguageIds) {
            EXPECT_TRUE(lesson.title.contains(std::string(id))) << name.toStdString();
            for (size_t step = 0; step < lesson.steps.size(); ++step)
                EXPECT_TRUE(lesson.steps[step].sentence.contains(std::string(id))) << name.toStdString() << " step " << step + 1;
        }
    }
}

TEST(LessonFile, unknownNameIsRefusedWithThoseThatThereAre) {
    try {
        (void)LessonPlayer::read(QStringLiteral("magic"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(error.what(), HasSubstr("\"magic\""));
        for (const QString& name : LessonPlayer::known()) EXPECT_THAT(error.what(), HasSubstr(name.toStdString()));
    }
}

TEST(LessonFile, stepSaysWhatDiffersFromTheStepBefore) {
    const Lesson lesson = read(
        "scene torus:triangles=500\nview_count 2\nA.strategy spherical\nA.parameters.band 7\nB.role observer\nB.observed A\n"
        "camera 1 2 3  0 0 0\nstep\nsay en Two.\nsay ko 둘.\nA.look.frustum true\ncamera home\nstep\nsay en Three.\n"
        "A.strategy all\ncamera orbit:8 5\nplace.entry 1\nplace.of 2\ninside.page listing\n");
    ASSERT_EQ(lesson.steps.size(), 3u);
    EXPECT_EQ(lesson.steps[0].state.views[0].parameters.at("band"), "7");
    EXPECT_EQ(lesson.steps[0].state.camera.eye, Vec3(1, 2, 3));
    EXPECT_EQ(lesson.steps[0].camera.kind, CameraChoice::Kind::Given);
    EXPECT_EQ(lesson.steps[1].state.views[0].strategy, "spherical");
    EXPECT_EQ(lesson.steps[1].state.views[0].parameters.at("band"), "7");
    EXPECT_TRUE(lesson.steps[1].state.views[0].setup.look.shows("frustum"));
    EXPECT_EQ(lesson.steps[1].state.views[1].setup.role, Role::Observer);
    EXPECT_EQ(lesson.steps[1].camera, CameraChoice());
    EXPECT_EQ(textIn(lesson.steps[1].sentence, "ko"), "둘.");
    EXPECT_EQ(textIn(lesson.steps[1].sentence, "zh_CN"), "Two.");
    // Parameters of one strategy are none of another.
    EXPECT_TRUE(lesson.steps[2].state.views[0].parameters.empty());
    EXPECT_EQ(lesson.steps[2].camera, (CameraChoice{CameraChoice::Kind::Pose, "orbit:8", 5}));
    EXPECT_EQ(lesson.steps[2].state.place, (LogPlace{1, 2}));
    EXPECT_EQ(lesson.steps[2].state.structurePanel.page, "listing");
    EXPECT_FALSE(lesson.steps[2].saysUp);
}

TEST(LessonFile, whatIsWrongIsSaidWithFileAndLine) {
    const struct {
        std::string text;
        const char* said;
    } cases[]{
        {"", "/s/a.lesson:1: a lesson needs a title and at least one line \"step\"."},
        {"title en A\n", "/s/a.lesson:1: a lesson needs a title"},
        {"step\nsay en One.\n", "/s/a.lesson:1: a lesson needs a title"},
        {"title en A\nstep\n", "/s/a.lesson:2: the step has no sentence: add a line \"say\"."},
        {"title xx A\n", "/s/a.lesson:1: \"xx\" is no language: write one of en, ko, zh_CN before the sentence."},
        {"title en\n", "/s/a.lesson:1: the sentence is missing."},
        {kHead + "say en Again.\n", "/s/a.lesson:4: there is a sentence in \"en\" already."},
        {kHead + "A\n", "/s/a.lesson:4: write a field of a session and its value"},
        {kHead + "A.role\n", "/s/a.lesson:4: write a field of a session and its value"},
        {kHead + "views 1\n", "/s/a.lesson:4: write a field of a session and its value"},
        {kHead + "A.role boss\n", "/s/a.lesson:4: \"views[0].role\" must be one of these words: linked, observer, frozen."},
        {kHead + "A.role observer\nA.observed A\n", "/s/a.lesson:5: \"views[0].observed\": a view can watch only another one"},
        {kHead + "A.strategy magic\n", "/s/a.lesson:4: \"views[0].strategy\": There is no strategy"},
        {kHead + "A.parameters.colour red\n", "/s/a.lesson:4: \"views[0].parameters.colour\": There is no parameter"},
        {kHead + "A.look.verdict true\n", "/s/a.lesson:4: a session has no field \"views[0].look.verdict\" here."},
        {kHead + "brightness 3\n", "/s/a.lesson:4: a session has no field \"brightness\" here."},
        {kHead + "view_count 3\n", "/s/a.lesson:4: \"view_count\": there are 1, 2, 4, 6 or 8 views."},
        {kHead + "\n# a comment\ncamera case-1\n", "/s/a.lesson:6: write \"home\", six numbers"},
        {kHead + "camera 1 2 3 4 5\n", "/s/a.lesson:4: write \"home\", six numbers"},
        {kHead + "camera 1 1 1 1 1 1\n", "/s/a.lesson:4: \"camera\": "},
        {kHead + "A.viewing {\"eye\": [1, 2]}\n", "/s/a.lesson:4: \"views[0].viewing.eye\" must be three numbers."},
        {kHead + "A.size [[[[[[1]]]]]]\n", "/s/a.lesson:4: the value has too many brackets."},
        {kHead + "place.entry 3\nplace.of 2\n", "/s/a.lesson:4: \"place.entry\" must be a whole number between 0 and 2."},
    };
    for (const auto& [text, said] : cases) EXPECT_THAT(refusal(text), HasSubstr(said)) << text;
}

TEST(LessonFile, addedStepIsReadBackAsTheSessionThatItShows) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("own.lesson")).toStdString();
    Lesson states = read(
        "scene torus:triangles=500\nview_count 2\nA.strategy spherical\nA.parameters.band 7\nB.role observer\nB.observed A\n"
        "camera 1 2 3  0 0 0\nB.viewing 3 3 3  0 0 0\nA.look.colouring verdicts\nup y\n"
        "step\nsay en Two.\nA.strategy bsp\nA.parameters.plane first\nA.size {\"width\": 320, \"height\": 240}\nview_count 1\n"
        "active_view A\nplace.entry 3\nplace.of 9\ninside.page tree\ninside.map radius\n"
        "step\nsay en Three.\nA.size null\nplace null\nview_count 6\nC.role frozen\nC.culling 1 0 4  0 0 0\nC.viewing 4 4 4  0 0 "
        "0\n"
        "C.below map\nC.wipe.mode other-view\nC.wipe.other B\nhidden \"1\"\nobjects 2\n");
    for (const LessonStep& step : states.steps) {
        appendStep(file, {{"en", "Own"}}, step.state, {{"en", "Said\nin two lines."}, {"ko", "말."}});
        const Lesson lesson = loadLesson(file);
        const LessonStep& added = lesson.steps.back();
        EXPECT_EQ(textIn(lesson.title, "en"), "Own");
        EXPECT_EQ(textIn(added.sentence, "en"), "Said in two lines.");
        EXPECT_EQ(added.camera.kind, CameraChoice::Kind::Given);
        EXPECT_EQ(added.state.scene, step.state.scene);
        EXPECT_EQ(added.state.camera, step.state.camera);
        EXPECT_EQ(added.state.viewCount, step.state.viewCount);
        EXPECT_EQ(added.state.place, step.state.place);
        EXPECT_EQ(added.state.structurePanel, step.state.structurePanel);
        EXPECT_EQ(added.state.hidden, step.state.hidden);
        for (int view = 0; view < 3; ++view) {
            const SessionState::View &mine = added.state.views[size_t(view)], &wanted = step.state.views[size_t(view)];
            if (view >= step.state.viewCount) continue;
            EXPECT_EQ(mine.strategy, wanted.strategy) << view;
            EXPECT_EQ(mine.parameters, wanted.parameters) << view;
            EXPECT_EQ(mine.setup.role, wanted.setup.role) << view;
            EXPECT_EQ(mine.setup.look, wanted.setup.look) << view;
            EXPECT_EQ(mine.setup.size, wanted.setup.size) << view;
            EXPECT_EQ(mine.setup.wipe, wanted.setup.wipe) << view;
            EXPECT_EQ(mine.setup.below, wanted.setup.below) << view;
            if (wanted.setup.role != Role::Linked) EXPECT_EQ(mine.setup.viewing, wanted.setup.viewing) << view;
            if (wanted.setup.role == Role::Frozen) EXPECT_EQ(mine.setup.culling, wanted.setup.culling) << view;
        }
    }
    EXPECT_EQ(loadLesson(file).steps.size(), states.steps.size());
}

TEST(LessonFile, stepIsNotAddedToAFileThatIsNoLesson) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("notes.lesson")).toStdString();
    std::ofstream(file) << "shopping: milk\n";
    EXPECT_THROW(appendStep(file, {{"en", "Own"}}, read("scene torus\n").steps.front().state, {{"en", "Said."}}), Error);
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "shopping: milk");
}

TEST(LessonFile, stepOfANameIsCutOff) {
    QString name = QStringLiteral("cases:3");
    EXPECT_EQ(LessonPlayer::cutStep(name), 2);
    EXPECT_EQ(name, QStringLiteral("cases"));
    for (const char* whole : {"cases", "cases:", "cases:x", "cases:0"}) {
        name = QString::fromLatin1(whole);
        EXPECT_EQ(LessonPlayer::cutStep(name), 0);
        EXPECT_EQ(name, QString::fromLatin1(whole));
    }
}

}  // namespace
}  // namespace cullscope::ui::lesson_file_test
