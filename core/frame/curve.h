#pragma once

#include <optional>
#include <vector>

#include "core/frame/triangle_state.h"
#include "core/frame/words.h"
#include "core/geometry/types.h"

namespace cullscope {

/// An axis of a Curve.
struct CurveAxis {
    Words title;                     ///< empty: there is none
    double least = 0.0, most = 0.0;  ///< shown at least, where one is below the other; else only round numbers around the values
    bool zero = false;               ///< 0 is shown too
    double tickStep = 0.0;           ///< between ticks, from `least` to `most`; 0: at round numbers
    std::string unit{};              ///< behind the numbers of these ticks
};

/// Filled areas of one meaning, in the colour of a state.
struct CurveArea {
    struct Box {
        double left = 0.0, right = 0.0;
        double top = 0.0;  ///< from 0 upwards
    };
    Words name;
    TriangleState state = TriangleState::Visible;
    std::vector<Box> boxes;
};

/// A line that the areas are compared with.
struct CurveLine {
    Words name;
    std::vector<Vec2> points;
};

/// A line from the bottom to the top at a value of x.
struct CurveUpright {
    Words name;                ///< in the legend; empty: it is not in it
    std::optional<double> at;  ///< none: it is in the legend alone
    bool limit = false;        ///< stands out; else it only guides the eye
    Words label{};             ///< at its upper end
};

/// What is said of the values between two values of x.
struct CurveInterval {
    double from = 0.0, to = 0.0;
    std::vector<Words> words;
    bool empty = false;  ///< nothing lies there, so that it is left out where all are listed
};

/// The parts of an object that a Curve can show one at a time. They are numbered from 1; 0 is all of them together.
struct CurveParts {
    Words name;  ///< of the field in which one is chosen, with a marked key
    Words help;  ///< one sentence about it
    Words all;   ///< for 0
    uint32_t count = 0;
    uint32_t shown = 0;
    Words words{};  ///< about the shown one, beside the field; empty for 0
};

/// Values over an axis, of one object, as plain data: a kind of what strategies show (visibility/show.h). Texts are English,
/// marked for translation.
struct Curve {
    Words title;
    CurveAxis x, y;
    std::vector<CurveArea> areas{};
    std::vector<CurveLine> lines{};
    std::vector<CurveUpright> uprights{};
    std::vector<CurveInterval> intervals{};  ///< ascending, without gaps
    std::vector<Words> summary{};            ///< what it shows, in words
    std::optional<CurveParts> parts{};
    Words absence{};  ///< why this object has no curve; empty: it has one

    [[nodiscard]] bool empty() const { return !absence.empty(); }
    /// The interval of a value of x: of values beyond the first or the last one that one. Null: there are none.
    [[nodiscard]] const CurveInterval* intervalAt(double value) const;
};

/// What a curve shows of the values up to one of x.
[[nodiscard]] Curve curveUpTo(Curve curve, double x);

}  // namespace cullscope
