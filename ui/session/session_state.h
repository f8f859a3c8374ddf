#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/image/picture_metadata.h"
#include "core/scene/absolute_files.h"
#include "ui/session/camera_bookmarks.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The state that the window shows, as plain values: stored in session files and picture metadata, and restored by undo.
struct SessionState {
    struct View {
        std::string strategy;                           ///< id; empty: keep the view's present strategy
        std::map<std::string, std::string> parameters;  ///< text by key; missing parameters have their defaults
        ViewSetup setup;

        bool operator==(const View&) const = default;
    };

    std::string scene;         ///< a specification with absolute file paths
    std::vector<bool> hidden;  ///< one flag per object of the scene
    Camera camera;             ///< the linked views' camera
    UpAxis up = UpAxis::Y;
    std::optional<double> chosenNear;
    std::optional<Section> section;  ///< that cuts the pictures
    int viewCount = 2;
    int activeView = 0;
    std::string arrangement;  ///< id of the window's arrangement; empty: keep the present one
    std::array<View, Session::kMostViews> views;
    CameraBookmarks::Places bookmarks;
    std::optional<LogPlace> place;  ///< where the active view's frame is stepped; none: its whole frame is shown
    /// What the panel "Inside" shows; empty ids: what it shows already.
    struct StructurePanelState {
        std::string page;  ///< id of the open tab
        std::string map;   ///< id of the map's colouring

        bool operator==(const StructurePanelState&) const = default;
    };
    StructurePanelState structurePanel;
    std::optional<DrawStyle> style;  ///< background and surface of the pictures; none: those of the window's appearance

    bool operator==(const SessionState&) const = default;
};

/// Whether a view's picture depends on another view.
[[nodiscard]] inline bool leansOn(const SessionState::View& view, int other) {
    const bool beside = view.setup.wipe.mode == Wipe::Mode::OtherView || view.setup.wipe.mode == Wipe::Mode::Difference;
    return (view.setup.role == Role::Observer && view.setup.observed == other) || (beside && view.setup.wipe.other == other);
}

/// Whether a view is shown, or one that is shown depends on its strategy.
[[nodiscard]] inline bool isSeen(const SessionState& state, int view) {
    const auto shown = [&](int each) { return state.viewCount == 1 ? each == state.activeView : each < state.viewCount; };
    for (int each = 0; each < Session::kMostViews; ++each)
        if (shown(each) && (each == view || leansOn(state.views[size_t(each)], view))) return true;
    return false;
}

/// Captures all of the state but arrangement, `structurePanel` and bookmarks, which the session does not hold, and the style,
/// which depends on the window's appearance. `scene` is empty if none is open.
[[nodiscard]] SessionState captureState(const Session& session);

/// Applies cameras, hidden objects and views of a state to the opened scene. Does not open `scene` and ignores arrangement,
/// bookmarks, `place`, `structurePanel` and style. If the scene has another number of objects, all are shown and a warning is
/// raised. Values that are equal already are not set. Throws Error(Usage) for an unknown strategy or parameter, before any
/// change.
void applyState(Session& session, const SessionState& state);

/// What a view's picture shows, or would show; without figures. `request`: what is drawn; none: there is nothing to draw yet.
[[nodiscard]] PictureSubject pictureSubject(const Session& session, int view, const std::optional<ViewRequest>& request);

}  // namespace cullscope::ui
