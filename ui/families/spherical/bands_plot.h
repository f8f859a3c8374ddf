#pragma once

#include "ui/families/spherical/shown_map.h"
#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// A plot of the decision on an object's contour bands: sizes (S, or the slope) of the drawn and hidden bands over α, the largest
/// size of the nearer bands as a step line, and the angle beyond which no band is drawn. It shows one sector about the axis, or
/// all sectors together. The step line is omitted for all sectors, because each sector is compared with its own bands only.
class BandsPlot : public PlotWidget {
    Q_OBJECT

public:
    /// A plotted band. Angles are in radians.
    struct Band {
        double from = 0.0, to = 0.0;
        double drawn = 0.0;   ///< largest size of its drawn sectors; 0: there are none, or all of them are empty
        double hidden = 0.0;  ///< largest size of its hidden sectors
        double horizon = 0.0;
        bool anyDrawn = false, anyHidden = false;
    };

    explicit BandsPlot(QWidget* parent = nullptr);

    /// Sets the shown map; without bands the plot is empty.
    void setShown(const ShownMap& shown);
    /// Sets the reason why setShown() was given an empty map.
    void setAbsence(MapAbsence absence);
    /// Sets the sector, from 0; none: all sectors together, with their largest sizes.
    void setSector(const std::optional<uint32_t>& sector);
    [[nodiscard]] const std::optional<uint32_t>& sector() const { return m_sector; }

    [[nodiscard]] std::vector<Band> bands() const;
    /// The α in radians beyond which no band is drawn; none: no hidden band lies beyond the last drawn one.
    [[nodiscard]] std::optional<double> cut() const;
    /// The tooltip for the band at a position in the widget; empty: no band is there.
    [[nodiscard]] QString wordsAt(const QPointF& place) const;
    /// The position of α (radians) and a size in the widget.
    [[nodiscard]] QPointF placeOf(double alpha, double size) const;

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_shown.empty() || !m_shown.decision().bands; }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString emptySentence() const override;
    [[nodiscard]] QString description() const override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] const spherical::ContourBands& contourBands() const { return *m_shown.decision().bands; }
    [[nodiscard]] QString sizeName() const;
    [[nodiscard]] QString caption() const;
    [[nodiscard]] QString bandWords(const Band& band) const;
    void addBars(LinePlot& plot, const QPalette& palette) const;
    void addHorizon(LinePlot& plot, const PlotColours& colours) const;
    void addAngles(LinePlot& plot, const PlotColours& colours) const;

    ShownMap m_shown;
    MapAbsence m_absence = MapAbsence::NoMaps;
    std::optional<uint32_t> m_sector;
};

/// The sector, from 0, that is drawn up to the largest α before its hidden rest begins. The first one of several; 0 if no sector
/// has a hidden rest.
[[nodiscard]] uint32_t farthestCutSector(const spherical::ContourBands& bands);

}  // namespace cullscope::ui
