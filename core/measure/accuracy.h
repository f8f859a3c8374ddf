#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/measure/reference.h"

namespace cullscope {

/// The errors of a strategy's picture against a reference with the same facing rule.
struct Accuracy {
    uint64_t coveredPixels = 0;             ///< of the reference
    uint64_t missedPixels = 0;              ///< the reference shows a surface, the picture a farther one or none
    uint64_t extraPixels = 0;               ///< the picture shows a nearer surface than the reference
    uint64_t unresolvedPixels = 0;          ///< neither: another triangle, at a depth that a float does not tell apart
    uint64_t largestHolePixels = 0;         ///< largest 4-connected set of missed pixels; in a JudgedFrame: of lost ones
    uint64_t visibleTriangles = 0;          ///< |V|
    uint64_t submittedTriangles = 0;        ///< |S|, each counted once
    uint64_t falselyCulledTriangles = 0;    ///< |V∖S|
    uint64_t needlesslyDrawnTriangles = 0;  ///< |S∖V|

    uint64_t pixels = 0;                  ///< of the picture
    uint64_t sceneTriangles = 0;          ///< of the scene
    uint64_t sceneObjects = 0;            ///< of the scene, that have triangles
    uint64_t visibleObjects = 0;          ///< of which a triangle is visible
    uint64_t submittedObjects = 0;        ///< of which a triangle was drawn
    uint64_t falselyCulledObjects = 0;    ///< visible, and none of it drawn
    uint64_t needlesslyDrawnObjects = 0;  ///< drawn, and none of it visible
    uint64_t outlinePixels = 0;           ///< covered by the reference, with a neighbour to one side that is not
    uint64_t differentlyCovered = 0;      ///< pixels that one of reference and picture covers, and the other does not

    [[nodiscard]] double missedPixelRate() const {
        return coveredPixels == 0 ? 0.0 : double(missedPixels) / double(coveredPixels);
    }
};

/// Of a depth: two units in the last place of a float, within which two surfaces are not told apart.
constexpr double kTwoRoundings = 0x1p-22;

/// What a depth sample of a picture is beside that of the truth.
enum class PixelDifference : uint8_t {
    None,
    Unresolved,  ///< another triangle within two units in the last place of a float: either could be in front
    Extra,       ///< the picture shows a nearer surface
    Missed       ///< the picture shows a farther surface, or none
};
[[nodiscard]] inline PixelDifference pixelDifference(float truth, float depth) {
    return depth < truth ? PixelDifference::Missed : depth > truth ? PixelDifference::Extra : PixelDifference::None;
}

/// What a frame shows at every pixel of its culling view, rows from the bottom.
struct ShownPixels {
    std::vector<float> depth;        ///< reversed
    std::vector<uint32_t> triangle;  ///< scene triangle number + 1, where the frame has other surfaces than the scene's, whose
                                     ///< depths may be rounded otherwise; else empty, and the depth alone tells
    /// Set where the frame is compared by object (FrameLog::grain): the scene whose objects they are. Then a pixel that shows the
    /// object that is truly there is right, whichever of its surfaces that is.
    ScenePointer objects{};
};
/// The same by a replay of the log, into `target`, which has the culling view's size.
[[nodiscard]] ShownPixels shownPixels(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, Framebuffer& target);

/// What a pixel shows beside the truth: the same triangle is no difference, and another one of an unresolved depth none that
/// counts. Where the frame shows the scene's own surfaces by OpenGL, its depths have the reference's bits, and every difference
/// counts.
[[nodiscard]] PixelDifference pixelDifference(const Reference& reference, const ShownPixels& shown, size_t pixel);
/// The same of a surface beside the true one (`should`), where the frame shows others than the scene's own: depths, and scene
/// triangle numbers + 1, 0 where there is nothing.
[[nodiscard]] PixelDifference pixelDifference(float truth, uint32_t should, float depth, uint32_t is);

/// Compares what a frame of the scene shows with the truth for its culling view; `drawn` is what it drew (drawnTriangles). By
/// object, an object of which anything was drawn has lost no triangle, and in vain are those drawn for an object that is not
/// seen.
[[nodiscard]] Accuracy compare(const Reference& reference, const ShownPixels& shown, const DrawList& drawn, const Scene& scene);

/// The number of missed pixels that the raster's snapping to 1/256 pixel does not explain. It explains a missed pixel whose
/// centre lies within 1/64 pixel of an edge of the reference's triangle, or where the picture's surface lies behind that triangle
/// by at most the depth change over 1/128 pixel or two units in the last place of a float (unresolved). Where the picture's
/// triangle is known, one within 1/64 pixel of its edges is explained, too, and one where the planes of both triangles, in
/// double, meet within 1/128 pixel of the centre or are unresolved there, or where the picture's is the nearer one: OpenGL's
/// floats may misplace the depth of a sliver thousands of pixels long by much more than a rounding, in the reference as well.
/// `backface` promises 0 for a closed mesh without pockets that are inside out, seen from outside.
[[nodiscard]] uint64_t missedBeyondSnapping(const Reference& reference, const ShownPixels& shown, const Scene& scene,
                                            const View& view);
/// Those pixels, ascending, rows from the bottom. `tile`: the part of the picture that reference and picture are of; left out:
/// all of it.
[[nodiscard]] std::vector<uint32_t> pixelsMissedBeyondSnapping(const Reference& reference, const ShownPixels& shown,
                                                               const Scene& scene, const View& view,
                                                               const std::optional<PictureTile>& tile = {});
/// The same of a log's picture in a tile. Where anything is left to explain, it is drawn once more to know its triangles, too,
/// and a centre within 1/64 pixel of an edge of a part that the frame drew of the reference's triangle is explained.
[[nodiscard]] std::vector<uint32_t> pixelsMissedBeyondSnapping(Renderer& renderer, const SceneBuffers& buffers,
                                                               const FrameLog& log, const Reference& reference,
                                                               const ShownPixels& shown, const PictureTile& tile);
/// The scene triangles that a reference shows at pixels, ascending, each once.
[[nodiscard]] std::vector<uint32_t> trianglesAt(const Reference& reference, const std::vector<uint32_t>& pixels);

/// An object of the scene with missed pixels.
struct LostObject {
    uint32_t instance = 0;
    uint64_t pixels = 0;
};

/// A 4-connected set of missed pixels.
struct Hole {
    int x = 0, y = 0;  ///< one of its pixels, rows from the bottom
    uint64_t pixels = 0;
};
/// All holes of a mask, largest first; holes of equal size by their lowest, then leftmost pixel.
[[nodiscard]] std::vector<Hole> holes(std::vector<uint8_t> mask, const Viewport& size);

/// A frame beside the truth.
struct JudgedFrame {
    ShownPixels shown;
    Accuracy accuracy;
    bool ownRaster = false;  ///< the frame shows other surfaces than the scene's, or in an order of its own
    /// Set where a missed pixel may be the raster's doing: with `ownRaster`, or where the reference has another facing rule than
    /// the frame. Then it is these pixels that are lost.
    std::optional<uint64_t> missedBeyondSnapping;
    std::optional<uint64_t> extraBeyondSnapping{};         ///< likewise, of extra pixels: set with `ownRaster`
    std::optional<std::vector<uint32_t>> lostTriangles{};  ///< with it: those that the truth shows there, ascending
    std::vector<uint32_t> lost{};                          ///< the pixels that are lost, ascending, rows from the bottom

