#pragma once

#include <QDockWidget>
#include <functional>
#include <vector>

namespace cullscope::ui {

/// Docks that must not reduce the room of the views while many of them are compared: they then open floating over the views, and
/// are closed by the button that opened them or by Esc.
class FloatingDocks : public QObject {
    Q_OBJECT

public:
    /// Returns the rectangle of a floating dock from that of the views, both in pixels of the screen.
    using Place = std::function<QRect(const QRect& views)>;

    /// All docks belong to `window` and float over `views`.
    FloatingDocks(QWidget& window, QWidget& views);

    void add(QDockWidget& dock, Place place);
    /// Whether the docks are floating, open or closed.
    [[nodiscard]] bool floating() const { return m_floating; }
    /// True: floats all docks, closed. False: docks them again, open if they were open before.
    void setFloating(bool floating);
    /// Opens a floating dock without giving it the keyboard.
    static void showBeside(QDockWidget& dock);
    /// Takes over the state of docks that QMainWindow::restoreState restored; `floating`: they are floating.
    void adopt(bool floating);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Floating {
        QDockWidget* dock;
        Place place;
        Qt::DockWidgetAreas areas;  ///< the allowed areas while it is docked
        bool openBefore;
    };

    void setUp(const Floating& entry);
    void putInPlace(const Floating& entry);
    bool close();

    QWidget& m_window;
    QWidget& m_views;
    std::vector<Floating> m_docks;
    bool m_floating = false;
};

}  // namespace cullscope::ui
