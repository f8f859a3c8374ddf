#include "core/visibility/show.h"

#include <algorithm>

#include "core/base/message.h"

namespace cullscope {
namespace {

Show verdictsShow() {
    Show show;
    show.kind = Show::Kind::Verdicts;
    show.id = "verdicts";
    show.help = "colour by verdict, against the truth";
    show.title = CULLSCOPE_TR("Colours by verdict");
    show.action = CULLSCOPE_TR("Colours by &verdict");
    show.explanation = CULLSCOPE_TR("Colour the active view by what became of each triangle");
    show.legend = {TriangleState::Visible, TriangleState::InVain};
    show.key = "V";
    show.icon = "verdicts";
    show.watching = true;
    show.field = {"colouring", "shaded", "verdicts"};
    return show;
}

Show leftShow() {
    Show show;
    show.kind = Show::Kind::Left;
    show.id = "culled_too";
    show.title = CULLSCOPE_TR("With verdicts, what was left out too");
    show.legend = {TriangleState::OutsideFrustum, TriangleState::BackFacing, TriangleState::Hidden, TriangleState::TooSmall,
                   TriangleState::WronglyCulled};
    show.byDefault = true;
    show.watching = true;
    show.unusual = {"drawn_only", "true", {}};
    return show;
}

Show wireframeShow() {
    Show show;
    show.kind = Show::Kind::Wireframe;
    show.id = "wireframe";
    show.help = "the edges of triangles alone; figures stay those of the filled picture";
    show.title = CULLSCOPE_TR("Wireframe");
    show.action = CULLSCOPE_TR("W&ireframe");
    show.explanation = CULLSCOPE_TR("Show the edges of the drawn triangles alone; figures stay those of the filled picture");
    return show;
}

Show ghostShow() {
    Show show;
    show.kind = Show::Kind::Ghost;
    show.id = "ghost";
    show.help = "all objects as ghosts around what was drawn";
    show.title = CULLSCOPE_TR("Ghost of the whole objects");
    show.action = CULLSCOPE_TR("&Ghost of the whole objects");
    show.explanation = CULLSCOPE_TR("Show all objects as ghosts around what was drawn of them in the active view");
    return show;
}

Show backsShow() {
    Show show;
    show.kind = Show::Kind::Backs;
    show.id = "back-sides";
    show.help = "the back sides of surfaces in orange, so that a hollow is not taken for a body";
    show.title = CULLSCOPE_TR("Back sides in orange");
    show.action = CULLSCOPE_TR("Back si&des in orange");
    show.explanation =
        CULLSCOPE_TR("Show the back sides of surfaces in orange in the active view: what is hollow is not taken for a body");
    show.field = {"back_sides", {}, {}};
    return show;
}

Show frustumShow() {
    Show show;
    show.kind = Show::Kind::Frustum;
    show.id = "frustum";
    show.help = "of the culling camera";
    show.title = CULLSCOPE_TR("The culling camera's frustum");
    show.action = CULLSCOPE_TR("F&rustum");
    show.explanation = CULLSCOPE_TR("Show the culling camera's frustum in the active view");
    show.watching = true;
    return show;
}

Show boxesOfTree() {
    Show show;
    show.kind = Show::Kind::Boxes;
    show.id = kBoxesShow;
    show.help = "that the strategy tests";
    show.title = CULLSCOPE_TR("The boxes that were tested");
    show.action = CULLSCOPE_TR("&Boxes");
    show.explanation = CULLSCOPE_TR("Show the boxes that the strategy tested in the active view");
    show.legend = {TriangleState::Visible, TriangleState::OutsideFrustum};
    return show;
}

Show boxesByPlane() {
    Show show = planesShow();
    show.title = CULLSCOPE_TR("Boxes by the plane that rejected them");
    show.action = CULLSCOPE_TR("Boxes by rejecting &plane");
    show.explanation = CULLSCOPE_TR(
        "Show the boxes in the active view in the colour of the plane of the frustum that rejected them; the frustum's planes "
        "have the same colours");
    show.field = {"box_colouring", "verdict", "plane"};
    show.unusual = {"box_colouring", {}, "plane"};
    return show;
}

Show sphericalModelShow() {
    Show show;
    show.kind = Show::Kind::Model;
    show.id = "spherical-model";
    show.help = "what was drawn of the first object, over azimuth and zenith angle";
    show.title = CULLSCOPE_TR("Model in spherical coordinates");
    show.action = CULLSCOPE_TR("Model in &spherical coordinates");
    show.explanation = CULLSCOPE_TR("Show what was drawn of one object over azimuth and zenith angle in the active view");
    show.field = {"spherical_model", {}, {}};
    return show;
}

}  // namespace

std::optional<Show::Kind> Show::with() const {
    if (kind == Kind::Left) return Kind::Verdicts;
    return kind == Kind::Planes ? std::optional(Kind::Boxes) : std::nullopt;
}

const std::vector<Show>& commonShows() {
    static const std::vector<Show> kShows{verdictsShow(), leftShow(),    wireframeShow(), ghostShow(),         backsShow(),
                                          frustumShow(),  boxesOfTree(), boxesByPlane(),  sphericalModelShow()};
    return kShows;
}

const Show& commonShow(Show::Kind kind) { return *std::ranges::find(commonShows(), kind, &Show::kind); }

Show treeShow() {
    Show show;
    show.kind = Show::Kind::Tree;
    show.id = "tree";
    return show;
}

Show planesShow() {
    Show show;
    show.kind = Show::Kind::Planes;
    show.id = "planes";
    return show;
}

Show listingShow(std::vector<ListingLine> lines) {
    Show show;
    show.kind = Show::Kind::Listing;
    show.id = "listing";
    show.lines = std::move(lines);
    return show;
}

Show barsShow(std::string id, std::string title) {
    Show show;
    show.kind = Show::Kind::Bars;
    show.id = std::move(id);
    show.title = std::move(title);
    return show;
}

}  // namespace cullscope
