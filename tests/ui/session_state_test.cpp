#include "ui/session/session_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/error.h"
#include "core/geometry/random.h"
#include "core/measure/picture_file.h"
#include "core/mesh/save.h"
#include "core/visibility/registry.h"
#include "tests/ui/test_scene.h"
#include "ui/session/session_file.h"
#include "ui/session/session_opener.h"

namespace cullscope::ui {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

size_t below(Random& random, size_t count) { return size_t(random.unit() * double(count)); }

template <typename Enum>
Enum oneOf(Random& random, std::initializer_list<Enum> all) {
    return *(all.begin() + below(random, all.size()));
}

/// Any finite double that makes no infinite distances.
double anyNumber(Random& random) { return random.between(-1.0, 1.0) * std::pow(10.0, random.between(-12.0, 12.0)); }

Camera anyCamera(Random& random) {
    Camera camera;
    camera.eye = Vec3(anyNumber(random), anyNumber(random), anyNumber(random));
    camera.target = Vec3(anyNumber(random), anyNumber(random), anyNumber(random));
    camera.up = random.direction();
    camera.fovy = Angle::fromRadians(random.between(0.001, 3.1));
    camera.nearDistance = std::pow(10.0, random.between(-9.0, 3.0));
    camera.farDistance = camera.nearDistance * (1.0 + random.between(0.001, 1e7));
    return camera;
}

ViewSetup anySetup(Random& random) {
    ViewSetup setup;
    setup.role = oneOf(random, {Role::Linked, Role::Frozen});
    setup.observed = int(below(random, 8));
    setup.viewing = anyCamera(random);
    setup.culling = anyCamera(random);
    if (random.unit() < 0.5) setup.size = Viewport{1 + int(below(random, 16384)), 1 + int(below(random, 16384))};
    setup.upload = oneOf(random, {Upload::Vbo, Upload::VertexArray});
    setup.look = {oneOf(random, {Colouring::Shaded, Colouring::Verdicts}), random.unit() < 0.5, random.unit() < 0.5,
                  random.unit() < 0.5};
    setup.wipe = {
        oneOf(random, {Wipe::Mode::None, Wipe::Mode::Truth, Wipe::Mode::Loss, Wipe::Mode::OtherView, Wipe::Mode::Difference}),
        int(below(random, 8)), random.unit()};
    return setup;
}

SessionState::View anyView(Random& random) {
    const StrategyInfo& info = strategies()[below(random, strategies().size())].info;
    SessionState::View view{info.id, {}, anySetup(random)};
    for (const ParameterDeclaration& declaration : info.parameters) {
        const auto& choices = declaration.choices;
        view.parameters.emplace(declaration.key,
                                choices.empty() ? toText(declaration.defaultValue) : choices[below(random, choices.size())].id);
    }
    return view;
}

SessionState anyState(Random& random) {
    SessionState state;
    state.scene = oneOf<const char*>(random, {"bunny", "/a/b/castle 성.obj", "field:mesh=/x/y,z.ply,n=3", "sphere:triangles=80"});
    for (size_t object = below(random, 30); object > 0; --object) state.hidden.push_back(random.unit() < 0.4);
    state.camera = anyCamera(random);
    state.up = oneOf(random, {UpAxis::Y, UpAxis::Z});
    if (random.unit() < 0.5) state.chosenNear = std::pow(10.0, random.between(-9.0, 9.0));
    state.viewCount = Session::kViewCounts[below(random, Session::kViewCounts.size())];
    state.activeView = int(below(random, 8));
    state.arrangement = oneOf<const char*>(random, {"", "explore", "compare"});
    for (SessionState::View& view : state.views) view = anyView(random);
    for (size_t view = 1; view < 8; ++view) {
        // Some watch view A, which is none of them.
        if (random.unit() > 0.3) continue;
        state.views[view].setup.role = Role::Observer;
        state.views[view].setup.observed = 0;
    }
    for (std::optional<Camera>& place : state.bookmarks)
        if (random.unit() < 0.5) place = anyCamera(random);
    return state;
}

/// The sentence that a text is refused with; empty: it is not refused.
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

TEST(SessionText, filesWereLostWhenTheFolderMoved) {
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
    // Called as a generator is, and yet a file.
    EXPECT_EQ(movedScene("/home/a/work/sphere"), "/mnt/b/work/sphere");
}

TEST(SessionText, everyTruncationIsRefusedInASentence) {
    const std::string text = textOf(someState());
    // But for the line's end after the last brace.
    for (size_t bytes = 0; bytes + 1 < text.size(); ++bytes) {
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
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = text;
        for (size_t changes = 1 + below(random, 4); changes > 0; --changes)
            damaged[below(random, damaged.size())] =
                char(random.unit() < 0.5 ? random.bits() : "{}[]\",:-0e9n"[below(random, 12)]);
        refused += refusal(damaged).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 2000u);
    const std::string nested(100'000, '[');
    EXPECT_THAT(refusal(nested), HasSubstr("not JSON"));
    EXPECT_EQ(refusal(nested + std::string(100'000, ']')), "no session");
}

/// The text of some state with one value, found by its JSON pointer, put in the place of another.
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
        {"/view_count", 3, "\"view_count\": there are 1, 2, 4 or 8 views."},
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

/// All that is captured, given to another session with the same scene, is what that one captures.
TEST(SessionState, appliesToAllRoles) {
    Session from(sessionOptions(false)), to(sessionOptions(false));
    openAndWait(from, QStringLiteral("field:n=3"));
    openAndWait(to, QStringLiteral("field:n=3"));
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        from.setViewCount(Session::kViewCounts[below(random, 4)]);
        from.setActiveView(int(below(random, size_t(from.viewCount()))));
        for (int view = 0; view < Session::kMostViews; ++view) {
            from.slot(view).choose(strategies()[below(random, strategies().size())].info.id);
            if (random.unit() < 0.3) from.observe(view, int(below(random, 8)));
            if (random.unit() < 0.2) from.setFrozen(view, random.unit() < 0.7);
            if (random.unit() < 0.2) from.setLinked(view);
            if (random.unit() < 0.5)
                from.setViewingCamera(view, turned(from.viewingCamera(view), from.upAxis(),
                                                   Angle::fromDegrees(random.between(-90.0, 90.0)), Angle::fromDegrees(3.0)));
            ViewSetup setup = from.setup(view);
            setup.look.frustum = random.unit() < 0.5;
            setup.wipe.position = random.unit();
            from.setSetup(view, setup);
        }
        if (random.unit() < 0.3) from.setUpAxis(from.upAxis() == UpAxis::Y ? UpAxis::Z : UpAxis::Y);
        if (random.unit() < 0.3) from.setChosenNear(random.between(0.1, 2.0));
        std::vector<bool> hidden = from.hidden();
        hidden[below(random, hidden.size())].flip();
        from.setHidden(hidden);
        const SessionState state = captureState(from);
        applyState(to, state);
        ASSERT_EQ(captureState(to), state) << i;
        for (int view = 0; view < Session::kMostViews; ++view) {
            EXPECT_EQ(to.cullingCamera(view), from.cullingCamera(view));
            EXPECT_EQ(to.viewingCamera(view), from.viewingCamera(view));
            EXPECT_EQ(to.culledBy(view), from.culledBy(view));
        }
    }
}

TEST(SessionState, whatIsAlreadySoIsNotTouched) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("field:n=3"));
    session.observe(1, 0);
    session.setFrozen(2, true);
    const SessionState state = captureState(session);
    int changes = 0;
    const auto count = [&] { ++changes; };
    QObject::connect(&session, &Session::cameraChanged, count);
    QObject::connect(&session, &Session::setupChanged, count);
    QObject::connect(&session, &Session::strategyChosen, count);
    QObject::connect(&session, &Session::hiddenChanged, count);
    applyState(session, state);
    EXPECT_EQ(changes, 0);
}

TEST(SessionState, hiddenObjectsOfAnotherSceneAreShown) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("field:n=3"));
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    session.setHidden({true, false, false, false, false, false, false, false, false});
    SessionState state = captureState(session);
    state.hidden = {true, true};
    applyState(session, state);
    EXPECT_EQ(session.hidden(), std::vector<bool>(9, false));
    EXPECT_EQ(said, (std::vector<std::string>{"The scene has 9 objects now, no longer 2: all of them are shown."}));
}

