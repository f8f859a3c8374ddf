#include "core/visibility/spherical/listings.h"

#include "core/base/message.h"

namespace cullscope::spherical {

BandsLine lineOfBands(const SphericalDecision& decision) {
    if (decision.relation == SphereRelation::AroundEye) return BandsLine::Whole;
    return decision.bands ? BandsLine::Draw : BandsLine::Boxes;
}

BandsLine lineOfHorizon(const SphericalDecision& decision) { return decision.bands ? BandsLine::Slopes : BandsLine::Whole; }

Show bandsListing() {
    return listingShow({{CULLSCOPE_TR("for each object"), 0},
                        {CULLSCOPE_TR("its sphere against six planes"), 1},
                        {CULLSCOPE_TR("outside: leave it out"), 1},
                        {CULLSCOPE_TR("around the eye, flat: draw all"), 1},
                        {CULLSCOPE_TR("cut: follow four corner rays"), 1},
                        {CULLSCOPE_TR("cell by cell: a triangle hit?"), 2},
                        {CULLSCOPE_TR("any hit: region between them"), 2},
                        {CULLSCOPE_TR("draw boxes of cells around it"), 2},
                        {CULLSCOPE_TR("else bands: S > S before it?"), 1},
                        {CULLSCOPE_TR("yes, or the near half: draw it"), 2}});
}

Show horizonListing() {
    return listingShow({{CULLSCOPE_TR("for each object"), 0},
                        {CULLSCOPE_TR("its sphere against six planes"), 1},
                        {CULLSCOPE_TR("outside: leave it out"), 1},
                        {CULLSCOPE_TR("cut by near, flat, small: draw all"), 1},
                        {CULLSCOPE_TR("else draw cells above the horizon"), 1}});
}

WalkLine lineOfCell(const std::optional<Cause>& cause) {
    if (!cause) return WalkLine::Draw;
    return *cause == Cause::BackFacing ? WalkLine::Cones : *cause == Cause::Hidden ? WalkLine::Horizon : WalkLine::Planes;
}

Show walkListing() {
    return listingShow({{CULLSCOPE_TR("test groups, objects by planes"), 0},
                        {CULLSCOPE_TR("outside: leave it all out"), 1},
                        {CULLSCOPE_TR("each other object (small: draw)"), 0},
                        {CULLSCOPE_TR("sphere outside: leave it out"), 1},
                        {CULLSCOPE_TR("walk(cell); if open, its parts"), 1},
                        {CULLSCOPE_TR("box outside: leave it out"), 2},
                        {CULLSCOPE_TR("faces away: leave it out"), 2},
                        {CULLSCOPE_TR("behind horizon: leave it out"), 2},
                        {CULLSCOPE_TR("no test open, leaf, gap: draw"), 2},
                        {CULLSCOPE_TR("few pixels: triangle by triangle"), 1}});
}

std::vector<Show> withListing(std::vector<Show> shows, Show listing) {
    shows.push_back(std::move(listing));
    return shows;
}

}  // namespace cullscope::spherical
