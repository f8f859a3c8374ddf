#pragma once

#include <QWidget>

namespace cullscope::ui {

/// A bright disc over a window that follows the mouse pointer, so that an audience sees where a lecturer points. Mouse events
/// pass through it.
class PointerSpot : public QWidget {
    Q_OBJECT

public:
    explicit PointerSpot(QWidget* window);

    void setOn(bool on);
    [[nodiscard]] bool on() const { return m_on; }
    /// The middle of the disc, in the window.
    [[nodiscard]] QPoint place() const { return m_place; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void moveTo(const QPoint& place);

    QPoint m_place;
    bool m_on = false;
};

}  // namespace cullscope::ui
