#pragma once

#include <optional>
#include <set>

#include "ui/jobs/picture_tiles.h"
#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// A picture of any size up to 16384 × 16384, drawn tile by tile on the thread whose context is current, with triangle states,
/// depths and triangle numbers at exactly this size. Throws what core throws.
class TiledPicture {
public:
    struct Wanted {
        bool truth = false;  ///< compute the states of all triangles against the truth at the culling camera's size
        bool items = false;  ///< store depth and triangle number of every pixel
        int reach = 2;       ///< radius of the marks around differing pixels, in pixels
    };
    struct Result {
        std::shared_ptr<const ViewPicture> picture;
        TriangleStatesPointer states;    ///< null: the picture is not coloured by verdict
        std::vector<float> depth;        ///< forward distances, infinity for background; empty unless wanted
        std::vector<uint32_t> triangle;  ///< triangle number + 1, 0 for background; empty unless wanted
    };

    TiledPicture(ViewRequest request, const Wanted& wanted);

    /// The number of calls of drawNext() that the picture takes.
    [[nodiscard]] size_t steps() const;
    /// Draws one tile; returns false if it was the last one.
    bool drawNext(FramesBeside& frames, Renderer& renderer);
    [[nodiscard]] Result take();

private:
    void findVisible(Renderer& renderer, const PictureTile& tile);
    void finishTruth();
    void drawItems(Renderer& renderer, const PictureTile& tile);

    ViewRequest m_request;
    Wanted m_wanted;
    std::vector<PictureTile> m_cullingTiles, m_tiles;  ///< tiles of the truth, and of the picture
    size_t m_step = 0;
    std::vector<bool> m_visible;  ///< by scene triangle
    std::set<uint32_t> m_lost;    ///< triangles with a lost pixel, where snapping may explain missed ones
    ViewFramePointer m_frame;
    std::optional<PictureDrawing> m_drawing;
    Result m_result;
};

}  // namespace cullscope::ui
