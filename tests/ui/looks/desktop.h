#pragma once

#include <gtest/gtest.h>

#include "tests/ui/looks/kept_picture.h"
#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// The desktop assembled as in the program, with a new home folder.
struct Desktop {
    struct Start {
        QSize size{1366, 768};
        QString language = QStringLiteral("en");
        Appearance::Mode appearance = Appearance::Mode::Light;
        std::vector<std::string> strategies{};  ///< empty: as without command line arguments
        QString scene{};                        ///< empty: the scene of the first start
        bool open = true;                       ///< false: opens no scene
    };

    /// As a start gives them.
    static Session::Options withUsualPictures() {
        Session::Options options = sessionOptions(true);
        options.pictureSize = Session::Options().pictureSize;
        return options;
    }

    explicit Desktop(const Start& start);
    Desktop();

    /// Waits until scene, strategies, pictures and metrics with their times are complete.
    void settle();
    [[nodiscard]] bool settled();
    /// A picture of the window, or of another window of the program, at a device pixel ratio of 1.
    [[nodiscard]] Look look(QWidget& window);
    [[nodiscard]] Look look() { return look(window); }
    /// The picture that a view shows, without overlays.
    [[nodiscard]] QImage scene(int view) { return session.picture(view)->colour; }
    [[nodiscard]] SceneView& view(int view) { return window.views().pane(view).picture(); }
    void drag(int view, const QPoint& way, Qt::MouseButton button = Qt::LeftButton);
    /// Changes a view's setup, as its menu does.
    void edit(int view, const std::function<void(ViewSetup&)>& change);

    Language language;
    Appearance appearance;
    Session session{withUsualPictures()};
    MainWindow window;
};

}  // namespace cullscope::ui