    [[nodiscard]] uint64_t lostPixels() const { return missedBeyondSnapping.value_or(accuracy.missedPixels); }
    /// The holes of the lost pixels in a picture of that size, largest first.
    [[nodiscard]] std::vector<Hole> holes(const Viewport& size) const;
};
/// Judges what a frame showed by a replay of its log, into `target`, which has the culling view's size: for the tables, for the
/// desktop's views and for cullbench.
[[nodiscard]] JudgedFrame judge(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, const Reference& reference,
                                Framebuffer& target);

/// Whether a missed pixel of a frame may be the raster's doing (JudgedFrame::missedBeyondSnapping), beside a truth of that rule.
[[nodiscard]] bool snappingMayExplain(const FrameLog& log, Facing truth);

/// The states of a frame's triangles beside the truth for its culling view, which is drawn here: those of the desktop's colours
/// by verdict, for other pictures.
[[nodiscard]] TriangleStates judgedStates(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log, Facing truth);

/// The number of extra pixels that snapping does not explain. It explains one where the centre lies near an edge of one of both
/// triangles, or the one that the picture shows lies before the truth by at most the depth change over 1/128 pixel, or their
/// planes meet there. Of frames that have triangle numbers.
[[nodiscard]] uint64_t extraBeyondSnapping(const Reference& reference, const ShownPixels& shown, const Scene& scene,
                                           const View& view);

/// A mask of the missed pixels (1: missed), rows from the bottom.
[[nodiscard]] std::vector<uint8_t> missedMask(const Reference& reference, const ShownPixels& shown);

/// The objects that the reference shows at those pixels, most pixels first, then by number.
[[nodiscard]] std::vector<LostObject> lostObjects(const Scene& scene, const Reference& reference,
                                                  const std::vector<uint32_t>& pixels);

}  // namespace cullscope
