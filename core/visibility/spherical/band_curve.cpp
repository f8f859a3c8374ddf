#include "core/visibility/spherical/band_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/message.h"

namespace cullscope::spherical {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

double inDegrees(double radians) { return radians / kHalfTurn * 180.0; }

double finite(double size) { return std::isfinite(size) ? size : 0.0; }

/// The number of the band from which on all bands of a sector are hidden; 0: the sector is not cut.
uint32_t cutOfSector(const ContourBands& bands, uint32_t sector) {
    uint32_t cut = 0;
    bool hiddenBeyond = false;
    for (uint32_t band = 0; band < bands.bands; ++band) {
        const BandSector& entry = bands.at(band, sector);
        if (finite(entry.size) <= 0.0) continue;
        if (entry.drawn || entry.within) cut = band + 1;
        hiddenBeyond = !entry.drawn;
    }
    return hiddenBeyond ? cut : 0;
}

/// Makes the curve of an object that has bands.
class CurveMaker {
public:
    CurveMaker(const ContourBands& table, const std::optional<uint32_t>& sector)
        : m_table(table), m_sector(sector), m_bands(curveBands(table, sector)), m_cut(cutOf(m_bands)) {}

    [[nodiscard]] Curve make() const {
        Curve curve;
        curve.title = {CULLSCOPE_TR("Size by contour band")};
        curve.x = {{}, 0.0, 180.0, false, 30.0, "°"};
        curve.y = {caption(), 0.0, 0.0, true};
        curve.areas = areas();
        if (m_sector) curve.lines = {nearerSizes()};
        curve.uprights = {{{}, 90.0}, cutLine()};
        for (const CurveBand& band : m_bands)
            curve.intervals.push_back({inDegrees(band.from), inDegrees(band.to), wordsOf(band), isEmpty(band)});
        curve.summary = {caption()};
        if (m_cut) curve.summary.push_back({CULLSCOPE_TR("Beyond α = %1 nothing is drawn."), {Term::angle(*m_cut)}});
        curve.parts = parts();
        return curve;
    }

private:
    [[nodiscard]] static bool isEmpty(const CurveBand& band) { return !band.anyDrawn && !band.anyHidden; }
    [[nodiscard]] Term sizeName() const {
        return Term::marked(m_table.slopes ? CULLSCOPE_TR("slope") : CULLSCOPE_TR("S, mesh units"));
    }

    [[nodiscard]] Words caption() const {
        if (m_sector)
            return {CULLSCOPE_TR("Upwards: %1; to the right: angle α from the axis to the eye; sector %2"),
                    {sizeName(), Term::plain(*m_sector + 1)}};
        return {CULLSCOPE_TR("Upwards: %1, the largest of all sectors; to the right: angle α from the axis to the eye. Each "
                             "sector is compared by itself; a band of two colours is drawn in some sectors and hidden in "
                             "others."),
                {sizeName()}};
    }

    [[nodiscard]] std::vector<Words> wordsOf(const CurveBand& band) const {
        std::vector<Words> lines{{CULLSCOPE_TR("α %1 to %2"), {Term::angle(band.from), Term::angle(band.to)}}};
        if (band.anyDrawn) lines.push_back({CULLSCOPE_TR("drawn: %1 %2"), {sizeName(), Term::length(band.drawn)}});
        if (band.anyHidden) lines.push_back({CULLSCOPE_TR("hidden: %1 %2"), {sizeName(), Term::length(band.hidden)}});
        if (isEmpty(band)) lines.push_back({CULLSCOPE_TR("Nothing lies here.")});
        if (m_sector) lines.push_back({CULLSCOPE_TR("largest nearer: %1"), {Term::length(band.horizon)}});
        return lines;
    }

    [[nodiscard]] std::vector<CurveArea> areas() const {
        CurveArea drawn{{m_sector ? CULLSCOPE_TR("drawn") : CULLSCOPE_TR("drawn in some sectors")}, TriangleState::Visible, {}};
        CurveArea hidden{{m_sector ? CULLSCOPE_TR("hidden") : CULLSCOPE_TR("hidden in some sectors")}, TriangleState::Hidden, {}};
        for (const CurveBand& band : m_bands) {
            const double from = inDegrees(band.from), to = inDegrees(band.to), middle = (from + to) / 2;
            // Where sectors differ, the band is shared by both.
            const bool both = band.anyDrawn && band.anyHidden;
            if (band.anyDrawn) drawn.boxes.push_back({from, both ? middle : to, band.drawn});
            if (band.anyHidden) hidden.boxes.push_back({both ? middle : from, to, band.hidden});
        }
        return {std::move(drawn), std::move(hidden)};
    }

