#include "ui/families/spherical/cell_picture.h"

#include <QPaintEngine>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr int kMostCellsAPixel = 4;  // in either direction
constexpr double kFilePixels = 3.0;  // image pixels per unit of a vector document

/// Pixels per unit of the painter's device.
double resolution(const QPainter& painter) {
    const QPaintEngine::Type type = painter.paintEngine()->type();
    const bool vectors = type == QPaintEngine::SVG || type == QPaintEngine::Pdf;
    return vectors ? kFilePixels : std::abs(painter.deviceTransform().m11());
}

/// The cells in the colours of a scale, averaged if several cells share a pixel. To limit the time, at most 4 × 4 samples are
/// averaged per pixel; each sample is the largest tone of its cells.
QImage scaleImage(const CellTones& tones, const SphericalGrid& grid, const QSize& size, const QList<QRgb>& colours) {
    const QSize cells(int(grid.columns()), int(grid.rows()));
    if (cells.width() <= size.width()) return cellImage(tones.tones, grid, size, colours);
    return cellImage(tones.tones, grid, cells.boundedTo(size * kMostCellsAPixel), colours)
        .convertToFormat(QImage::Format_RGB32)
        .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// An image that is transparent but for the hidden cells.
QImage veilImage(const ShownMap& shown, const QSize& size, const QColor& veil) {
    QList<QRgb> colours(CellTones::kTones, qRgba(0, 0, 0, 0));
    colours[CellTones::toneOf(TriangleState::Hidden)] = veil.rgba();
    return cellImage(stateTones(shown, nullptr).tones, shown.grid(), size, colours)
        .convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

}  // namespace

void CellPicture::forgetCells() {
    m_tones.reset();
    m_cells = {};
}

void CellPicture::setContents(const MapContents& contents) {
    const ShownMap &before = m_contents.shown, &now = contents.shown;
    const bool sameDecision = now == before;
    const bool sameMaps = !now.empty() && !before.empty() && now.map().maps == before.map().maps;
    const bool sameCells = m_colouring == spherical::MapColouring::State   ? sameDecision && contents.truth == m_contents.truth
                           : m_colouring == spherical::MapColouring::Level ? sameDecision
                                                                           : sameMaps;
    m_contents = contents;
    if (!sameCells) forgetCells();
    if (!sameDecision) m_veil = {};
}

void CellPicture::setColouring(spherical::MapColouring colouring) {
    if (m_colouring == colouring) return;
    m_colouring = colouring;
    forgetCells();
}

const CellTones& CellPicture::tones() const {
    if (!m_tones)
        m_tones = m_colouring == spherical::MapColouring::State ? stateTones(m_contents.shown, m_contents.truth.get())
                                                                : cellTones(m_contents.shown.map(), m_colouring);
    return *m_tones;
}

void CellPicture::paint(QPainter& painter, const QRectF& area, const QPalette& palette, const QColor& veil) const {
    const QSize size = (area.size() * resolution(painter)).toSize();
    const QList<QRgb> colours = toneColours(m_colouring, palette);
    const bool otherColours = m_colours != colours;
    if (otherColours || m_cells.size() != size) {
        const SphericalGrid& grid = m_contents.shown.grid();
        // States cannot be averaged: the strongest one takes the pixel.
        m_cells = (m_colouring == spherical::MapColouring::State ? cellImage(tones().tones, grid, size, colours)
                                                                 : scaleImage(tones(), grid, size, colours))
                      .convertToFormat(QImage::Format_RGB32);
    }
    m_colours = colours;
    painter.drawImage(area, m_cells);
    if (!veiled()) return;
    if (otherColours || m_veil.size() != size) m_veil = veilImage(m_contents.shown, size, veil);
    painter.drawImage(area, m_veil);
}

}  // namespace cullscope::ui
