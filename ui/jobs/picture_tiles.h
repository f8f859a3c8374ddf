#pragma once

#include <QImage>
#include <algorithm>
#include <vector>

#include "core/gpu/framebuffer.h"

namespace cullscope::ui {

/// The longest side of a tile, in pixels: limits the GPU memory, and a drawing can be stopped between two tiles.
inline constexpr int kMostTilePixels = 4096;

/// Splits a picture into tiles, row by row.
[[nodiscard]] inline std::vector<PictureTile> tilesOf(const Viewport& size) {
    std::vector<PictureTile> tiles;
    for (int y = 0; y < size.height; y += kMostTilePixels)
        for (int x = 0; x < size.width; x += kMostTilePixels)
            tiles.push_back({x, y, {std::min(kMostTilePixels, size.width - x), std::min(kMostTilePixels, size.height - y)}});
    return tiles;
}

/// Copies the rows of a tile to their place in the whole picture of `width` pixels; the rows of both start at the bottom.
template <typename Value>
void copyTile(const std::vector<Value>& from, const PictureTile& tile, std::vector<Value>& whole, int width) {
    for (int row = 0; row < tile.size.height; ++row)
        std::copy_n(from.begin() + std::ptrdiff_t(row) * tile.size.width, tile.size.width,
                    whole.begin() + std::ptrdiff_t(tile.y + row) * width + tile.x);
}

/// Does the same into an image of four bytes a pixel, whose rows start at the top.
inline void copyTile(const std::vector<uint8_t>& rgba, const PictureTile& tile, QImage& image) {
    const size_t rowBytes = 4 * size_t(tile.size.width);
    for (int row = 0; row < tile.size.height; ++row)
        std::copy_n(rgba.begin() + std::ptrdiff_t(rowBytes) * row, rowBytes,
                    image.scanLine(image.height() - 1 - tile.y - row) + 4 * size_t(tile.x));
}

/// Returns an uninitialised image. Throws Error(Usage) if there is not enough memory for it.
[[nodiscard]] QImage newImage(const Viewport& size, QImage::Format format);

}  // namespace cullscope::ui
