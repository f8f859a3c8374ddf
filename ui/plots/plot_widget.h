#pragma once

#include <QPainter>
#include <QWidget>

#include "core/image/plot_drawing.h"
#include "ui/plots/plot_colours.h"

namespace cullscope::ui {

/// A plot that looks the same in the window and in a file; where it has nothing to show, it says what to do.
class PlotWidget : public QWidget {
    Q_OBJECT

public:
    explicit PlotWidget(QWidget* parent = nullptr);

    /// While an experiment runs, an empty plot says so.
    void setMeasuring(bool measuring);
    /// The sentence where there is nothing to show, in place of that of the statistics' plots.
    void setEmptySentence(const QString& sentence);

    /// What it is, in the user's language: its accessible name and the title of what is exported.
    [[nodiscard]] virtual QString title() const = 0;
    [[nodiscard]] virtual bool empty() const = 0;
    /// What it shows if it is not empty, in the user's language, for core to lay out; several share the first one's legend. What
    /// is no plot over two axes has none, and overrides paintPlot and neededHeight.
    [[nodiscard]] virtual std::vector<LinePlot> plots(const QPalette& /*palette*/) const { return {}; }
    /// As the window shows it.
    [[nodiscard]] PlotDrawing drawing() const;
    /// Paints it, if it is not empty, on a ground that the caller has painted.
    virtual void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const;
    /// The height that it needs at a width, in pixels.
    [[nodiscard]] virtual int neededHeight(int width) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    /// Where it is empty: one sentence that says what to do.
    [[nodiscard]] virtual QString emptySentence() const;
    /// What it shows, in words, for who cannot see it.
    [[nodiscard]] virtual QString description() const = 0;
    /// To be called after its contents changed.
    virtual void contentsChanged();

private:
    bool m_measuring = false;
    QString m_emptySentence;  ///< null: that of the statistics' plots
};

}  // namespace cullscope::ui
