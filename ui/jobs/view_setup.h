#pragma once

#include <optional>
#include <string>

#include "core/gpu/scene_buffers.h"
#include "core/image/view_picture.h"
#include "core/scene/camera.h"

namespace cullscope::ui {

/// Which camera culls and which one looks.
enum class Role {
    Linked,    ///< both are the camera that the linked views share
    Observer,  ///< culling camera, strategy and verdicts of another view, looked at by a camera of its own
    Frozen     ///< the culling camera stands, a camera of its own looks
};

/// What lies beside the strategy's picture in one view, for comparing.
struct Wipe {
    enum class Mode {
        None,
        Truth,      ///< truth left of the line, the strategy right of it
        Loss,       ///< all of it pale, with the lost and the added pixels
        OtherView,  ///< this view's strategy left of the line, another view's right of it
        Difference  ///< all of it pale, with the pixels in which the two views' strategies differ
    };
    Mode mode = Mode::None;
    int other = 0;          ///< of OtherView and Difference
    double position = 0.5;  ///< of the line, as a share of the width

    bool operator==(const Wipe&) const = default;
};

/// How one view shows what; plain values, as sessions and pictures keep them. Its strategy is in its StrategySlot.
struct ViewSetup {
    Role role = Role::Linked;
    int observed = 0;                     ///< Observer: the view that it watches
    Camera viewing;                       ///< Observer and Frozen: the camera that looks
    Camera culling;                       ///< Frozen: the camera that culls
    std::optional<Viewport> cullingSize;  ///< Frozen: the size of the picture that it culls for
    std::optional<Viewport> size;         ///< of the picture, in pixels; none: fits the window
    Upload upload = Upload::Vbo;
    ViewLook look;
    Wipe wipe;
    std::string panel;  ///< id of the panel that stands in the view's place; empty: its picture

    bool operator==(const ViewSetup&) const = default;
};

/// Boxes in the colours of the planes, which shows boxes; off: by verdict, and they stay.
inline void showBoxesByPlane(ViewLook& look, bool on) {
    look.boxes = look.boxes || on;
    look.boxColouring = on ? BoxColouring::Plane : BoxColouring::Verdict;
}

}  // namespace cullscope::ui
