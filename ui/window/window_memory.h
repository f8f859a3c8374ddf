#pragma once

#include <QMainWindow>
#include <QSettings>
#include <optional>

namespace cullscope::ui {

/// Stores the window's state from start to start: geometry, docks and toolbars, arrangement, number of views, and the start
/// folder of dialogs. The state of an older version with other panels is ignored.
class WindowMemory {
public:
    struct Layout {
        QString arrangement;  ///< id of the window's arrangement
        int viewCount = 0;

        bool operator==(const Layout&) const = default;
    };

    /// Takes the present state of the docks as the layout that reset() restores: construct it after all docks. Each dock and
    /// toolbar needs an object name.
    explicit WindowMemory(QMainWindow& window);

    void save(const Layout& layout);
    /// Restores the window's geometry and docks. None: nothing is stored, and the window is unchanged.
    [[nodiscard]] std::optional<Layout> restore();
    /// The docks as at the first start, and nothing kept. The window's place stays.
    void reset();

private:
    QMainWindow& m_window;
    QByteArray m_first;
    QSettings m_settings;
};

}  // namespace cullscope::ui
