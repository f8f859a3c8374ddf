#include "core/visibility/show.h"

namespace cullscope {

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
