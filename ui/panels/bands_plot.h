#pragma once

#include "ui/panels/shown_map.h"
#include "ui/statistics/plot_widget.h"

namespace cullscope::ui {

/// What the contour bands of an object decided: size (S, or the slope) over α, drawn and hidden bands, the largest size nearer as
/// a step line, and beyond which angle nothing is drawn. Of one sector about the axis; or of all of them together, then without
/// the largest nearer: each sector is compared with its own.
class BandsPlot : public PlotWidget {
    Q_OBJECT

public:
    /// One band as it is plotted. Angles in radians.
    struct Band {
        double from = 0.0, to = 0.0;
        double drawn = 0.0;   ///< the largest size of its drawn sectors; 0: none, or they are empty
        double hidden = 0.0;  ///< of its hidden ones
        double horizon = 0.0;
        bool anyDrawn = false, anyHidden = false;
    };

    explicit BandsPlot(QWidget* parent = nullptr);

    /// One without bands: the plot is empty.
    void setShown(const ShownMap& shown);
    /// Why there is no map, where setShown was given an empty one.
    void setAbsence(MapAbsence absence);
    /// From 0; none: all sectors together, of each the largest size.
    void setSector(const std::optional<uint32_t>& sector);
    [[nodiscard]] const std::optional<uint32_t>& sector() const { return m_sector; }

    [[nodiscard]] std::vector<Band> bands() const;
    /// Beyond this α nothing is drawn, in radians; none: something is drawn up to the end.
    [[nodiscard]] std::optional<double> cut() const;
    /// What is said about the band at a place; empty: there is none.
    [[nodiscard]] QString wordsAt(const QPointF& place) const;
    /// Where α (radians) and a size stand in the widget.
    [[nodiscard]] QPointF placeOf(double alpha, double size) const;

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_shown.empty() || !m_shown.decision().bands; }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString emptySentence() const override;
    [[nodiscard]] QString description() const override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] const ContourBands& contourBands() const { return *m_shown.decision().bands; }
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

/// The sector, from 0, of which something is drawn up to the largest α, of those where it ends before the hidden rest; the first
/// of several, and 0 where nothing is cut.
[[nodiscard]] uint32_t farthestCutSector(const ContourBands& bands);

}  // namespace cullscope::ui
