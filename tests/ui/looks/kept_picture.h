#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <QRect>
#include <QString>
#include <vector>

namespace cullscope::ui {

/// A picture of a window as it looks now.
struct Look {
    QImage picture;
    std::vector<QRect> masked;  ///< pixels that differ from run to run (times, and what is reckoned from them)
    std::vector<QRect> scenes;  ///< pixels that OpenGL drew: the same renderer draws them the same
    QString renderer;           ///< OpenGL's name for what drew them
};

/// Where pictures that differ from the kept ones are written.
[[nodiscard]] QString writtenPicturesFolder();

/// The picture with what is masked painted over.
[[nodiscard]] QImage withoutMasked(const QImage& picture, const std::vector<QRect>& masked);

/// Compares with tests/ui/looks/pictures/NAME.png, which holds the upper five bits of each channel: the scenes exactly where the
/// renderer is the one that drew the kept picture, all else up to 0.1 % of the pixels that differ by more than 24 in a channel. A
/// picture that differs is written to writtenPicturesFolder() beside one that marks where. With CULLSCOPE_RENEW_PICTURES=1 in the
/// environment the picture becomes the kept one.
[[nodiscard]] ::testing::AssertionResult looksAsKept(const Look& look, const QString& name);

}  // namespace cullscope::ui
