#pragma once

#include "ui/families/family_pages.h"
#include "ui/families/spherical/bands_panel.h"
#include "ui/families/spherical/map_panel.h"

namespace cullscope::ui {

/// The index map above the tabs and the contour bands in a tab. The map marks the sector that the bands' plot shows.
class SphericalPages : public FamilyPages {
    Q_OBJECT

public:
    SphericalPages(Session& session, SnapshotReader& reader, QWidget* panel, QTabWidget* tabs);

    [[nodiscard]] QWidget* top() const override { return m_map; }
    [[nodiscard]] QWidget* page() const override { return m_bands; }
    [[nodiscard]] QString pageName() const override { return BandsPanel::tr("Bands"); }
    void setCurrent(const QWidget* page) override;

private:
    void markSector();

    MapPanel* m_map;
    BandsPanel* m_bands;
    bool m_bandsShown = false;
};

}  // namespace cullscope::ui
