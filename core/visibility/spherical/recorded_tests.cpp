#include "core/visibility/spherical/recorded_tests.h"

#include <numbers>

#include "core/base/message.h"
#include "core/visibility/spherical/listings.h"

namespace cullscope::spherical {
namespace {

Decision testOf(const Subject& subject, const char* sentence, std::initializer_list<double> operands) {
    Decision test;
    test.subject = subject;
    test.sentence = sentence;
    std::ranges::copy(operands, test.operands.begin());
    test.operandCount = uint8_t(operands.size());
    return test;
}

/// What the search along a ray found in one cell. `ray`: its number, from 1.
Decision walkedTest(const SphericalMaps& maps, const WalkedCell& walked, double ray, uint32_t instance) {
    const uint32_t cell = maps.grid().number(walked.cell);
    const SphericalMaps::Extent& extent = maps.extent(cell);
    const Subject subject = Subject::ofCell(cell, instance);
    Decision test;
    if (extent.empty()) {
        test = testOf(subject, CULLSCOPE_TR("Ray %1 passes a cell in which no triangle lies."), {ray});
    } else if (walked.nearest > extent.farthest) {
        test = testOf(subject,
                      CULLSCOPE_TR("Ray %1 stays at R ≥ %2 in this cell, whose triangles end at R = %3: none of them is hit."),
                      {ray, walked.nearest, extent.farthest});
    } else if (walked.farthest < extent.nearest) {
        test = testOf(subject,
                      CULLSCOPE_TR("Ray %1 stays at R ≤ %2 in this cell, whose triangles begin at R = %3: none of them is hit."),
                      {ray, walked.farthest, extent.nearest});
    } else {
        test = testOf(subject,
                      walked.hit ? CULLSCOPE_TR("Ray %1 is at R = %2 to %3 in this cell: of its %4 triangles one is hit.")
                                 : CULLSCOPE_TR("Ray %1 is at R = %2 to %3 in this cell: of its %4 triangles none is hit."),
                      {ray, walked.nearest, walked.farthest, double(walked.tested)});
    }
    test.containment = walked.hit ? Containment::Inside : Containment::Outside;
    return test;
}

void recordRay(const SphericalMaps& maps, const CornerRay& ray, const Subject& subject, FrameContext& frame) {
    const double number = subject.number + 1.0;
    if (ray.span) {
        const double entry = glm::length(ray.ray.at(ray.span->from));
        frame.say(atLine(BandsLine::Rays,
                         testOf(subject, CULLSCOPE_TR("Corner ray %1 enters the bounding sphere at R = %2."), {number, entry})));
    }
    for (const WalkedCell& walked : ray.walkedCells)
        frame.say(atLine(BandsLine::Cells, walkedTest(maps, walked, number, subject.object)));
    Decision found = testOf(
        subject,
        ray.hit ? CULLSCOPE_TR("Corner ray %1 passes %2 cells of the map and hits a triangle at R = %3.")
        : ray.span
            ? CULLSCOPE_TR("Corner ray %1 passes %2 cells of the map and hits nothing: the sphere's point nearest to it, at "
                           "R = %3, is taken.")
            : CULLSCOPE_TR("Corner ray %1 misses the bounding sphere (cells passed: %2): the sphere's point nearest to it, at "
                           "R = %3, is taken."),
        {number, double(ray.walkedCells.size()), glm::length(ray.point)});
    found.containment = ray.hit ? Containment::Inside : Containment::Outside;
    frame.say(atLine(BandsLine::Rays, found));
}

const char* sizeSentence(const BandSector& entry, bool near) {
    if (entry.drawn)
        return near ? CULLSCOPE_TR("Sector %4, band up to α = %3°, in the near half: S %1, largest before it %2: drawn.")
                    : CULLSCOPE_TR("Sector %4, band up to α = %3°: S %1 > %2, the largest before it: drawn.");
    if (entry.within)
        return CULLSCOPE_TR(
            "Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden beyond α = 90°, drawn within it.");
    return entry.size <= entry.horizon
               ? CULLSCOPE_TR("Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden.")
               : CULLSCOPE_TR(
                     "Sector %4, band up to α = %3°: S %1, but a nearer band of the sector was hidden (largest before it %2): "
                     "nothing behind it is drawn.");
}

}  // namespace

std::optional<size_t> CellGroups::boxOf(uint32_t number) const {
    return number > kRegion && number <= boxes ? std::optional<size_t>(number - 1) : std::nullopt;
}

std::optional<size_t> CellGroups::rangeOf(uint32_t number) const {
    return number > boxes ? std::optional<size_t>(number - 1 - boxes) : std::nullopt;
}

void recordRays(const SphericalMaps& maps, const SphericalDecision& decision, FrameContext& frame) {
    if (!decision.region) return;
    for (uint32_t number = 0; number < decision.rays.size(); ++number)
        recordRay(maps, decision.rays[number], {Subject::Kind::Ray, number, decision.instance}, frame);
    const CellGroups groups(decision);
    const VisibleRegion& region = *decision.region;
    frame.say(atLine(
        BandsLine::Region,
        testOf({Subject::Kind::Cells, CellGroups::kRegion, decision.instance},
               CULLSCOPE_TR("The region between the four corners is case %1; boxes around it: %2; triangles in their cells: %3."),
               {double(region.caseNumber), double(region.boxes.size()), double(decision.drawnTriangles)})));
    for (size_t i = 0; i < region.boxes.size(); ++i) {
        const CellBox& box = region.boxes[i];
        frame.say(atLine(BandsLine::Boxes,
                         testOf({Subject::Kind::Cells, groups.box(i), decision.instance},
                                CULLSCOPE_TR("A box around the region: rows %1 to %2 of the map, columns %3 to %4."),
                                {double(box.firstRow), double(box.lastRow), double(box.firstColumn), double(box.lastColumn)})));
    }
}

void recordBands(const SphericalDecision& decision, FrameContext& frame) {
    if (!decision.bands) return;
    const ContourBands& bands = *decision.bands;
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        for (uint32_t band = 0; band < bands.bands; ++band) {
            const BandSector& entry = bands.at(band, sector);
            if (entry.size <= 0.0) continue;
            const double alpha = (band + 1) * bands.width * 180.0 / std::numbers::pi;
            Decision test = testOf({Subject::Kind::Band, band * bands.sectors + sector, decision.instance},
                                   sizeSentence(entry, alpha <= 90.0 + 1e-9), {entry.size, entry.horizon, alpha, sector + 1.0});
            test.containment = entry.drawn ? Containment::Inside : entry.within ? Containment::Straddles : Containment::Outside;
            frame.say(atLine(BandsLine::Bands, test));
        }
    }
}

void recordRanges(const SphericalMaps& maps, const SphericalDecision& decision, uint8_t line, FrameContext& frame) {
    if (!decision.region && !decision.bands) return;
    const CellGroups groups(decision);
    for (size_t i = 0; i < decision.drawn.size(); ++i) {
        const CellRun& cells = decision.drawn[i];
        const auto [first, count] = maps.run(cells.first, cells.last);
        if (count == 0) continue;
        Decision range = testOf({Subject::Kind::Cells, groups.range(i), decision.instance},
                                CULLSCOPE_TR("Cells %1 to %2 are one range of the memory access map: %3 triangles from place %4 "
                                             "on are drawn."),
                                {double(cells.first), double(cells.last - 1), double(count), double(first)});
        range.outcome = Decision::Outcome::Drawn;
        range.containment = Containment::Inside;
        range.places = {uint32_t(first), uint32_t(count)};
        range.line = line;
        frame.say(range);
    }
}

}  // namespace cullscope::spherical
