#include "ui/panels/bands_plot.h"

#include <QHelpEvent>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/look/verdict_swatch.h"
#include "ui/panels/map_words.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr double kMargin = 6.0;
constexpr double kTick = 3.0;
constexpr int kLeastPlot = 110;
constexpr int kDegreeStep = 30;
constexpr double kHalf = std::numbers::pi;

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

double BandsPlot::largest() const {
    double most = 0.0;
    for (const Band& band : bands()) most = std::max({most, band.drawn, band.hidden, m_sector ? band.horizon : 0.0});
    return most;
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

QPointF BandsPlot::Frame::placeOf(double alpha, double size) const {
    return {area.left() + alpha / kHalf * area.width(), area.bottom() - std::min(1.0, size / most) * area.height()};
}

PlotLegend BandsPlot::legend(const PlotColours& colours, const QFontMetricsF& metrics, const QPalette& palette) const {
    const bool all = !m_sector;
    std::vector<PlotLegend::Entry> entries{
        {all ? tr("drawn in some sectors") : tr("drawn"), verdictColour(TriangleState::Visible, palette), Qt::SolidLine, {}},
        {all ? tr("hidden in some sectors") : tr("hidden"), verdictColour(TriangleState::Hidden, palette), Qt::SolidLine, {}}};
    if (m_sector) entries.push_back({tr("largest nearer"), colours.text, Qt::SolidLine, {}});
    entries.push_back({tr("beyond it nothing is drawn"), colours.loss, Qt::DashLine, {}});
    return {std::move(entries), metrics};
}

BandsPlot::Frame BandsPlot::frame(const QRectF& place, const QFontMetricsF& metrics) const {
    const std::unique_ptr<QValueAxis> axis(axisFromZero(largest()));
    const QRectF inner =
        legend(PlotColours(palette()), metrics, palette()).takeFrom(place.adjusted(kMargin, kMargin, -kMargin, -kMargin));
    const double words = metrics.boundingRect(inner, Qt::TextWordWrap, caption()).height() + metrics.height() / 2;
    double left = 0.0;
    for (int tick = 0; tick < axis->tickCount(); ++tick)
        left = std::max(left, metrics.horizontalAdvance(lengthText(axis->max() * tick / (axis->tickCount() - 1))));
    const double right = metrics.horizontalAdvance(QStringLiteral("180°")) / 2;
    return {inner.adjusted(left + 2 * kTick, words, -right, -metrics.height() - kTick), axis->max()};
}

QPointF BandsPlot::placeOf(double alpha, double size) const { return frame(rect(), QFontMetricsF(font())).placeOf(alpha, size); }

int BandsPlot::neededHeight(int width) const {
    const QFontMetricsF metrics(font());
    const double across = width - 2 * kMargin;
    const double words = metrics.boundingRect(QRectF(0, 0, across, 1e4), Qt::TextWordWrap, caption()).height();
    const PlotLegend lines = legend(PlotColours(palette()), metrics, palette());
    return int(std::ceil(lines.heightWith(kLeastPlot + words, across) + 2 * kMargin));
}

void BandsPlot::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    const QFontMetricsF metrics(painter.font());
    const Frame frame = this->frame(place, metrics);
    PlotLegend words = legend(colours, metrics, palette);
    (void)takeCaption(painter, words.takeFrom(place.adjusted(kMargin, kMargin, -kMargin, -kMargin)), caption(), colours);
    paintAxes(painter, frame, colours);
    paintBands(painter, frame, palette);
    if (m_sector) paintHorizon(painter, frame, colours);
    paintAngles(painter, frame, colours);
    words.paint(painter, colours);
}

