#pragma once

#include <QDockWidget>
#include <functional>
#include <vector>

namespace cullscope::ui {

/// Docks that must take no room from the views while many of these are compared: then they open floating over the views, and
/// the button that opened them or Esc closes them.
class FloatingDocks : public QObject {
    Q_OBJECT

public:
    /// Where a dock floats over the views, both in pixels of the screen.
    using Place = std::function<QRect(const QRect& views)>;

    /// All of them are docks of `window` and float over `views`.
    FloatingDocks(QWidget& window, QWidget& views);

    void add(QDockWidget& dock, Place place);
    /// Whether they float now, open or not.
    [[nodiscard]] bool floating() const { return m_floating; }
    /// Floating begins with all of them closed; its end docks them again, as open as they were before.
    void setFloating(bool floating);
    /// Takes over docks that came back from an earlier start, as open as they are.
    void adopt(bool floating);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Floating {
        QDockWidget* dock;
        Place place;
        Qt::DockWidgetAreas areas;  ///< while it does not float
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
