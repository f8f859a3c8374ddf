#pragma once

#include <gtest/gtest.h>

#include "tests/ui/looks/kept_picture.h"
#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// The desktop as the program puts it together, on a fresh home.
struct Desktop {
    struct Start {
        QSize size{1366, 768};
        QString language = QStringLiteral("en");
        Appearance::Mode appearance = Appearance::Mode::Light;
        std::vector<std::string> strategies{};  ///< empty: as without arguments
        QString scene{};                        ///< empty: the one of the first start
        bool open = true;                       ///< false: nothing was opened yet
    };

    explicit Desktop(const Start& start);
    Desktop();

    /// Waits until nothing moves any more: scene, strategies, pictures, figures and their times.
    void settle();
    [[nodiscard]] bool settled();
    /// The window, or another of the program's, at a device pixel ratio of 1.
    [[nodiscard]] Look look(QWidget& window);
    [[nodiscard]] Look look() { return look(window); }
    /// The picture that a view shows, without what is painted over it.
    [[nodiscard]] QImage scene(int view) { return session.picture(view)->colour; }
    [[nodiscard]] SceneView& view(int view) { return window.views().pane(view).picture(); }
    void drag(int view, const QPoint& way, Qt::MouseButton button = Qt::LeftButton);
    /// Changes what a view shows, as its menu does.
    void edit(int view, const std::function<void(ViewSetup&)>& change);

    Language language;
    Appearance appearance;
    Session session{sessionOptions(true)};
    MainWindow window;
};

}  // namespace cullscope::ui
