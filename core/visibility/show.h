#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/frame/flow_chart.h"
#include "core/frame/listing.h"
#include "core/geometry/types.h"
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

/// How files write whether something is shown: as `key` with one of two words, or with true or false where there are none.
struct ShowField {
    std::string key;  ///< empty: the show's id
    std::string off, on;
};

/// What lines of one colour mean in a picture.
struct ShowMeaning {
    std::string words;                                   ///< marked for translation
    Vec3f (*colour)(const Vec3f& background) = nullptr;  ///< of the lines over such a background

    bool operator==(const ShowMeaning&) const = default;
};

/// What can be shown of a recorded frame besides the drawn triangles. A strategy declares what it has in StrategyInfo::shows;
/// what every strategy has is in commonShows.
struct Show {
    /// In the order in which the command line and pictures' texts name what a picture shows.
    enum class Kind {
        Verdicts,      ///< the triangles in the colours of what became of them
        Wireframe,     ///< edges alone, without the surfaces between them: of the picture, never of the frame that is judged
        Ghost,         ///< all objects as ghosts, before which lies what was drawn; nothing with Verdicts, which show the rest
        Backs,         ///< the back sides of surfaces in a colour of their own; nothing with Verdicts
        Boxes,         ///< the boxes of the tree, over a view's picture. Declared by a strategy: its own form of them
        Frustum,       ///< the culling camera's frustum as lines, where another camera looks
        Overlay,       ///< lines over a view's picture
        DirectionMap,  ///< a map of directions, of one object (frame/cell_map.h), in place of the scene's picture and in the
                       ///< desktop's panel "Inside"
        Model,         ///< in place of the scene's picture: what was drawn of one object, in spherical coordinates
        Left,          ///< with Verdicts: what was not drawn, too
        Planes,        ///< with Boxes: they and the frustum in the colours of the planes that rejected them
                       ///< (StructureSnapshot::nodes). Declared by a strategy: the planes alone decide
        Tree,          ///< boxes with their decisions (StructureSnapshot), in the desktop's panel "Tree"
        Curve,         ///< values over an axis, of one object (frame/curve.h), in a tab of the desktop's panel "Inside"
        Listing,       ///< pseudo-code, whose lines the decisions name (Decision::line), in a tab of that panel
        Bars           ///< named counts (bars.h), in a tab of that panel
    };
    Kind kind = Kind::Overlay;
    std::string id;      ///< on the command line, in session files and in metadata
    std::string help;    ///< English, for the command line's help, of what it knows by its id; none of a Listing or Bars
    std::string title;   ///< of what a picture shows in a menu, of a Curve and Bars the tab, of a map in a sentence; marked for
                         ///< translation
    std::string action;  ///< the same with a marked key, in the window's menu; empty: it is in the views' menus alone
    std::string explanation;                ///< one sentence about it, marked for translation
    std::vector<TriangleState> legend;      ///< the states whose colours it uses
    std::vector<ShowMeaning> meanings{};    ///< of an Overlay and a strategy's own Boxes: what other colours mean, for legends
    AbsentShow absent = nullptr;            ///< never null for what cullbench draws: Overlay, DirectionMap
    std::vector<ShowColouring> colourings;  ///< of a DirectionMap: the first one is the default
    std::string colouringHelp;              ///< English, for the command line's help
    std::vector<ListingLine> lines;         ///< of a Listing: kMostListingLines at most
    FlowChart chart{};                      ///< of a Listing: the same as a flow chart; empty: there is none

    // Of what a view's picture shows or not.
    std::string key{};   ///< that switches it in the desktop; empty: none
    std::string icon{};  ///< in the desktop's toolbar; empty: it is not there
    bool byDefault = false;
    bool watching = false;  ///< a view that watches another one from outside shows it
    ShowField field{};      ///< in session files
    ShowField unusual{};    ///< the option of the command line, and the line in pictures' texts, for what is not as by default

    /// Whether it stands in place of what a camera sees.
    [[nodiscard]] bool inPlace() const { return kind == Kind::Model || kind == Kind::DirectionMap; }
    /// Whether it is lines over what a camera sees.
    [[nodiscard]] bool over() const { return kind == Kind::Boxes || kind == Kind::Frustum || kind == Kind::Overlay; }
    /// The kind without which it shows nothing; none: it does not depend on another.
    [[nodiscard]] std::optional<Kind> with() const;
};

/// What every strategy can show: the one place that names it. In the order of menus and session files, in which the overlays that
/// strategies declare come before the last one.
[[nodiscard]] const std::vector<Show>& commonShows();
/// The one of a kind, of which there is one.
[[nodiscard]] const Show& commonShow(Show::Kind kind);

/// A strategy's listing: lines that its code follows. A strategy has one at most.
[[nodiscard]] Show listingShow(std::vector<ListingLine> lines);
/// The boxes that a strategy tests (Strategy::snapshot).
[[nodiscard]] Show treeShow();
/// That a strategy decides by the six planes of the frustum alone.
[[nodiscard]] Show planesShow();
/// Counts that a strategy makes of a recorded frame (Strategy::bars).
[[nodiscard]] Show barsShow(std::string id, std::string title);

/// A show as it is asked for on the command line: "--overlay kernel", or with a colouring "--map-colouring level".
[[nodiscard]] inline std::string commandLineOption(std::string_view id, std::string_view colouring = {}) {
    return colouring.empty() ? "--overlay " + std::string(id) : "--map-colouring " + std::string(colouring);
}

/// The id of the boxes, of which a strategy may declare a form of its own.
inline constexpr const char* kBoxesShow = "boxes";

}  // namespace cullscope
