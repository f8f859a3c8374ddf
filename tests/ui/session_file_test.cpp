#include "ui/session/session_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/geometry/random.h"
#include "tests/support/long_mode.h"
#include "tests/support/peak_memory.h"
#include "tests/ui/random_session_state.h"

namespace cullscope::ui::session_file_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The error message for a text; empty: the text is accepted.
std::string refusal(const std::string& text) {
    try {
        return stateFromText(text, "/s/a.cullscope") ? "" : "no session";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input);
        return error.what();
    }
}

std::string textOf(const SessionState& state) { return stateToText(state, "/s/a.cullscope"); }

SessionState someState() {
    Random random(7);
    SessionState state = anyState(random);
    state.scene = "bunny";
    return state;
}

TEST(SessionText, anyStateComesBackAsItWas) {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const SessionState state = anyState(random);
        const std::filesystem::path file = i % 2 == 0 ? "/a/sessions/s.cullscope" : "";
        const std::string text = stateToText(state, file);
        const std::optional<SessionState> back = stateFromText(text, file);
        ASSERT_TRUE(back.has_value());
        ASSERT_EQ(*back, state) << i << "\n" << text;
        ASSERT_EQ(stateToText(*back, file), text);
    }
}

TEST(SessionText, filesAreFoundWhenTheFolderMoved) {
    SessionState state = someState();
    const auto movedScene = [&](const std::string& scene) {
        state.scene = scene;
        return stateFromText(stateToText(state, "/home/a/work/s.cullscope"), "/mnt/b/work/s.cullscope")->scene;
    };
    EXPECT_EQ(movedScene("/home/a/work/castle.obj"), "/mnt/b/work/castle.obj");
    EXPECT_EQ(movedScene("/home/a/models/castle.obj"), "/mnt/b/models/castle.obj");
    EXPECT_EQ(movedScene("field:mesh=/home/a/work/sub/x.ply,n=3"), "field:mesh=/mnt/b/work/sub/x.ply,n=3");
    EXPECT_EQ(movedScene("split:mesh=field:mesh=/home/a/work/x.ply,n=3,by=components"),
              "split:mesh=field:mesh=/mnt/b/work/x.ply,n=3,by=components");
    EXPECT_EQ(movedScene("mesh:bunny,triangles=10"), "mesh:bunny,triangles=10");
    EXPECT_EQ(movedScene("bunny"), "bunny");
    // A file with the name of a generator.
    EXPECT_EQ(movedScene("/home/a/work/sphere"), "/mnt/b/work/sphere");
}

TEST(SessionText, everyTruncationIsRefusedInASentence) {
    const std::string text = textOf(someState());
    // All truncations but the one that only lacks the line end after the last brace; of a sample every eleventh one.
    for (size_t bytes = 0; bytes + 1 < text.size(); bytes += test::longMode() ? 1 : 11) {
        const std::string said = refusal(text.substr(0, bytes));
        ASSERT_THAT(said, StartsWith("/s/a.cullscope ")) << bytes;
        ASSERT_EQ(said.back(), '.') << said;
    }
    EXPECT_EQ(refusal(text), "");
}

