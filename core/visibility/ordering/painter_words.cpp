#include "core/visibility/ordering/painter_words.h"

#include "core/base/message.h"

namespace cullscope::ordering {

ToldTest toldTest(const NewellStep& step) {
    const bool passed = step.kind == NewellStep::Kind::Compared;
    switch (step.test) {
        case NewellTest::Depth:
            return {PainterLine::Candidates,
                    passed
                        ? CULLSCOPE_TR("The farthest depth %4 of triangle %2 does not exceed the nearest depth %3 of triangle "
                                       "%1: it lies nearer, and so do all after it.")
                        : CULLSCOPE_TR("The farthest depth %4 of triangle %2 exceeds the nearest depth %3 of triangle %1: they "
                                       "overlap in depth.")};
        case NewellTest::ExtentX:
            return {PainterLine::Extents,
                    passed ? CULLSCOPE_TR("Test 1: in x triangle %1 ends at pixel %3 and triangle %2 at %4: they are apart.")
                           : CULLSCOPE_TR("Test 1: in x both triangles %1 and %2 have the pixels from %3 to %4: not apart.")};
        case NewellTest::ExtentY:
            return {PainterLine::Extents,
                    passed ? CULLSCOPE_TR("Test 2: in y triangle %1 ends at pixel %3 and triangle %2 at %4: they are apart.")
                           : CULLSCOPE_TR("Test 2: in y both triangles %1 and %2 have the pixels from %3 to %4: not apart.")};
        case NewellTest::BehindQ:
            return {PainterLine::Behind,
                    passed
                        ? CULLSCOPE_TR("Test 3: triangle %1 reaches %3 before the plane of triangle %2, seen from the eye, and "
                                       "%4 behind it: it lies wholly behind.")
                        : CULLSCOPE_TR("Test 3: triangle %1 reaches %3 before the plane of triangle %2, seen from the eye, and "
                                       "%4 behind it: it does not lie wholly behind.")};
        case NewellTest::BeforeP:
            return {PainterLine::Before,
                    passed
                        ? CULLSCOPE_TR("Test 4: triangle %2 reaches %3 before the plane of triangle %1, seen from the eye, and "
                                       "%4 behind it: it lies wholly before.")
                        : CULLSCOPE_TR("Test 4: triangle %2 reaches %3 before the plane of triangle %1, seen from the eye, and "
                                       "%4 behind it: it does not lie wholly before.")};
        case NewellTest::Swap:
            return {PainterLine::Swap, CULLSCOPE_TR("No test lets triangle %1, with the farthest depth %3, come before triangle "
                                                    "%2, with %4: the second one is taken first.")};
        case NewellTest::Cycle:
            return {PainterLine::Cut,
                    CULLSCOPE_TR("Triangle %1, with the farthest depth %3, waits for triangle %2, with %4, which "
                                 "is marked: a cycle, in which one is cut.")};
        case NewellTest::Pierce:
            return {PainterLine::Cut,
                    CULLSCOPE_TR("Triangles %1 and %2 pass through each other: 1 / depth of the first less that "
                                 "of the second goes from %3 to %4. One of them is cut.")};
        default:
            break;
    }
    if (step.byDepth)
        return {PainterLine::Projections,
                passed ? CULLSCOPE_TR("Test 5: where the projections of triangles %1 and %2 overlap, 1 / depth of the first less "
                                      "that of the second goes from %3 to %4: it is nowhere nearer.")
                       : CULLSCOPE_TR("Test 5: where the projections of triangles %1 and %2 overlap, 1 / depth of the first less "
                                      "that of the second goes from %3 to %4: it is nearer somewhere.")};
    return {PainterLine::Projections,
            passed
                ? CULLSCOPE_TR("Test 5: the projections of triangles %1 and %2 overlap by %3 pixels, not by more than %4: they "
                               "count as apart.")
                : CULLSCOPE_TR("Test 5: the projections of triangles %1 and %2 overlap by %3 pixels, by more than %4: not "
                               "apart.")};
}

const char* toldDrawn(NewellStep::Cause cause, bool whole) {
    switch (cause) {
        case NewellStep::Cause::NoSamples:
            return whole ? CULLSCOPE_TR("Triangle %2 covers no sample and is compared with none: it is drawn.")
                         : CULLSCOPE_TR("Triangle %2 covers no sample and is compared with none: %1 of its area is drawn.");
        case NewellStep::Cause::ByCentroid:
            // Nothing is cut by this order.
            return CULLSCOPE_TR(
                "The centroid of triangle %2, at the distance %3, is the farthest one left: it is drawn without a test.");
        case NewellStep::Cause::GivenUp:
            return whole ? CULLSCOPE_TR(
                               "Because of rounding alone triangle %2 still waits for others, and none of them can be cut: it "
                               "is drawn all the same.")
                         : CULLSCOPE_TR(
                               "Because of rounding alone triangle %2 still waits for others, and none of them can be cut: %1 of "
                               "its area is drawn all the same.");
        case NewellStep::Cause::Free:
            break;
    }
    return whole ? CULLSCOPE_TR("Nothing is left that has to come before: triangle %2 is drawn.")
                 : CULLSCOPE_TR("Nothing is left that has to come before: %1 of the area of triangle %2 is drawn.");
}

}  // namespace cullscope::ordering
