#pragma once

#include <QLabel>
#include <QSpinBox>

#include "ui/panels/bands_plot.h"
#include "ui/panels/picture_menu.h"

namespace cullscope::ui {

/// The contour bands of the object whose map is shown, by size over α, of one sector or of all.
class BandsPanel : public QWidget {
    Q_OBJECT

public:
    BandsPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] BandsPlot& plot() { return *m_plot; }
    /// 0: all sectors. Until one is chosen, the one whose cut is farthest.
    [[nodiscard]] QSpinBox& sector() { return *m_sector; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }
    void showMap(const ShownMap& shown);

signals:
    /// The plot's sector, or what it is a sector of.
    void sectorChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void chooseSector();
    void takeSector();
    void retranslate();
    /// Which angles about the axis the chosen sector has.
    void showAngles();

    Session& m_session;
    SnapshotReader& m_reader;
    QWidget* m_choices;
    QLabel* m_sectorLabel;
    QSpinBox* m_sector;
    QLabel* m_angles;
    BandsPlot* m_plot;
    PictureMenu* m_pictures;
    double m_sectorWidth = 0.0;  ///< radians; 0: there are no bands
    bool m_chosen = false;       ///< the sector, by the user
};

}  // namespace cullscope::ui
