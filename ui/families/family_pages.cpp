#include "ui/families/family_pages.h"

#include "ui/families/spherical/spherical_pages.h"

namespace cullscope::ui {

std::vector<FamilyPages*> makeFamilyPages(Session& session, SnapshotReader& reader, QWidget* panel, QTabWidget* tabs) {
    return {new SphericalPages(session, reader, panel, tabs)};
}

}  // namespace cullscope::ui
