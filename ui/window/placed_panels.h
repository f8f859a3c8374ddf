#pragma once

#include <QObject>

#include "ui/session/snapshot_reader.h"
#include "ui/views/view_grid.h"
#include "ui/window/experiments.h"
#include "ui/window/view_menu.h"

namespace cullscope::ui {

/// Any panel can replace the picture of a view: makes the panels that the views' setups name, and removes them again.
class PlacedPanels : public QObject {
    Q_OBJECT

public:
    PlacedPanels(Session& session, ViewGrid& views, SnapshotReader& reader, Experiments& experiments, QObject* parent = nullptr);

    /// The panels that a view's menu offers.
    [[nodiscard]] static std::vector<PlaceablePanel> known();
    /// Makes the panel with that id; null: the id is unknown.
    [[nodiscard]] QWidget* make(const std::string& id) const;
    /// The panels for the strip below a picture, each about its own view.
    [[nodiscard]] static std::vector<PlaceablePanel> knownBelow();

private:
    void place();
    void placeBelow(int view);

    Session& m_session;
    ViewGrid& m_views;
    SnapshotReader& m_reader;
    Experiments& m_experiments;
};

}  // namespace cullscope::ui