struct Opener : ::testing::Test {
    Opener() {
        QObject::connect(&session, &Session::messageRaised,
                         [&](Severity, const Message& message) { said.push_back(message.english()); });
        QObject::connect(&opener, &SessionOpener::opened, [&](const QString& what) { opened.push_back(what.toStdString()); });
        QObject::connect(&opener, &SessionOpener::restored, [&] { ++restored; });
    }
    [[nodiscard]] QString in(const char* name) const { return folder.filePath(QLatin1String(name)); }
    void expectSentence(const QString& file, const char* part) {
        const size_t before = said.size();
        const SessionState state = opener.current({});
        const OpenedScenePointer scene = session.opened();
        opener.open(file);
        ASSERT_TRUE(waitUntil([&] { return said.size() > before; })) << file.toStdString();
        QTest::qWait(20);
        EXPECT_EQ(said.size(), before + 1);
        EXPECT_THAT(said.back(), HasSubstr(part));
        EXPECT_EQ(session.opened(), scene);
        EXPECT_EQ(opener.current({}), state);
    }

    QTemporaryDir folder;
    Session session{sessionOptions(false)};
    CameraBookmarks bookmarks;
    SessionOpener opener{session, bookmarks};
    std::vector<std::string> said, opened;
    int restored = 0;
};

