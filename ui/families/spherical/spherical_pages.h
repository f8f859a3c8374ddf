#pragma once

#include "ui/families/family_pages.h"
#include "ui/families/spherical/map_panel.h"

namespace cullscope::ui {

/// The index map above the tabs. It marks the sector whose bands are shown below it.
class SphericalPages : public FamilyPages {
    Q_OBJECT

public:
    SphericalPages(Session& session, SnapshotReader& reader, QWidget* panel);

    [[nodiscard]] QWidget* top() const override { return m_map; }
    void setPart(const std::optional<uint32_t>& part) override;

private:
    MapPanel* m_map;
};

}  // namespace cullscope::ui
