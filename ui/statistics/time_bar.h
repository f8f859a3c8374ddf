#pragma once

#include <vector>

#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// The frame times of the strategies, culling and drawing: one bar per strategy, all on one scale.
class TimeBar : public PlotWidget {
    Q_OBJECT

public:
    struct Entry {
        QString label;
        double cullMilliseconds = 0.0;
        double drawMilliseconds = 0.0;
        bool baseline = false;
        [[nodiscard]] double frameMilliseconds() const { return cullMilliseconds + drawMilliseconds; }
    };

    explicit TimeBar(QWidget* parent = nullptr);

    void setEntries(std::vector<Entry> entries);
    [[nodiscard]] const std::vector<Entry>& entries() const { return m_entries; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_entries.empty(); }
    void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

protected:
    [[nodiscard]] QString description() const override;

private:
    /// The columns and heights of a row, computed from font and width.
    struct Columns {
        double labels = 0.0;   ///< width; 0: the label is above its bar
        double figures = 0.0;  ///< width
        double row = 0.0;      ///< height
        double legend = 0.0;   ///< height
    };
    [[nodiscard]] Columns columns(const QFontMetricsF& metrics, double width) const;
    [[nodiscard]] QString figuresOf(const Entry& entry, bool whole) const;
    void paintLegend(QPainter& painter, const QRectF& place, const PlotColours& colours) const;
    void paintRow(QPainter& painter, const QRectF& row, const Columns& columns, const Entry& entry,
                  const PlotColours& colours) const;

    std::vector<Entry> m_entries;
    double m_longest = 0.0;  ///< longest frame time, ms
};

}  // namespace cullscope::ui
