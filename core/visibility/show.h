#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/frame/listing.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

/// Why a strategy that does not declare a show cannot show it. `option` is what the user wrote on the command line, as
/// "--overlay kernel"; `having` names the strategies that declare it, separated by commas. Only cullbench prints it.
using AbsentShow = Message (*)(const std::string& option, const std::string& strategy, const std::string& having);

/// One of the colourings of a Show that is a map.
struct ShowColouring {
    std::string id;               ///< on the command line and in metadata
    AbsentShow absent = nullptr;  ///< null: every strategy that declares the show has this colouring
};

/// What a strategy can show of a recorded frame besides the drawn triangles. A family declares what only it has. Every strategy
/// has verdicts, the frustum, the boxes that it tests, and the model in spherical coordinates without declaring them.
struct Show {
    enum class Kind {
        Overlay,       ///< lines over a view's picture
        Boxes,         ///< the strategy's own form of the overlay `boxes`
        DirectionMap,  ///< a map of directions, of one object (frame/cell_map.h), in place of the scene's picture and in the
                       ///< desktop's panel "Inside"
        Curve,         ///< values over an axis, of one object (frame/curve.h), in a tab of the desktop's panel "Inside"
        Listing,       ///< pseudo-code, whose lines the decisions name (Decision::line), in a tab of that panel
        Bars           ///< named counts (bars.h), in a tab of that panel
    };
    Kind kind = Kind::Overlay;
    std::string id;      ///< on the command line, in session files and in metadata
    std::string help;    ///< English, for the command line's help; none of a Listing or Bars
    std::string title;   ///< of an Overlay in a menu, of a Curve and Bars the tab, of a map in a sentence; marked for translation
    std::string action;  ///< the same with a marked key, in the window's menu
    std::string explanation;                ///< one sentence about it, marked for translation
    std::vector<TriangleState> legend;      ///< the states whose colours it uses
    AbsentShow absent = nullptr;            ///< never null for what cullbench draws: Overlay, DirectionMap
    std::vector<ShowColouring> colourings;  ///< of a DirectionMap: the first one is the default
    std::string colouringHelp;              ///< English, for the command line's help
    std::vector<ListingLine> lines;         ///< of a Listing: kMostListingLines at most
};

/// A strategy's listing: lines that its code follows. A strategy has one at most.
[[nodiscard]] Show listingShow(std::vector<ListingLine> lines);
/// Counts that a strategy makes of a recorded frame (Strategy::bars).
[[nodiscard]] Show barsShow(std::string id, std::string title);

/// A show as it is asked for on the command line: "--overlay kernel", or with a colouring "--map-colouring level".
[[nodiscard]] inline std::string commandLineOption(std::string_view id, std::string_view colouring = {}) {
    return colouring.empty() ? "--overlay " + std::string(id) : "--map-colouring " + std::string(colouring);
}

/// The ids of the overlays that no strategy declares, because all have them.
inline constexpr const char* kVerdictsOverlay = "verdicts";
inline constexpr const char* kBoxesOverlay = "boxes";
inline constexpr const char* kFrustumOverlay = "frustum";
inline constexpr const char* kSphericalModelOverlay = "spherical-model";

}  // namespace cullscope
