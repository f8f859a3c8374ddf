#include "ui/families/family_pages.h"

#include "ui/families/spherical/spherical_pages.h"

namespace cullscope::ui {

std::vector<FamilyPages*> makeFamilyPages(Session& session, SnapshotReader& reader, QWidget* panel) {
    return {new SphericalPages(session, reader, panel)};
}

}  // namespace cullscope::ui
