#pragma once

#include <optional>

#include "ui/jobs/picture_tiles.h"
#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// A picture of any size up to 16384 × 16384, drawn tile by tile on the thread whose context is current, with what is known of
/// it at that very size. Throws what core throws.
class TiledPicture {
public:
    struct Wanted {
        bool truth = false;  ///< the states of all triangles against the truth at the culling camera's size
        bool items = false;  ///< depth and triangle of every pixel
        int reach = 2;       ///< pixels that are marked around a differing one
    };
    struct Result {
        std::shared_ptr<const ViewPicture> picture;
        TriangleStatesPointer states;    ///< null: nothing is coloured by verdict
        std::vector<float> depth;        ///< forward distances, infinity for nothing; empty unless wanted
        std::vector<uint32_t> triangle;  ///< number + 1, 0 for nothing; empty unless wanted
    };

    TiledPicture(ViewRequest request, const Wanted& wanted);

    /// How many calls of drawNext it takes.
    [[nodiscard]] size_t steps() const;
    /// Draws one tile; false: that was the last one.
    bool drawNext(Renderer& renderer);
    [[nodiscard]] Result take();

private:
    void findVisible(Renderer& renderer, const PictureTile& tile);
    void finishTruth(Renderer& renderer);
    void drawItems(Renderer& renderer, const PictureTile& tile);

    ViewRequest m_request;
    Wanted m_wanted;
    std::vector<PictureTile> m_cullingTiles, m_tiles;  ///< of the truth, of the picture
    size_t m_step = 0;
    std::vector<bool> m_visible;  ///< by scene triangle
    std::optional<PictureDrawing> m_drawing;
    Result m_result;
};

}  // namespace cullscope::ui
