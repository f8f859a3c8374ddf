#pragma once

#include "ui/plots/map_painter.h"
#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// The map of directions of an object. Tooltips describe cells and marks. A click, or Enter at the keyboard cursor, chooses a
/// cell.
class MapWidget : public PlotWidget {
    Q_OBJECT

public:
    explicit MapWidget(QWidget* parent = nullptr);

    void setContents(const MapContents& contents);
    [[nodiscard]] const MapContents& contents() const { return m_painter.contents(); }
    void setColouring(const std::string& colouring);
    /// One line over the map, and nothing but its axes below.
    void setBrief();
    /// The height of all of it, as wide as this, brief or not; more is left empty.
    [[nodiscard]] int wholeHeight(int width) const;
    /// What a brief map leaves to another legend; none while there is no map.
    [[nodiscard]] std::vector<MapLegend::Entry> lines() const;
    [[nodiscard]] std::vector<TriangleState> states() const;
    [[nodiscard]] QString scaleWords() const { return empty() ? QString() : m_painter.scaleWords(); }
    /// The id of the shown colouring; empty: there is none.
    [[nodiscard]] std::string colouring() const { return m_painter.colouring(); }
    /// The cell of the keyboard cursor; none: it was not moved yet.
    [[nodiscard]] const std::optional<SphericalGrid::Cell>& cursor() const { return m_cursor; }

    [[nodiscard]] MapLayout layoutOfMap() const;
    /// The tooltip for a position; empty: there is none.
    [[nodiscard]] QString wordsAt(const QPointF& place) const;

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_painter.contents().shown.empty(); }
    void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

signals:
    void cellChosen(uint32_t number);

protected:
    [[nodiscard]] QString emptySentence() const override { return {}; }
    [[nodiscard]] QString description() const override;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void showWords(const QPointF& place, const QPoint& onScreen);
    void moveCursor(int rows, int columns);

    MapPainter m_painter;
    std::optional<SphericalGrid::Cell> m_cursor;
};

}  // namespace cullscope::ui
