#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/measure/frame_measurement.h"

namespace cullscope {

/// A figure by which the literature states the errors of culling over a path: docs/measuring.md, "The field's figures".
struct FieldFigure {
    const char* key;           ///< field in files
    const char* title;         ///< English, marked for translation, with the unit
    int decimals = 0;          ///< digits after the point on screen
    double scale = 1.0;        ///< factor on screen
    const char* meaning = "";  ///< English, marked for translation: what is counted, and of what
};
[[nodiscard]] std::span<const FieldFigure> fieldFigures();
/// The place of the figure with a key among fieldFigures(), which has it.
[[nodiscard]] size_t fieldFigurePlace(std::string_view key);

/// Estimates by fieldFigures(); a figure is missing where nothing was counted that it could be a share of. The intervals are
/// bootstraps over the views (percentile method, 2000 resamples, fixed seed). Zero has none (of n views without a loss, "< 3/n"
/// is what can be said), nor have a single view and the largest of the views.
using FieldEstimates = std::vector<std::optional<RatioEstimate>>;

/// Of the frames of a path in their order; empty where they were not judged.
[[nodiscard]] FieldEstimates fieldEstimates(std::span<const FrameMeasurement> frames);

/// Counts what the figures need of one picture: objects, pixels and the outline. `given`: the triangles that were drawn.
void countForFieldFigures(Accuracy& accuracy, const Reference& reference, const ShownPixels& shown,
                          const TriangleIntervals& given, const Scene& scene);

/// "0 (< 3/n)" of a rate: in n views there was no loss, so that it is below 3/n with 95 % confidence (the rule of three). Of up
/// to three views that says nothing (boundSaysSomething): "0 of n".
[[nodiscard]] Message noLossIn(size_t views);
[[nodiscard]] constexpr bool boundSaysSomething(size_t views) { return views > 3; }

/// How many frames lost a pixel.
[[nodiscard]] size_t framesWithLoss(std::span<const FrameMeasurement> frames);

/// An object that loses pixels in consecutive frames: it is missing, wholly or in part, from the first of them on.
struct PoppingEvent {
    uint32_t instance = 0;
    size_t first = 0;     ///< frame
    size_t frames = 0;    ///< how long it lasts
    uint64_t pixels = 0;  ///< the most that it loses in one frame
};
/// By first frame, then by instance.
[[nodiscard]] std::vector<PoppingEvent> poppingEvents(std::span<const FrameMeasurement> frames);

/// The differences of two pictures of the same size (RGBA, a byte a channel): by the sum of a pixel's differences in red, green
/// and blue, 0 to 765, how many pixels have it. The mean of that sum ÷ 765 is the mean error of OpenImageIO's `compare`.
[[nodiscard]] std::vector<uint32_t> pictureDifferences(std::span<const uint8_t> one, std::span<const uint8_t> other);
/// The mean difference, 0 to 1, and the least that a share of the pixels does not exceed; 0 of no pixels.
[[nodiscard]] double meanDifference(std::span<const uint32_t> differences);
[[nodiscard]] double differenceQuantile(std::span<const uint32_t> differences, double share);

/// The shaded picture of a frame beside that of everything under the reference's facing rule, both drawn into `target`.
[[nodiscard]] std::vector<uint32_t> pictureDifferences(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log,
                                                       const Reference& reference, Framebuffer& target);

}  // namespace cullscope
