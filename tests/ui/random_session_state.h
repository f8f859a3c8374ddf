#pragma once

#include <cmath>
#include <initializer_list>

#include "core/geometry/random.h"
#include "core/visibility/registry.h"
#include "ui/session/session_state.h"
#include "ui/session/view_sizes.h"

// States of a session as random as a file can hold them.
namespace cullscope::ui::session_file_test {

inline size_t below(Random& random, size_t count) { return size_t(random.unit() * double(count)); }

template <typename Enum>
Enum oneOf(Random& random, std::initializer_list<Enum> all) {
    return *(all.begin() + below(random, all.size()));
}

/// A random number of widely varying magnitude, small enough that distances stay finite.
inline double anyNumber(Random& random) { return random.between(-1.0, 1.0) * std::pow(10.0, random.between(-12.0, 12.0)); }

inline Camera anyCamera(Random& random) {
    Camera camera;
    camera.eye = Vec3(anyNumber(random), anyNumber(random), anyNumber(random));
    camera.target = Vec3(anyNumber(random), anyNumber(random), anyNumber(random));
    camera.up = random.direction();
    camera.fovy = Angle::fromRadians(random.between(0.001, 3.1));
    camera.nearDistance = std::pow(10.0, random.between(-9.0, 3.0));
    camera.farDistance = camera.nearDistance * (1.0 + random.between(0.001, 1e7));
    if (random.unit() < 0.3) {
        camera.projection = ProjectionKind::Parallel;
        camera.height = std::pow(10.0, random.between(-9.0, 9.0));
    }
    return camera;
}

/// So large that eight views together have as many pixels as a session can.
inline Viewport anySize(Random& random) {
    return {1 + int(below(random, 16384)), 1 + int(below(random, kMostPixelsOfSession / 8 / 16384))};
}

inline ViewSetup anySetup(Random& random) {
    ViewSetup setup;
    setup.role = oneOf(random, {Role::Linked, Role::Frozen});
    setup.observed = int(below(random, 8));
    setup.viewing = anyCamera(random);
    setup.culling = anyCamera(random);
    if (random.unit() < 0.5) setup.size = anySize(random);
    if (random.unit() < 0.5) setup.cullingSize = anySize(random);
    setup.upload = oneOf(random, {Upload::Vbo, Upload::VertexArray});
    const auto any = [&] { return random.unit() < 0.5; };
    for (const Show* show : pictureShows()) setup.look.show(show->id, any());
    setup.wipe = {
        oneOf(random, {Wipe::Mode::None, Wipe::Mode::Truth, Wipe::Mode::Loss, Wipe::Mode::OtherView, Wipe::Mode::Difference}),
        int(below(random, 8)), random.unit()};
    setup.panel = oneOf<const char*>(random, {"", "inside", "statistics"});
    return setup;
}

inline SessionState::View anyView(Random& random) {
    const StrategyInfo& info = strategies()[below(random, strategies().size())].info;
    SessionState::View view{info.id, {}, anySetup(random)};
    for (const ParameterDeclaration& declaration : info.parameters) {
        const auto& choices = declaration.choices;
        view.parameters.emplace(declaration.key,
                                choices.empty() ? toText(declaration.defaultValue) : choices[below(random, choices.size())].id);
    }
    return view;
}

inline SessionState anyState(Random& random) {
    SessionState state;
    state.scene = oneOf<const char*>(random, {"bunny", "/a/b/castle 성.obj", "field:mesh=/x/y,z.ply,n=3", "sphere:triangles=80"});
    for (size_t object = below(random, 30); object > 0; --object) state.hidden.push_back(random.unit() < 0.4);
    state.camera = anyCamera(random);
    if (random.unit() < 0.5) state.section = Section{Section::Axis(random.bits() % 4), random.unit(), random.unit() < 0.5};
    state.up = oneOf(random, {UpAxis::Y, UpAxis::Z});
    if (random.unit() < 0.5) state.chosenNear = std::pow(10.0, random.between(-9.0, 9.0));
    state.viewCount = Session::kViewCounts[below(random, Session::kViewCounts.size())];
    state.activeView = int(below(random, 8));
    state.arrangement = oneOf<const char*>(random, {"", "explore", "compare"});
    for (SessionState::View& view : state.views) view = anyView(random);
    for (size_t view = 1; view < 8; ++view) {
        // Some views observe view A, which is never an observer itself.
        if (random.unit() > 0.3) continue;
        state.views[view].setup.role = Role::Observer;
        state.views[view].setup.observed = 0;
    }
    for (std::optional<CameraBookmark>& place : state.bookmarks)
        if (random.unit() < 0.5) place = CameraBookmark(anyCamera(random), random.unit() < 0.5 ? "entrance, \"north\"" : "");
    if (random.unit() < 0.5) {
        const auto channel = [&] { return float(random.unit()); };
        state.style.emplace();
        state.style->background = Vec3f(channel(), channel(), channel());
        state.style->surface = Vec3f(channel(), channel(), channel());
    }
    return state;
}

}  // namespace cullscope::ui::session_file_test