TEST_F(Opener, tellsTypesApart) {
    const auto kind = [](const char* what) { return SessionOpener::kindOf(QString::fromUtf8(what)); };
    EXPECT_EQ(kind("/a/b.cullscope"), SessionOpener::Kind::Session);
    EXPECT_EQ(kind("/a/b.JSON"), SessionOpener::Kind::Session);
    EXPECT_EQ(kind("shot.png"), SessionOpener::Kind::Picture);
    EXPECT_EQ(kind("shot.EXR"), SessionOpener::Kind::Picture);
    EXPECT_EQ(kind("a.obj"), SessionOpener::Kind::Scene);
    EXPECT_EQ(kind("png"), SessionOpener::Kind::Scene);
    EXPECT_EQ(kind("bunny"), SessionOpener::Kind::Scene);
    EXPECT_EQ(kind("field:mesh=a.json"), SessionOpener::Kind::Scene);
}

TEST_F(Opener, aSavedSessionComesBackWithItsMesh) {
    const OpenedScene torus = openScene("torus:triangles=400");
    const std::vector<PlacedMesh> meshes{{"torus", torus.scene->meshes().front().get()}};
    saveMeshFile(in("torus.ply").toStdString(), meshes);
    openAndWait(session, in("torus.ply"));
    session.slot(0).choose("frustum");
    session.observe(1, 0);
    session.setChosenNear(0.5);
    bookmarks.store(2, session);
    ASSERT_TRUE(opener.save(in("s.cullscope"), QStringLiteral("compare")));
    const SessionState state = opener.current(QStringLiteral("compare"));
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    session.slot(0).choose("all");
    session.setLinked(1);
    session.setViewCount(8);
    bookmarks.setPlaces({});
    opener.open(in("s.cullscope"));
    ASSERT_TRUE(waitUntil([&] { return restored == 1; }));
    EXPECT_EQ(opener.current(QStringLiteral("compare")), state);
    EXPECT_EQ(opened.back(), in("s.cullscope").toStdString());
    EXPECT_TRUE(said.empty());
}

TEST_F(Opener, whatCannotBeOpenedLeavesEverything) {
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    session.observe(1, 0);
    SessionState state = opener.current({});
    state.scene = in("gone.obj").toStdString();
    saveSession(in("gone.cullscope").toStdString(), state);
    std::ofstream(in("bad.json").toStdString()) << "{\"format\"";
    std::ofstream(in("bad.png").toStdString()) << "no picture";
    writePicture(in("plain.png").toStdString(), {{1, 1}, {1, 2, 3, 255}, {}});
    writePicture(in("damaged.png").toStdString(), {{1, 1}, {1, 2, 3, 255}, {{kSessionMetadata, "{\"format\""}}});
    expectSentence(in("gone.cullscope"), "gone.obj");
    expectSentence(in("bad.json"), "not JSON from byte");
    expectSentence(in("none.cullscope"), "cannot be opened");
    expectSentence(in("bad.png"), "bad.png");
    expectSentence(in("plain.png"), "only pictures that Cullscope saved can be opened.");
    expectSentence(in("damaged.png"), "not JSON from byte");
    EXPECT_EQ(restored, 0);
}

