#include "ui/plots/cell_picture.h"

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
    const bool sameSource = !now.empty() && !before.empty() && now.source().key() == before.source().key();
    const bool sameTruth = contents.truth == m_contents.truth;
    const std::string coloured = colouring() ? colouring()->id : std::string();
    m_contents = contents;
    const MapColouring* colouring = this->colouring();
    const bool sameCells = colouring && colouring->id == coloured &&
                           (colouring->states  ? sameDecision && sameTruth
                            : colouring->fixed ? sameSource
                                               : sameDecision);
    if (!sameCells) forgetCells();
    if (!sameDecision) m_veil = {};
}

bool CellPicture::setColouring(const std::string& colouring) {
    if (m_colouring == colouring) return false;
    m_colouring = colouring;
    forgetCells();
    return true;
}

const MapColouring* CellPicture::colouring() const {
    if (m_contents.shown.empty() || m_contents.shown.map->colourings.empty()) return nullptr;
    const MapColouring* chosen = m_contents.shown.map->colouring(m_colouring);
    return chosen ? chosen : &m_contents.shown.map->colourings.front();
}

const CellTones& CellPicture::tones() const {
    if (!m_tones)
        m_tones = byState() ? stateTones(m_contents.shown, m_contents.truth.get())
                            : cellTones(*m_contents.shown.map, colouring() ? colouring()->id : std::string());
    return *m_tones;
}

void CellPicture::paint(QPainter& painter, const QRectF& area, const QPalette& palette, const QColor& veil) const {
    const QSize size = (area.size() * resolution(painter)).toSize();
    const QList<QRgb> colours = toneColours(byState(), palette);
    const bool otherColours = m_colours != colours;
    if (otherColours || m_cells.size() != size) {
        const SphericalGrid& grid = m_contents.shown.grid();
        // States cannot be averaged: the strongest one takes the pixel.
        m_cells = (byState() ? cellImage(tones().tones, grid, size, colours) : scaleImage(tones(), grid, size, colours))
                      .convertToFormat(QImage::Format_RGB32);
    }
    m_colours = colours;
    painter.drawImage(area, m_cells);
    if (!veiled()) return;
    if (otherColours || m_veil.size() != size) m_veil = veilImage(m_contents.shown, size, veil);
    painter.drawImage(area, m_veil);
}

}  // namespace cullscope::ui
