#include "ui/plots/map_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/image/cell_map_picture.h"
#include "ui/look/verdict_swatch.h"

namespace cullscope::ui {

namespace {

/// The states by increasing strength: the strongest one is shown if several cells share a pixel.
constexpr std::array kByStrength{TriangleState::OutsideFrustum, TriangleState::TooSmall, TriangleState::Hidden,
                                 TriangleState::BackFacing,     TriangleState::InVain,   TriangleState::Visible,
                                 TriangleState::WronglyCulled};

uint8_t toneAt(double share) { return uint8_t(1 + std::lround(std::clamp(share, 0.0, 1.0) * (CellTones::kTones - 2))); }

struct Cells {
    uint32_t first = 0, end = 0;
};

/// The range of rows or columns that each pixel shows: the cell at its centre; if cells are smaller than pixels, all cells that
/// begin in the pixel.
std::vector<Cells> cellsUnder(uint32_t pixels, uint32_t cells) {
    std::vector<Cells> under(pixels);
    for (uint32_t i = 0; i < pixels; ++i) {
        const auto middle = uint32_t((2 * uint64_t(i) + 1) * cells / (2 * uint64_t(pixels)));
        const auto begin = uint32_t(uint64_t(i) * cells / pixels), end = uint32_t((uint64_t(i) + 1) * cells / pixels);
        under[i] = cells > pixels ? Cells{begin, end} : Cells{middle, middle + 1};
    }
    return under;
}

uint8_t toneOf(const ShownMap& shown, const TriangleStates* truth, uint32_t cell, const std::optional<TriangleState>& state) {
    if (!state) return 0;
    if (!truth) return CellTones::toneOf(*state);
    const uint64_t first = shown.scene->firstTriangle(shown.map->object);
    uint8_t strongest = 0;
    for (const uint32_t triangle : shown.source().owned(cell))
        strongest = std::max(strongest, CellTones::toneOf(truth->states[first + triangle]));
    return strongest;
}

}  // namespace

uint8_t CellTones::toneOf(TriangleState state) {
    return uint8_t(1 + (std::find(kByStrength.begin(), kByStrength.end(), state) - kByStrength.begin()));
}

CellTones cellTones(const CellMap& map, const std::string& colouring) {
    const MapValues scale = map.source->values(colouring);
    CellTones made{std::vector<uint8_t>(scale.shares.size()), scale.least, scale.most};
    std::transform(scale.shares.begin(), scale.shares.end(), made.tones.begin(),
                   [](float share) { return share < 0.0F ? uint8_t(0) : toneAt(share); });
    return made;
}

CellTones stateTones(const ShownMap& shown, const TriangleStates* truth) {
    const CellMapSource& source = shown.source();
    const auto& states = source.states();
    CellTones made;
    made.tones.resize(states.size());
    std::vector<uint8_t> ofTriangle(shown.scene->meshOf(shown.map->object).triangleCount(), 0);
    for (uint32_t cell = 0; cell < states.size(); ++cell) {
        made.tones[cell] = toneOf(shown, truth, cell, states[cell]);
        for (const uint32_t triangle : source.owned(cell)) ofTriangle[triangle] = made.tones[cell];
    }
    for (uint32_t cell = 0; cell < states.size(); ++cell)
        if (!states[cell] && !source.touching(cell).empty()) made.tones[cell] = ofTriangle[source.touching(cell).back()];
    return made;
}

uint8_t stateTone(const ShownMap& shown, const TriangleStates* truth, uint32_t cell) {
    return toneOf(shown, truth, cell, shown.source().states()[cell]);
}

QList<QRgb> toneColours(bool states, const QPalette& palette) {
    QList<QRgb> colours(CellTones::kTones, palette.color(QPalette::Base).rgb());
    if (states) {
        for (const TriangleState state : kByStrength) colours[CellTones::toneOf(state)] = verdictColour(state, palette).rgb();
        return colours;
    }
    const QColor base = palette.color(QPalette::Base);
    const Vec3f background(base.redF(), base.greenF(), base.blueF());
    for (size_t tone = 1; tone < CellTones::kTones; ++tone) {
        const Vec3f colour = rampColour(double(tone - 1) / (CellTones::kTones - 2), background);
        colours[qsizetype(tone)] = QColor::fromRgbF(colour.x, colour.y, colour.z).rgb();
    }
    return colours;
}

void paintTones(QPainter& painter, const QRectF& bar, bool states, const QPalette& palette) {
    const QList<QRgb> colours = toneColours(states, palette);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 16;
    for (int stop = 0; stop <= kStops; ++stop)
        gradient.setColorAt(double(stop) / kStops, QColor(colours[1 + stop * qsizetype(CellTones::kTones - 2) / kStops]));
    painter.fillRect(bar, gradient);
}

QImage cellImage(const std::vector<uint8_t>& tones, const SphericalGrid& grid, const QSize& size, const QList<QRgb>& colours) {
    QImage image(size, QImage::Format_Indexed8);
    image.setColorTable(colours);
    const std::vector<Cells> rows = cellsUnder(uint32_t(size.height()), grid.rows());
    const std::vector<Cells> columns = cellsUnder(uint32_t(size.width()), grid.columns());
    for (size_t y = 0; y < rows.size(); ++y) {
        uchar* line = image.scanLine(int(y));
        for (size_t x = 0; x < columns.size(); ++x) {
            uint8_t tone = 0;
            for (uint32_t row = rows[y].first; row < rows[y].end; ++row)
                for (uint32_t column = columns[x].first; column < columns[x].end; ++column)
                    tone = std::max(tone, tones[grid.number({row, column})]);
            line[x] = tone;
        }
    }
    return image;
}

}  // namespace cullscope::ui
