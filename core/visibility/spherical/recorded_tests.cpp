#include "core/visibility/spherical/recorded_tests.h"

#include <numbers>

#include "core/base/message.h"
#include "core/visibility/spherical/listings.h"
#include "core/visibility/spherical/recorded_decisions.h"

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
    const SphericalMaps::Extent extent = maps.extent(cell);
    const Subject subject = Subject::ofCell(cell, instance);
    Decision test;
    if (maps.storage() == MapStorage::Entries) {
        test = testOf(subject,
                      walked.hit
                          ? CULLSCOPE_TR("Ray %1 is at R = %2 to %3 in this cell: of %4 triangles with an R near that one is "
                                         "hit.")
                          : CULLSCOPE_TR("Ray %1 is at R = %2 to %3 in this cell: of %4 triangles with an R near that none is "
                                         "hit."),
                      {ray, walked.nearest, walked.farthest, double(walked.tested)});
    } else if (extent.empty()) {
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

const char* sizeSentence(const BandSector& entry, bool near) {
    if (entry.drawn)
        return near ? CULLSCOPE_TR("Sector %4, band up to α = %3°, in the near half: S %1, largest before it %2: drawn.")
                    : CULLSCOPE_TR("Sector %4, band up to α = %3°: S %1 > %2, the largest before it: drawn.");
    if (entry.within)
        return CULLSCOPE_TR(
            "Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden beyond α = 90°, drawn within it.");
    return entry.cutBy == BandSector::kUncut
               ? CULLSCOPE_TR("Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden.")
           : entry.size <= entry.horizon
               ? CULLSCOPE_TR(
                     "Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden. The sector's band up to "
                     "α = %5° was hidden before and ended it.")
               : CULLSCOPE_TR(
                     "Sector %4, band up to α = %3°: its S %1 exceeds %2, the largest before it, but the sector's band up to "
                     "α = %5° was hidden and ended it: nothing behind that one is drawn.");
}

}  // namespace

std::optional<size_t> CellGroups::boxOf(uint32_t number) const {
    return number > kRegion && number <= boxes ? std::optional<size_t>(number - 1) : std::nullopt;
}

std::optional<size_t> CellGroups::rangeOf(uint32_t number) const {
    return number > boxes ? std::optional<size_t>(number - 1 - boxes) : std::nullopt;
}

void sayEntry(const CornerRay& ray, uint32_t number, bool box, ObjectRecord& record) {
    if (!record.tests() || !ray.span) return;
    record.say(atLine(BandsLine::Rays, testOf({Subject::Kind::Ray, number, record.subject().number},
                                              box ? CULLSCOPE_TR("Corner ray %1 enters the bounding box at R = %2.")
                                                  : CULLSCOPE_TR("Corner ray %1 enters the bounding sphere at R = %2."),
                                              {number + 1.0, glm::length(ray.ray.at(ray.span->from))})));
}

void sayWalkedCell(const SphericalMaps& maps, const WalkedCell& walked, uint32_t number, ObjectRecord& record) {
    if (record.tests()) record.say(atLine(BandsLine::Cells, walkedTest(maps, walked, number + 1.0, record.subject().number)));
}

void sayRay(const CornerRay& ray, uint32_t number, ObjectRecord& record) {
    if (record.tests()) {
        Decision found = testOf(
            {Subject::Kind::Ray, number, record.subject().number},
            ray.hit ? CULLSCOPE_TR("Corner ray %1 passes %2 cells of the map and hits a triangle at R = %3.")
            : ray.span
                ? CULLSCOPE_TR("Corner ray %1 passes %2 cells of the map and hits nothing; it begins at R = %3.")
                : CULLSCOPE_TR("Corner ray %1 misses the bounds (cells passed: %2); their point nearest to it is at R = %3."),
            {number + 1.0, double(ray.walkedCells.size()), glm::length(ray.point)});
        found.containment = ray.hit ? Containment::Inside : Containment::Outside;
        record.say(atLine(BandsLine::Rays, found));
    }
    record.attach(std::make_shared<RayDetail>(number, ray));
}

void sayBranch(size_t hits, ObjectRecord& record) {
    if (record.tests())
        record.say(atLine(BandsLine::Bands,
                          testOf(record.subject(),
                                 CULLSCOPE_TR("Of the four corner rays %1 meet the object, which is not outside the frustum: "
                                              "contour bands decide about it."),
                                 {double(hits)})));
}

void sayRegion(const VisibleRegion& region, uint64_t triangles, ObjectRecord& record) {
    const uint32_t instance = record.subject().number;
    const auto group = [&](uint32_t number) { return Subject{Subject::Kind::Cells, number, instance}; };
    if (record.tests())
        record.say(atLine(BandsLine::Region,
                          testOf(group(CellGroups::kRegion),
                                 CULLSCOPE_TR("The region between the corners is case %1; boxes around it: %2; triangles in "
                                              "their cells: %3."),
                                 {double(region.caseNumber), double(region.boxes.size()), double(triangles)})));
    record.attach(std::make_shared<RegionDetail>(region));
    if (!record.tests()) return;
    for (size_t i = 0; i < region.boxes.size(); ++i) {
        const CellBox& box = region.boxes[i];
        record.say(atLine(BandsLine::Boxes,
                          testOf(group(CellGroups::box(i)),
                                 CULLSCOPE_TR("A box around the region: rows %1 to %2 of the map, columns %3 to %4."),
                                 {double(box.firstRow), double(box.lastRow), double(box.firstColumn), double(box.lastColumn)})));
    }
}

void saySector(const ContourBands& bands, uint32_t band, uint32_t sector, ObjectRecord& record) {
    const BandSector& entry = bands.at(band, sector);
    if (!record.tests() || entry.size <= 0.0) return;
    const auto upTo = [&](uint32_t of) { return (of + 1) * bands.width * 180.0 / std::numbers::pi; };
    const double alpha = upTo(band);
    Decision test = testOf({Subject::Kind::Band, band * bands.sectors + sector, record.subject().number},
                           sizeSentence(entry, alpha <= 90.0 + 1e-9), {entry.size, entry.horizon, alpha, sector + 1.0});
    if (entry.cutBy != BandSector::kUncut) test.operands[test.operandCount++] = upTo(entry.cutBy);
    test.containment = entry.drawn ? Containment::Inside : entry.within ? Containment::Straddles : Containment::Outside;
    record.say(atLine(BandsLine::Bands, test));
}

void sayRange(const SphericalMaps& maps, const SphericalDecision& decision, size_t index, uint8_t line, ObjectRecord& record) {
    if (!record.tests() || (!decision.region && !decision.bands)) return;
    const CellRun& cells = decision.drawn[index];
    const auto [first, count] = maps.run(cells.first, cells.last);
    if (count == 0) return;
    Decision range = testOf({Subject::Kind::Cells, CellGroups(decision).range(index), decision.instance},
                            CULLSCOPE_TR("Cells %1 to %2 are one range of the memory access map: %3 triangles from place %4 "
                                         "on are drawn."),
                            {double(cells.first), double(cells.last - 1), double(count), double(first)});
    range.outcome = Decision::Outcome::Drawn;
    range.containment = Containment::Inside;
    range.places = {uint32_t(first), uint32_t(count)};
    range.line = line;
    record.say(range);
}

}  // namespace cullscope::spherical
