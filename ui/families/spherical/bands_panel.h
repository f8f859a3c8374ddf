#pragma once

#include <QLabel>
#include <QSpinBox>

#include "ui/families/spherical/bands_plot.h"
#include "ui/plots/picture_menu.h"

namespace cullscope::ui {

/// A plot of the contour bands of the object whose map is shown, by size over α, of one sector or of all.
class BandsPanel : public QWidget {
    Q_OBJECT

public:
    BandsPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] BandsPlot& plot() { return *m_plot; }
    /// The field for the sector, from 1; 0: all sectors. Before the user chooses one it is the sector whose cut is farthest.
    [[nodiscard]] QSpinBox& sector() { return *m_sector; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }
    void showMap(const ShownMap& shown);

signals:
    /// The plot's sector, or the bands that it belongs to, changed.
    void sectorChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void chooseSector();
    void takeSector();
    void retranslate();
    /// Shows the range of the angle β about the axis that the chosen sector covers.
    void showAngles();

    Session& m_session;
    SnapshotReader& m_reader;
    QWidget* m_choices;
    QLabel* m_sectorLabel;
    QSpinBox* m_sector;
    QLabel* m_angles;
    BandsPlot* m_plot;
    PictureMenu* m_pictures;
    double m_sectorWidth = 0.0;  ///< radians; 0: the object has no bands
    bool m_chosen = false;       ///< the user has chosen the sector
};

}  // namespace cullscope::ui
