#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/image/picture_metadata.h"
#include "ui/session/camera_bookmarks.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// What the window shows, as plain values: what a session file and a picture's metadata hold, and what undo goes back to.
struct SessionState {
    struct View {
        std::string strategy;                           ///< id; empty: the view keeps the one that it has
        std::map<std::string, std::string> parameters;  ///< text by key; what is not named has its default
        ViewSetup setup;

        bool operator==(const View&) const = default;
    };

    std::string scene;         ///< a specification, files in it by absolute paths
    std::vector<bool> hidden;  ///< one flag an object of the scene
    Camera camera;             ///< of the linked views
    UpAxis up = UpAxis::Y;
    std::optional<double> chosenNear;
    int viewCount = 2;
    int activeView = 0;
    std::string arrangement;  ///< the window's id for it; empty: as it is
    std::array<View, Session::kMostViews> views;
    CameraBookmarks::Places bookmarks;
    std::optional<DrawStyle> style;  ///< background and surface of the pictures; none: as the window's appearance has them

    bool operator==(const SessionState&) const = default;
};

/// Everything but arrangement and bookmarks, which the session does not know, and the style, which the window's appearance gives.
/// `scene` is empty where nothing is opened.
[[nodiscard]] SessionState captureState(const Session& session);

/// Gives the opened scene the state's cameras, hidden objects and views; neither opens `scene` nor looks at arrangement,
/// bookmarks and style. Hidden objects of a scene with another number of objects are shown, which is raised as a warning. What is
/// the same already is not touched. Throws Error(Usage) for a strategy or parameter that there is none of, before anything
/// changes.
void applyState(Session& session, const SessionState& state);

/// What a view's picture shows, or would show; without figures. `request`: what is drawn; none: there is nothing to draw yet.
[[nodiscard]] PictureSubject pictureSubject(const Session& session, int view, const std::optional<ViewRequest>& request);

/// A specification with its files by absolute paths; words such as `bunny`, and an empty one, stay.
[[nodiscard]] std::string withAbsoluteFiles(const std::string& specification);

/// The view's parameters as the strategy takes them. Throws Error(Usage) naming what there is none of.
[[nodiscard]] ParameterSet parametersOf(const SessionState::View& view);

}  // namespace cullscope::ui
