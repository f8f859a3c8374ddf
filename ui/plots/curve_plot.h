#pragma once

#include <optional>

#include "core/frame/curve.h"
#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// A plot of a curve that a strategy declares, with words about the place under the pointer.
class CurvePlot : public PlotWidget {
    Q_OBJECT

public:
    explicit CurvePlot(QWidget* parent = nullptr);

    /// None, or a curve that says why it is empty: the plot shows a sentence.
    void setCurve(std::optional<Curve> curve);
    [[nodiscard]] const std::optional<Curve>& curve() const { return m_curve; }
    /// What it is called while there is no curve.
    void setName(const QString& name) { m_name = name; }
    /// The sentence where there is no curve.
    void setAbsence(const QString& sentence);

    /// Without its areas in the legend.
    void setBrief();
    /// Marks the values between two values of x; none: marks nothing.
    void setInHand(const std::optional<Vec2>& values);
    [[nodiscard]] const std::optional<Vec2>& inHand() const { return m_inHand; }

    /// The tooltip for a position in the widget; empty: there is none.
    [[nodiscard]] QString wordsAt(const QPointF& place) const;
    /// The position of two values in the widget.
    [[nodiscard]] QPointF placeOf(double x, double y) const;

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return !m_curve || m_curve->empty(); }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString emptySentence() const override;
    [[nodiscard]] QString description() const override;
    bool event(QEvent* event) override;

private:
    void addUprights(LinePlot& plot, const QPalette& palette) const;
    void addInHand(LinePlot& plot) const;

    std::optional<Curve> m_curve;
    std::optional<Vec2> m_inHand;
    QString m_name, m_absence;
    bool m_brief = false;
};

}  // namespace cullscope::ui
