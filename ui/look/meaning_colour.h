#pragma once

#include <QColor>
#include <QPalette>

#include "core/visibility/show.h"

namespace cullscope::ui {

/// The colour that a legend explains, on the palette's base, as pictures have it. Never for text.
[[nodiscard]] inline QColor meaningColour(const ShowMeaning& meaning, const QPalette& palette) {
    const QColor base = palette.color(QPalette::Base);
    const Vec3f colour = meaning.colour(Vec3f(base.redF(), base.greenF(), base.blueF()));
    return QColor::fromRgbF(colour.x, colour.y, colour.z);
}

}  // namespace cullscope::ui