void BandsPlot::paintAxes(QPainter& painter, const Frame& frame, const PlotColours& colours) const {
    const QFontMetricsF metrics(painter.font());
    const std::unique_ptr<QValueAxis> axis(axisFromZero(largest()));
    for (int tick = 0; tick < axis->tickCount(); ++tick) {
        const double size = axis->max() * tick / (axis->tickCount() - 1);
        const QPointF at = frame.placeOf(0.0, size);
        painter.setPen(colours.grid);
        painter.drawLine(at, QPointF(frame.area.right(), at.y()));
        painter.setPen(colours.text);
        painter.drawText(QRectF(at.x() - 100.0 - kTick, at.y() - metrics.height() / 2, 100.0, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, lengthText(size));
    }
    for (int degrees = 0; degrees <= 180; degrees += kDegreeStep) {
        const QPointF at = frame.placeOf(degrees * kHalf / 180.0, 0.0);
        painter.setPen(colours.faintText);
        painter.drawLine(at, at + QPointF(0.0, kTick));
        painter.setPen(colours.text);
        painter.drawText(QRectF(at.x() - 30.0, at.y() + kTick, 60.0, metrics.height()), Qt::AlignCenter,
                         QStringLiteral("%1°").arg(degrees));
    }
}

void BandsPlot::paintBands(QPainter& painter, const Frame& frame, const QPalette& palette) const {
    for (const Band& band : bands()) {
        const double middle = (band.from + band.to) / 2;
        const bool both = band.anyDrawn && band.anyHidden;
        const auto bar = [&](double from, double to, double size, TriangleState state) {
            painter.fillRect(QRectF(frame.placeOf(from, size), frame.placeOf(to, 0.0)).adjusted(0.5, 0.0, -0.5, 0.0),
                             verdictColour(state, palette));
        };
        // If some sectors of a band are drawn and others hidden, each colour gets half of the band's width.
        if (band.anyDrawn) bar(band.from, both ? middle : band.to, band.drawn, TriangleState::Visible);
        if (band.anyHidden) bar(both ? middle : band.from, band.to, band.hidden, TriangleState::Hidden);
    }
}

void BandsPlot::paintHorizon(QPainter& painter, const Frame& frame, const PlotColours& colours) const {
    QPainterPath path;
    for (const Band& band : bands()) {
        const QPointF begin = frame.placeOf(band.from, band.horizon);
        if (path.elementCount() == 0)
            path.moveTo(begin);
        else
            path.lineTo(begin);
        path.lineTo(frame.placeOf(band.to, band.horizon));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.ground, 3.5));
    painter.drawPath(path);
    painter.setPen(QPen(colours.text, 1.6));
    painter.drawPath(path);
}

void BandsPlot::paintAngles(QPainter& painter, const Frame& frame, const PlotColours& colours) const {
    const auto line = [&](double alpha, const QPen& pen) {
        painter.setPen(pen);
        painter.drawLine(frame.placeOf(alpha, 0.0), frame.placeOf(alpha, frame.most));
    };
    line(kHalf / 2, QPen(colours.faintText, 1.2, Qt::DotLine));
    const std::optional<double> cut = this->cut();
    if (!cut) return;
    line(*cut, QPen(colours.loss, 2.0, Qt::DashLine));
    const QFontMetricsF metrics(painter.font());
    const QString words = degreesText(*cut);
    QRectF place(frame.placeOf(*cut, frame.most) + QPointF(4.0, 0.0),
                 QSizeF(metrics.horizontalAdvance(words) + 2.0, metrics.height()));
    if (place.right() > frame.area.right()) place.moveRight(frame.placeOf(*cut, 0.0).x() - 4.0);
    painter.fillRect(place, colours.ground);
    painter.setPen(colours.text);
    painter.drawText(place, Qt::AlignCenter, words);
}

QString BandsPlot::wordsAt(const QPointF& place) const {
    if (empty()) return {};
    const Frame frame = this->frame(rect(), QFontMetricsF(font()));
    if (!frame.area.contains(place)) return {};
    const double alpha = (place.x() - frame.area.left()) / frame.area.width() * kHalf;
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