    [[nodiscard]] CurveLine nearerSizes() const {
        CurveLine line{{CULLSCOPE_TR("largest nearer")}, {}};
        for (const CurveBand& band : m_bands)
            line.points.insert(line.points.end(),
                               {Vec2(inDegrees(band.from), band.horizon), Vec2(inDegrees(band.to), band.horizon)});
        return line;
    }

    [[nodiscard]] CurveUpright cutLine() const {
        CurveUpright line{{CULLSCOPE_TR("nothing drawn beyond")}, std::nullopt, true};
        if (!m_cut) return line;
        line.at = inDegrees(*m_cut);
        line.label = {"%1", {Term::angle(*m_cut)}};
        return line;
    }

    [[nodiscard]] CurveParts parts() const {
        CurveParts parts;
        parts.name = {CULLSCOPE_TR("Se&ctor:")};
        parts.help = {
            CULLSCOPE_TR("Sectors divide the bands by the angle β about the axis to the eye; each one is tested by itself. Until "
                         "you choose one, it is the one that is drawn farthest.")};
        parts.all = {CULLSCOPE_TR("all")};
        parts.count = m_table.sectors;
        if (!m_sector) return parts;
        const double width = 2.0 * std::numbers::pi / m_table.sectors;
        parts.shown = *m_sector + 1;
        parts.words = {CULLSCOPE_TR("β %1 to %2"), {Term::angle(*m_sector * width), Term::angle((*m_sector + 1) * width)}};
        return parts;
    }

    const ContourBands& m_table;
    std::optional<uint32_t> m_sector;
    std::vector<CurveBand> m_bands;
    std::optional<double> m_cut;
};

}  // namespace

std::vector<CurveBand> curveBands(const ContourBands& bands, const std::optional<uint32_t>& sector) {
    std::vector<CurveBand> result(bands.bands);
    for (uint32_t number = 0; number < bands.bands; ++number) {
        CurveBand& band = result[number];
        band.from = number * bands.width;
        band.to = std::min(kHalfTurn, (number + 1) * bands.width);
        for (uint32_t each = 0; each < bands.sectors; ++each) {
            if (sector && each != *sector) continue;
            const BandSector& entry = bands.at(number, each);
            band.horizon = std::max(band.horizon, finite(entry.horizon));
            // A sector of size 0 holds no triangles: it is neither drawn nor hidden.
            if (finite(entry.size) <= 0.0) continue;
            const double size = finite(entry.size);
            // One across 90° may be drawn within and hidden beyond.
            if (entry.drawn || entry.within) {
                band.anyDrawn = true;
                band.drawn = std::max(band.drawn, size);
            }
            if (!entry.drawn) {
                band.anyHidden = true;
                band.hidden = std::max(band.hidden, size);
            }
        }
    }
    return result;
}

std::optional<double> cutOf(const std::vector<CurveBand>& bands) {
    const auto last = std::find_if(bands.rbegin(), bands.rend(), [](const CurveBand& band) { return band.anyDrawn; });
    const bool hiddenBeyond = std::any_of(bands.rbegin(), last, [](const CurveBand& band) { return band.anyHidden; });
    if (!hiddenBeyond) return std::nullopt;
    return last == bands.rend() ? 0.0 : last->to;
}

uint32_t farthestCutSector(const ContourBands& bands) {
    uint32_t farthest = 0, most = 0;
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        const uint32_t cut = cutOfSector(bands, sector);
        if (cut > most) farthest = sector;
        most = std::max(most, cut);
    }
    return farthest;
}

Curve bandCurve(const SphericalDecision& decision, const std::string& object, const std::optional<uint32_t>& part) {
    if (!decision.bands) {
        Curve none;
        none.title = {CULLSCOPE_TR("Size by contour band")};
        none.absence = {CULLSCOPE_TR("%1 is %2: its bands are not tested. Bring all of it into the picture to see them."),
                        {Term::name(object), Term::marked(relationName(decision.relation))}};
        return none;
    }
    const ContourBands& bands = *decision.bands;
    if (part && *part <= bands.sectors) return CurveMaker(bands, *part == 0 ? std::nullopt : std::optional(*part - 1)).make();
    return CurveMaker(bands, farthestCutSector(bands)).make();
}

}  // namespace cullscope::spherical
