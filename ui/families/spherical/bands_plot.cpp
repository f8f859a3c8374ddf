#include "ui/families/spherical/bands_plot.h"

#include <QHelpEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/families/spherical/map_words.h"
#include "ui/look/verdict_swatch.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kDegreeStep = 30;
constexpr double kHalf = std::numbers::pi;

double degrees(double radians) { return radians / kHalf * 180.0; }

double finite(double size) { return std::isfinite(size) ? size : 0.0; }

/// The number of the band from which on all bands of a sector are hidden; 0: the sector is not cut.
uint32_t cutOf(const spherical::ContourBands& bands, uint32_t sector) {
    uint32_t cut = 0;
    bool hiddenBeyond = false;
    for (uint32_t band = 0; band < bands.bands; ++band) {
        const spherical::BandSector& entry = bands.at(band, sector);
        if (finite(entry.size) <= 0.0) continue;
        if (entry.drawn) cut = band + 1;
        hiddenBeyond = !entry.drawn;
    }
    return hiddenBeyond ? cut : 0;
}

}  // namespace

uint32_t farthestCutSector(const spherical::ContourBands& bands) {
    uint32_t farthest = 0, most = 0;
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        const uint32_t cut = cutOf(bands, sector);
        if (cut > most) farthest = sector;
        most = std::max(most, cut);
    }
    return farthest;
}

BandsPlot::BandsPlot(QWidget* parent) : PlotWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void BandsPlot::setShown(const ShownMap& shown) {
    m_shown = shown;
    if (m_sector && !empty() && *m_sector >= contourBands().sectors) m_sector.reset();
    contentsChanged();
}

void BandsPlot::setAbsence(MapAbsence absence) {
    m_absence = absence;
    contentsChanged();
}

void BandsPlot::setSector(const std::optional<uint32_t>& sector) {
    m_sector = sector;
    contentsChanged();
}

std::vector<BandsPlot::Band> BandsPlot::bands() const {
    const spherical::ContourBands& table = contourBands();
    std::vector<Band> bands(table.bands);
    for (uint32_t number = 0; number < table.bands; ++number) {
        Band& band = bands[number];
        band.from = number * table.width;
        band.to = std::min(kHalf, (number + 1) * table.width);
        for (uint32_t sector = 0; sector < table.sectors; ++sector) {
            if (m_sector && sector != *m_sector) continue;
            const spherical::BandSector& entry = table.at(number, sector);
            band.horizon = std::max(band.horizon, finite(entry.horizon));
            // A sector of size 0 holds no triangles: it is neither drawn nor hidden.
            if (finite(entry.size) <= 0.0) continue;
            (entry.drawn ? band.anyDrawn : band.anyHidden) = true;
            double& size = entry.drawn ? band.drawn : band.hidden;
            size = std::max(size, finite(entry.size));
        }
    }
    return bands;
}

std::optional<double> BandsPlot::cut() const {
    const std::vector<Band> bands = this->bands();
    const auto last = std::find_if(bands.rbegin(), bands.rend(), [](const Band& band) { return band.anyDrawn; });
    const bool hiddenBeyond = std::any_of(bands.rbegin(), last, [](const Band& band) { return band.anyHidden; });
    if (!hiddenBeyond) return std::nullopt;
    return last == bands.rend() ? 0.0 : last->to;
}

QString BandsPlot::sizeName() const { return contourBands().slopes ? tr("slope") : tr("S, mesh units"); }

QString BandsPlot::title() const { return tr("Size by contour band"); }

QString BandsPlot::caption() const {
    const QString name = sizeName();
    if (m_sector)
        return tr("Upwards: %1; to the right: angle α from the axis to the eye; sector %2").arg(name).arg(*m_sector + 1);
    return tr("Upwards: %1, the largest of all sectors; to the right: angle α from the axis to the eye. Each sector is compared "
              "by itself; a band of two colours is drawn in some sectors and hidden in others.")
        .arg(name);
}

QString BandsPlot::emptySentence() const {
    if (const QString words = absenceWords(m_absence); m_shown.empty() && !words.isEmpty()) return words;
    if (m_shown.empty())
        return tr("This strategy has no bands. Strategies that cut the sphere of directions into bands show them here.");
    if (m_shown.map().tree)
        return tr("This strategy uses no contour bands: it tests the cells of a quadtree. The map shows what became of them.");
    return tr("%1 is %2: its bands are not tested. Bring all of it into the picture to see them.",
              "object, how it lies to the frustum")
        .arg(m_shown.name(), translated(spherical::relationName(m_shown.decision().relation)));
}

