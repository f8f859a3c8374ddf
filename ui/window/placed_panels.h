#pragma once

#include <QObject>

#include "ui/session/snapshot_reader.h"
#include "ui/views/view_grid.h"
#include "ui/window/experiments.h"
#include "ui/window/view_menu.h"

namespace cullscope::ui {

/// Any panel can stand in a view's place: makes those that the views' setups name, and takes them away again.
class PlacedPanels : public QObject {
    Q_OBJECT

public:
    PlacedPanels(Session& session, ViewGrid& views, SnapshotReader& reader, Experiments& experiments, QObject* parent = nullptr);

    /// What a view's menu offers.
    [[nodiscard]] static std::vector<PlaceablePanel> known();
    /// Null for an id that there is none of.
    [[nodiscard]] QWidget* make(const std::string& id) const;

private:
    void place();

    Session& m_session;
    ViewGrid& m_views;
    SnapshotReader& m_reader;
    Experiments& m_experiments;
};

}  // namespace cullscope::ui