TEST(SessionText, randomlyDamagedTextsNeverCrash) {
    const std::string text = textOf(someState());
    Random random(11);
    size_t refused = 0;
    const uint64_t texts = test::howMany(3'000, 1'000);
    for (uint64_t i = 0; i < texts; ++i) {
        std::string damaged = text;
        for (size_t changes = 1 + below(random, 4); changes > 0; --changes)
            damaged[below(random, damaged.size())] =
                char(random.unit() < 0.5 ? random.bits() : "{}[]\",:-0e9n"[below(random, 12)]);
        refused += refusal(damaged).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, texts * 2 / 3);
    const std::string nested(40'000, '[');
    EXPECT_THAT(refusal(nested), HasSubstr("not JSON"));
    EXPECT_EQ(refusal(nested + std::string(40'000, ']')), "no session");
}

/// The error message for a random state's text in which one value, given by a JSON pointer, is replaced.
std::string refusalWith(const std::string& pointer, const nlohmann::json& value) {
    nlohmann::json json = nlohmann::json::parse(textOf(someState()));
    json[nlohmann::json::json_pointer(pointer)] = value;
    return refusal(json.dump());
}

TEST(SessionText, whatIsWrongIsSaidWithItsPlace) {
    const struct {
        const char* pointer;
        nlohmann::json value;
        const char* said;
    } cases[]{
        {"/version", 2, "/s/a.cullscope was saved by a newer Cullscope: install that one to open it."},
        {"/version", nullptr, "\"version\" is missing"},
        {"/scene", 3, "\"scene\" must be a text"},
        {"/scene", "", "\"scene\": name a mesh file or a generator"},
        {"/hidden", "1-900000", "\"hidden\": There is no object 900000 to hide"},
        {"/objects", -1, "\"objects\" must be a whole number between 0 and 100000000"},
        {"/up", "x", "\"up\" must be one of these words: y, z."},
        {"/camera", nullptr, "\"camera\" is missing"},
        {"/camera/eye", {1, 2}, "\"camera.eye\" must be three numbers."},
        {"/camera/eye", {1, 2, "3"}, "\"camera.eye\" must be three numbers."},
        {"/camera/near", "x", "\"camera.near\" must be a number."},
        {"/camera/near", -1.0, "\"camera\": The near distance must be above 0"},
        {"/camera/fovy_rad", 4.0, "\"camera\": The field of view must lie between 0 and 180"},
        {"/chosen_near", 0, "\"chosen_near\": the near distance must be above 0."},
        {"/view_count", 3, "\"view_count\": there are 1, 2, 4, 6 or 8 views."},
        {"/view_count", 1e300, "\"view_count\" must be a whole number"},
        {"/active_view", 8, "\"active_view\" must be a whole number between 0 and 7."},
        {"/arrangement", nlohmann::json::array(), "\"arrangement\" must be a text"},
        {"/views", nlohmann::json::array(), "\"views\" must be a list of 1 to 8 entries."},
        {"/views", 1, "\"views\" must be a list of 1 to 8 entries."},
        {"/views/2", 1, "\"views[2]\" must be a group of fields"},
        {"/views/2/strategy", "magic", "\"views[2].strategy\": There is no strategy"},
        {"/views/2/parameters", {{"colour", "red"}}, "\"views[2].parameters.colour\": There is no parameter \"colour\""},
        {"/views/2/role", "boss", "\"views[2].role\" must be one of these words: linked, observer, frozen."},
        {"/views/2/observed", 9, "\"views[2].observed\" must be a whole number between 0 and 7."},
        {"/views/2/size", {{"width", 640}}, "\"views[2].size.height\" is missing"},
        {"/views/2/size", {{"width", 0}, {"height", 1}}, "\"views[2].size.width\" must be a whole number between 1 and 16384."},
        {"/views/2/upload", 1, "\"views[2].upload\" must be one of these words: vbo, vertex-array."},
        {"/views/2/look/boxes", 1, "\"views[2].look.boxes\" must be true or false."},
        {"/views/2/look/bands", "x", "\"views[2].look.bands\" must be true or false."},
        {"/views/2/look/kernel", 0, "\"views[2].look.kernel\" must be true or false."},
        {"/views/2/look/spherical_model", 1, "\"views[2].look.spherical_model\" must be true or false."},
        {"/views/2/wipe/position", 1.5, "\"views[2].wipe.position\" must be a number between 0 and 1."},
        {"/views/2/viewing/up", {0, 0, 0}, "\"views[2].viewing\": The camera's up vector is zero"},
        {"/bookmarks", {1}, "\"bookmarks[0]\" must be a group of fields"},
    };
    for (const auto& [pointer, value, said] : cases) {
        EXPECT_THAT(refusalWith(pointer, value), HasSubstr(said)) << pointer;
        EXPECT_THAT(refusalWith(pointer, value), StartsWith("/s/a.cullscope")) << pointer;
    }
    EXPECT_EQ(refusalWith("/views/2/invented", {{"a", 1}}), "");
    std::string huge = textOf(someState());
    huge.replace(huge.find("\"chosen_near\":"), 14, "\"chosen_near\": 1e999, \"x\":");
    EXPECT_THAT(refusal(huge), HasSubstr("a number in it is too large."));
}

TEST(SessionText, moreThanItsViewsMayTakeIsRefusedBeforeAnythingIsMade) {
    const auto sized = [](const char* field, int views, int width, int height) {
        SessionState state = someState();
        for (SessionState::View& view : state.views) view.setup.size.reset(), view.setup.cullingSize.reset();
        nlohmann::json json = nlohmann::json::parse(textOf(state));
        for (int view = 0; view < views; ++view) json["views"][size_t(view)][field] = {{"width", width}, {"height", height}};
        return refusal(json.dump());
    };
    for (const char* field : {"size", "culling_size"}) {
        EXPECT_THAT(sized(field, 8, 16384, 16384),
                    HasSubstr("\"views\": The views' pictures would have 2148 million pixels together"));
        EXPECT_EQ(sized(field, 2, 8192, 8192), "");
        EXPECT_THAT(sized(field, 2, 8192, 8193), HasSubstr("and at most 134 million are possible"));
    }
    std::string many = textOf(someState());
    std::string lists;
    for (int i = 0; i < 300'000; ++i) lists += "[],";
    many.insert(many.find('{') + 1, "\"unknown\": [" + lists + "[]],");
    EXPECT_THAT(refusal(many), HasSubstr("it has more than 100000 values."));
    if (!test::memoryIsTheWorks()) return;
    EXPECT_LT(test::peakBytesOf([&] { (void)refusal(many); }), size_t{16} << 20);
}

TEST(SessionText, aViewThatWatchesItselfOrAnObserverIsRefused) {
    SessionState state = someState();
    for (SessionState::View& view : state.views) view.setup.role = Role::Linked;
    const std::string said = "a view can watch only another one that is no observer itself.";
    state.views[3].setup.role = Role::Observer;
    state.views[3].setup.observed = 3;
    EXPECT_THAT(refusal(textOf(state)), HasSubstr("\"views[3].observed\": " + said));
    state.views[3].setup.observed = 4;
    EXPECT_EQ(refusal(textOf(state)), "");
    state.views[4].setup.role = Role::Observer;
    state.views[4].setup.observed = 0;
    EXPECT_THAT(refusal(textOf(state)), HasSubstr(said));
}

TEST(SessionText, whatIsLeftOutStaysAsInANewSession) {
    const std::string camera = R"({"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fovy_rad": 1, "near": 1, "far": 9})";
    const std::optional<SessionState> state =
        stateFromText(R"({"format": "cullscope session", "version": 1, "scene": "teapot", "camera": )" + camera +
                          R"(, "views": [{"strategy": "frustum"}]})",
                      {});
    ASSERT_TRUE(state.has_value());
    EXPECT_EQ(state->views[0].strategy, "frustum");
    EXPECT_EQ(state->views[0].setup, ViewSetup{});
    EXPECT_EQ(state->views[1], SessionState::View{});
    EXPECT_FALSE(state->chosenNear.has_value());
}

TEST(SessionText, nobodyElsesJsonIsTakenForASession) {
    EXPECT_EQ(refusal("{}"), "no session");
    EXPECT_EQ(refusal("[1, 2]"), "no session");
    EXPECT_EQ(refusal(R"({"format": 1})"), "no session");
    EXPECT_EQ(refusal(R"({"fovy_deg": 45, "poses": []})"), "no session");
}

struct SessionFile : ::testing::Test {
    [[nodiscard]] std::filesystem::path in(const char* name) const { return folder.path().toStdString() + "/" + name; }
    QTemporaryDir folder;
};

std::string contentOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST_F(SessionFile, isWrittenWholeOrNotAtAll) {
    const SessionState state = someState();
    saveSession(in("a.cullscope"), state);
    EXPECT_EQ(loadSession(in("a.cullscope")), state);
    const std::string before = contentOf(in("a.cullscope"));
    SessionState unsaveable = state;
    unsaveable.scene = "/a/\xff\xfe.obj";
    EXPECT_THROW(saveSession(in("a.cullscope"), unsaveable), Error);
    EXPECT_THROW(saveSession(in("a.cullscope"), SessionState{}), Error);
    EXPECT_EQ(contentOf(in("a.cullscope")), before);
    EXPECT_THROW(saveSession("/dev/full", state), Error);
    EXPECT_THROW(saveSession(in("a.cullscope") / "b.cullscope", state), Error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path().toStdString()), {}), 1);
}

TEST_F(SessionFile, whatIsNoneSaysSo) {
    const auto said = [](const std::filesystem::path& file) -> std::string {
        try {
            (void)loadSession(file);
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            return error.what();
        }
    };
    EXPECT_THAT(said(in("none.cullscope")), HasSubstr("cannot be opened"));
    EXPECT_THAT(said(folder.path().toStdString()), HasSubstr("cannot be opened"));
    std::ofstream(in("empty.cullscope")).flush();
    EXPECT_THAT(said(in("empty.cullscope")), HasSubstr("not JSON from byte"));
    std::ofstream(in("other.json")) << "{\"poses\": []}";
    EXPECT_THAT(said(in("other.json")), HasSubstr("is no session that Cullscope saved."));
}

}  // namespace
}  // namespace cullscope::ui::session_file_test