QString BandsPlot::bandWords(const Band& band) const {
    QStringList lines{tr("α %1 to %2").arg(degreesText(band.from), degreesText(band.to))};
    if (band.anyDrawn) lines << tr("drawn: %1 %2", "a number, what it is of").arg(sizeName(), lengthText(band.drawn));
    if (band.anyHidden) lines << tr("hidden: %1 %2", "a number, what it is of").arg(sizeName(), lengthText(band.hidden));
    if (!band.anyDrawn && !band.anyHidden) lines << tr("Nothing lies here.");
    if (m_sector) lines << tr("largest nearer: %1").arg(lengthText(band.horizon));
    return lines.join(QLatin1Char('\n'));
}

QString BandsPlot::description() const {
    QStringList lines{caption()};
    if (const std::optional<double> cut = this->cut()) lines << tr("Beyond α = %1 nothing is drawn.").arg(degreesText(*cut));
    for (const Band& band : bands())
        if (band.anyDrawn || band.anyHidden) lines << bandWords(band).replace(QLatin1Char('\n'), QLatin1String(", "));
    return lines.join(QLatin1Char('\n'));
}

QPointF BandsPlot::placeOf(double alpha, double size) const {
    const PlotPoint place = drawing().places.front().pixel({degrees(alpha), size});
    return {place.x, place.y};
}

void BandsPlot::addBars(LinePlot& plot, const QPalette& palette) const {
    const bool all = !m_sector;
    PlotBars drawn{(all ? tr("drawn in some sectors") : tr("drawn")).toStdString(),
                   verdictColour(TriangleState::Visible, palette).rgba(),
                   {}};
    PlotBars hidden{(all ? tr("hidden in some sectors") : tr("hidden")).toStdString(),
                    verdictColour(TriangleState::Hidden, palette).rgba(),
                    {}};
    for (const Band& band : bands()) {
        const double from = degrees(band.from), to = degrees(band.to), middle = (from + to) / 2;
        // Where sectors differ, the band is shared by both.
        const bool both = band.anyDrawn && band.anyHidden;
        if (band.anyDrawn) drawn.boxes.push_back({from, band.drawn, both ? middle : to, 0.0});
        if (band.anyHidden) hidden.boxes.push_back({both ? middle : from, band.hidden, to, 0.0});
    }
    plot.bars = {std::move(drawn), std::move(hidden)};
}

void BandsPlot::addHorizon(LinePlot& plot, const PlotColours& colours) const {
    std::vector<PlotPoint> steps;
    for (const Band& band : bands())
        steps.insert(steps.end(), {{degrees(band.from), band.horizon}, {degrees(band.to), band.horizon}});
    // On bars as dark as itself it has an edge.
    plot.lines.push_back(plainLine({}, steps, {colours.ground.rgba(), 3.5}));
    plot.lines.push_back(plainLine(tr("largest nearer").toStdString(), std::move(steps), {colours.text.rgba(), 1.6}));
}

void BandsPlot::addAngles(LinePlot& plot, const PlotColours& colours) const {
    const double most = rangeAlongY(plot).last;
    plot.lines.push_back(plainLine({}, {{90.0, 0.0}, {90.0, most}}, {colours.faintText.rgba(), 1.2, PlotStroke::Dotted}));
    PlotLine last = plainLine(tr("beyond it nothing is drawn").toStdString(), {}, {colours.loss.rgba(), 2.0, PlotStroke::Dashed});
    if (const std::optional<double> cut = this->cut()) {
        last.points = {{degrees(*cut), 0.0}, {degrees(*cut), most}};
        PlotMark words;
        words.at = last.points.back();
        words.label = degreesText(*cut).toStdString();
        plot.marks = {std::move(words)};
    }
    plot.lines.push_back(std::move(last));
}

std::vector<LinePlot> BandsPlot::plots(const QPalette& palette) const {
    const PlotColours colours(palette);
    LinePlot plot;
    plot.x = {{}, PlotScale::Linear, 0.0, 180.0};
    for (int angle = 0; angle <= 180; angle += kDegreeStep)
        plot.x.ticks.push_back({double(angle), QStringLiteral("%1°").arg(angle).toStdString()});
    plot.y = {caption().toStdString(), PlotScale::Linear, 0.0, 0.0, true};
    addBars(plot, palette);
    if (m_sector) addHorizon(plot, colours);
    addAngles(plot, colours);
    return {std::move(plot)};
}

QString BandsPlot::wordsAt(const QPointF& place) const {
    if (empty()) return {};
    const PlotBox area = drawing().places.front().box;
    if (!area.contains({place.x(), place.y()})) return {};
    const double alpha = (place.x() - area.left) / (area.right - area.left) * kHalf;
    return bandWords(bands()[contourBands().bandOf(alpha)]);
}

bool BandsPlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return PlotWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString words = wordsAt(help->pos());
    if (words.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(), words, this);
    return true;
}

}  // namespace cullscope::ui