TEST_F(Opener, aPictureBringsItsSessionBack) {
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    session.slot(1).choose("frustum");
    const SessionState state = opener.current({});
    for (const char* name : {"a.png", "a.jpg", "a.exr", "a.tif"}) {
        const std::filesystem::path file = in(name).toStdString();
        writePicture(file, {{1, 1}, {1, 2, 3, 255}, {{kSessionMetadata, stateToText(state, file)}}});
        session.slot(1).choose("all");
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
        const int before = restored;
        opener.open(in(name));
        ASSERT_TRUE(waitUntil([&] { return restored > before; })) << name;
        EXPECT_EQ(opener.current({}), state) << name;
    }
}

TEST_F(Opener, aNewerOpenCancelsTheWaitingState) {
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    SessionState state = opener.current({});
    state.scene = "torus:triangles=400";
    state.views[0].strategy = "frustum";
    state.views[0].parameters.clear();
    session.slot(0).choose("all");
    opener.restore(state);
    session.open(QStringLiteral("sphere:triangles=80"));
    ASSERT_TRUE(waitUntil([&] { return !opened.empty() && opened.back() == "sphere:triangles=80"; }));
    EXPECT_EQ(session.slot(0).id(), "all");
    EXPECT_EQ(restored, 0);
    // Also while the file itself is still being read.
    saveSession(in("s.cullscope").toStdString(), state);
    opener.open(in("s.cullscope"));
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    QTest::qWait(50);
    EXPECT_EQ(session.opened()->specification, "sphere:triangles=320");
    EXPECT_EQ(restored, 0);
}

TEST_F(Opener, bookmarksStoreAndRecallTheActiveViewsCamera) {
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    EXPECT_FALSE(bookmarks.recall(0, session));
    session.observe(1, 0);
    session.setActiveView(1);
    const Camera observer = session.viewingCamera(1), linked = session.camera();
    bookmarks.store(0, session);
    session.setViewingCamera(1, turned(observer, UpAxis::Y, Angle::fromDegrees(40.0), {}));
    ASSERT_NE(session.viewingCamera(1), observer);
    EXPECT_TRUE(bookmarks.recall(0, session));
    EXPECT_EQ(session.viewingCamera(1), observer);
    EXPECT_EQ(session.camera(), linked);
}

/// Everything changed, then the session opened again: the same pictures.
TEST(SessionState, picturesComeBackPixelForPixel) {
    QTemporaryDir folder;
    Session session(sessionOptions(true));
    CameraBookmarks bookmarks;
    SessionOpener opener(session, bookmarks);
    for (int view = 0; view < 4; ++view) session.setViewport(view, {160, 120});
    const auto settle = [&] {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.figuresSettled() && !session.pictures()->busy(); }));
        for (const int view : session.shownViews()) ASSERT_TRUE(session.pictures()->isCurrent(view)) << view;
    };
    openAndWait(session, QStringLiteral("field:n=4"));
    session.setViewCount(4);
    session.slot(0).choose("frustum");
    session.slot(2).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 10.0));
    session.observe(1, 0);
    ViewSetup observer = session.setup(1);
    observer.look = {Colouring::Verdicts, true, true, true};
    session.setSetup(1, observer);
    session.setFrozen(2, true);
    session.setViewingCamera(2, turned(session.viewingCamera(2), UpAxis::Y, Angle::fromDegrees(50.0), {}));
    std::vector<bool> hidden(16, false);
    hidden[3] = hidden[7] = true;
    session.setHidden(hidden);
    ViewSetup sized = session.setup(3);
    sized.size = Viewport{200, 90};
    session.setSetup(3, sized);
    settle();
    std::vector<QImage> before;
    for (int view = 0; view < 4; ++view) before.push_back(session.picture(view)->colour);
    const QString file = folder.filePath(QStringLiteral("s.cullscope"));
    ASSERT_TRUE(opener.save(file, {}));

    openAndWait(session, QStringLiteral("torus:triangles=500"));
    session.setViewCount(2);
    for (int view = 0; view < 4; ++view) {
        session.setSetup(view, ViewSetup{});
        session.slot(view).choose("all");
    }
    session.setUpAxis(UpAxis::Z);
    settle();
    QSignalSpy restored(&opener, &SessionOpener::restored);
    opener.open(file);
    ASSERT_TRUE(waitUntil([&] { return restored.count() == 1; }));
    settle();
    for (int view = 0; view < 4; ++view) EXPECT_EQ(session.picture(view)->colour, before[size_t(view)]) << view;
    EXPECT_NE(before[0], before[1]);
    EXPECT_NE(before[0], before[2]);
}

}  // namespace
}  // namespace cullscope::ui
