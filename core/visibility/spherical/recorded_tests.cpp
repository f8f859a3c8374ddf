#include "core/visibility/spherical/recorded_tests.h"

#include <numbers>

#include "core/base/message.h"
#include "core/visibility/spherical/listings.h"

namespace cullscope::spherical {
namespace {

void recordRay(const CornerRay& ray, const Subject& subject, FrameContext& frame) {
    Decision search;
    search.subject = subject;
    search.operands = {subject.number + 1.0, double(ray.walkedCells.size()), glm::length(ray.point)};
    search.operandCount = 3;
    search.containment = ray.hit ? Containment::Inside : ray.span ? Containment::Straddles : Containment::Outside;
    search.sentence =
        ray.hit    ? CULLSCOPE_TR("Corner ray %1 passes %2 cells of the map and hits a triangle at R = %3.")
        : ray.span ? CULLSCOPE_TR(
                         "Corner ray %1 passes %2 cells of the map and hits nothing: the sphere's point nearest to it, at "
                         "R = %3, is taken.")
                   : CULLSCOPE_TR(
                         "Corner ray %1 misses the bounding sphere (cells passed: %2): the sphere's point nearest to it, at "
                         "R = %3, is taken.");
    frame.say(atLine(BandsLine::Rays, search));
}

}  // namespace

void recordRays(const SphericalDecision& decision, FrameContext& frame) {
    if (!decision.region) return;
    for (uint32_t number = 0; number < decision.rays.size(); ++number)
        recordRay(decision.rays[number], {Subject::Kind::Ray, number, decision.instance}, frame);
    Decision region;
    region.subject = Subject::ofObject(decision.instance);
    region.operands = {double(decision.region->caseNumber), double(decision.region->boxes.size()),
                       double(decision.drawnTriangles)};
    region.operandCount = 3;
    region.sentence =
        CULLSCOPE_TR("The region between the four corners is case %1; boxes around it: %2; triangles in their cells: %3.");
    frame.say(atLine(BandsLine::Rays, region));
}

void recordBands(const SphericalDecision& decision, uint8_t line, FrameContext& frame) {
    if (!decision.bands) return;
    const ContourBands& bands = *decision.bands;
    for (uint32_t band = 0; band < bands.bands; ++band) {
        const double alpha = (band + 1) * bands.width * 180.0 / std::numbers::pi;
        const bool near = alpha <= 90.0 + 1e-9;
        for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
            const BandSector& entry = bands.at(band, sector);
            if (entry.size <= 0.0) continue;
            Decision test;
            test.subject = {Subject::Kind::Band, band * bands.sectors + sector, decision.instance};
            test.containment = entry.drawn ? Containment::Inside : Containment::Outside;
            test.operands = {entry.size, entry.horizon, alpha};
            test.operandCount = 3;
            if (bands.slopes)
                test.sentence = entry.drawn ? CULLSCOPE_TR(
                                                  "Band up to α = %3°: slope %1 of the surface, horizon before it %2: "
                                                  "drawn in part at least.")
                                            : CULLSCOPE_TR(
                                                  "Band up to α = %3°: slope %1 of the surface, horizon before it %2: "
                                                  "hidden.");
            else if (entry.drawn)
                test.sentence = near ? CULLSCOPE_TR("Band up to α = %3°, in the near half: S %1, largest before it %2: drawn.")
                                     : CULLSCOPE_TR("Band up to α = %3°: S %1 > %2, the largest before it: drawn.");
            else
                test.sentence = entry.size <= entry.horizon
                                    ? CULLSCOPE_TR("Band up to α = %3°: S %1 ≤ %2, the largest before it: hidden.")
                                    : CULLSCOPE_TR(
                                          "Band up to α = %3°: S %1, but a nearer band of the sector was hidden (largest "
                                          "before it %2): nothing behind it is drawn.");
            test.line = line;
            frame.say(test);
        }
    }
}

}  // namespace cullscope::spherical
