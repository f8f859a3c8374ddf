#pragma once

#include <QMainWindow>
#include <QSettings>
#include <optional>

namespace cullscope::ui {

/// How the window was left: its place, its docks and toolbars, the arrangement and the number of views, and the folder that
/// dialogs begin in. Kept from start to start; what an older version with other panels left is not used.
class WindowMemory {
public:
    struct Layout {
        QString arrangement;  ///< the window's id for it
        int viewCount = 0;

        bool operator==(const Layout&) const = default;
    };

    /// Takes the docks as they are now for the layout that reset() goes back to: make it when all are made. Each dock and
    /// toolbar needs an object name.
    explicit WindowMemory(QMainWindow& window);

    void save(const Layout& layout);
    /// Gives the window its place and docks back. None: nothing was kept, and the window is as it was.
    [[nodiscard]] std::optional<Layout> restore();
    /// The docks as at the first start, and nothing kept. The window's place stays.
    void reset();

private:
    QMainWindow& m_window;
    QByteArray m_first;
    QSettings m_settings;
};

}  // namespace cullscope::ui
