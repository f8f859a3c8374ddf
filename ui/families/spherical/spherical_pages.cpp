#include "ui/families/spherical/spherical_pages.h"

namespace cullscope::ui {

SphericalPages::SphericalPages(Session& session, SnapshotReader& reader, QWidget* panel)
    : m_map(new MapPanel(session, reader, panel)) {
    setParent(m_map);
}

void SphericalPages::setPart(const std::optional<uint32_t>& part) {
    m_map->setSector(part ? std::optional(*part - 1) : std::nullopt);
}

}  // namespace cullscope::ui
