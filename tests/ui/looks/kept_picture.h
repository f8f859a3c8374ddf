#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <QRect>
#include <QString>
#include <QWidget>
#include <vector>

namespace cullscope::ui {

/// A picture of a window as it is displayed now.
struct Look {
    QImage picture;
    std::vector<QRect> masked;  ///< pixels that differ from run to run (times, and values computed from them)
    std::vector<QRect> scenes;  ///< pixels drawn by OpenGL, which are reproducible on the same renderer only
    QString renderer;           ///< OpenGL's name of the renderer
};

/// The folder to which differing pictures are written.
[[nodiscard]] QString writtenPicturesFolder();

/// Saves a picture of a widget there to look at, where that is asked for (CULLSCOPE_SAVE_LOOKS in the environment).
void keepToLookAt(QWidget& widget, const QString& name);

/// The picture with the masked rectangles painted over.
[[nodiscard]] QImage withoutMasked(const QImage& picture, const std::vector<QRect>& masked);

/// Compares a picture with tests/ui/looks/pictures/NAME.png, which stores the upper five bits of each channel. Scenes must be
/// equal if the renderer is that of the stored picture; elsewhere up to 0.1 % of the pixels may differ by more than 24 in a
/// channel. A differing picture is written to writtenPicturesFolder() together with one that marks the differences. With
/// CULLSCOPE_RENEW_PICTURES=1 in the environment the new picture replaces the stored one.
[[nodiscard]] ::testing::AssertionResult looksAsKept(const Look& look, const QString& name);

}  // namespace cullscope::ui
