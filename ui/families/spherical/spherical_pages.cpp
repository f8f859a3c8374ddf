#include "ui/families/spherical/spherical_pages.h"

namespace cullscope::ui {

SphericalPages::SphericalPages(Session& session, SnapshotReader& reader, QWidget* panel, QTabWidget* tabs)
    : m_map(new MapPanel(session, reader, panel)), m_bands(new BandsPanel(session, reader, tabs)) {
    // It lives as long as the map, which is deleted before the tabs.
    setParent(m_map);
    connect(m_bands, &BandsPanel::sectorChanged, this, &SphericalPages::markSector);
}

void SphericalPages::setCurrent(const QWidget* page) {
    m_bandsShown = page == m_bands;
    markSector();
}

void SphericalPages::markSector() {
    // The mark on the map belongs to the plot below it: while the plot is not shown, the mark would need an explanation.
    m_map->setSector(m_bandsShown ? m_bands->plot().sector() : std::nullopt);
}

}  // namespace cullscope::ui
