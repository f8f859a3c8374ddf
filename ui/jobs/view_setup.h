#pragma once

#include <optional>
#include <string>

#include "core/gpu/scene_buffers.h"
#include "core/image/view_picture.h"
#include "core/scene/camera.h"

namespace cullscope::ui {

/// Which camera culls in a view, and through which one the user looks.
enum class Role {
    Linked,    ///< culls and looks through the camera that the linked views share
    Observer,  ///< culling camera, strategy and verdicts of another view, viewing camera of its own
    Frozen     ///< the culling camera stands still, viewing camera of its own
};

/// The comparison that one view shows beside its strategy's picture.
struct Wipe {
    enum class Mode {
        None,
        Truth,      ///< the truth left of the line, the strategy right of it
        Loss,       ///< the whole picture paled, with missed and added pixels marked
        OtherView,  ///< this view's strategy left of the line, another view's right of it
        Difference  ///< the whole picture paled, with the pixels marked at which the two views' strategies differ
    };
    Mode mode = Mode::None;
    int other = 0;          ///< number of the other view in OtherView and Difference
    double position = 0.5;  ///< of the line, as a fraction of the picture's width

    bool operator==(const Wipe&) const = default;
};

/// The size of a view's picture unless another one is chosen: that of cullbench. Figures of a size of their own do not change
/// with the window.
inline constexpr Viewport kUsualPictureSize{640, 480};

/// All settings of one view but its strategy, which is in its StrategySlot. Plain values, as session files and picture metadata
/// store them.
struct ViewSetup {
    Role role = Role::Linked;
    int observed = 0;                     ///< Observer: number of the view whose culling is shown
    Camera viewing;                       ///< Observer and Frozen: the viewing camera
    Camera culling;                       ///< Frozen: the culling camera
    std::optional<Viewport> cullingSize;  ///< Frozen: the picture size that the culling camera culls for
    /// Of the picture, in pixels; none: fit to the window.
    std::optional<Viewport> size = kUsualPictureSize;
    Upload upload = Upload::Vbo;
    ViewLook look;
    Wipe wipe;
    std::string below;  ///< id of the panel in a strip below the picture; empty: none
    std::string panel;  ///< id of the panel shown in place of the picture; empty: the picture

    bool operator==(const ViewSetup&) const = default;
};

}  // namespace cullscope::ui
