#include "core/visibility/spherical/recorded_slopes.h"

#include <numbers>

#include "core/base/message.h"
#include "core/visibility/spherical/listings.h"

namespace cullscope::spherical {
namespace {

const char* sentenceOf(SlopeTest::Result result) {
    switch (result) {
        case SlopeTest::Result::Hidden:
            return CULLSCOPE_TR(
                "The cell's triangles reach the slope %1; the horizon before them is higher everywhere, at least %2: hidden.");
        case SlopeTest::Result::Visible:
            return CULLSCOPE_TR(
                "The cell's triangles reach the slope %1; the horizon before them is not everywhere higher (%2): drawn.");
        case SlopeTest::Result::Untested:
            break;
    }
    return CULLSCOPE_TR("The cell lies too near to the centre or to the axis, or reaches too far around: drawn without a test.");
}

}  // namespace

void sayBandSlopes(const ContourBands& bands, ObjectRecord& record) {
    for (uint32_t sector = 0; sector < bands.sectors; ++sector)
        for (uint32_t band = 0; band < bands.bands; ++band) {
            const BandSector& entry = bands.at(band, sector);
            if (entry.size <= 0.0) continue;
            Decision slope;
            slope.subject = {Subject::Kind::Band, band * bands.sectors + sector, record.subject().number};
            slope.operands = {entry.size, entry.horizon, (band + 1) * bands.width * 180.0 / std::numbers::pi, sector + 1.0};
            slope.operandCount = 4;
            slope.sentence =
                CULLSCOPE_TR("Sector %4, band up to α = %3°: the surface's slope is at least %1, and the horizon before it %2.");
            record.say(atLine(BandsLine::Slopes, slope));
        }
}

void saySlopeTest(const SphericalMaps& maps, uint32_t cell, const SlopeTest& test, ObjectRecord& record) {
    const bool hidden = test.result == SlopeTest::Result::Hidden;
    const auto [first, count] = maps.run(cell, cell + 1);
    Decision decision = ending(Subject::ofCell(cell, record.subject().number),
                               hidden ? Decision::Outcome::Culled : Decision::Outcome::Drawn, Cause::Hidden);
    decision.places = {uint32_t(first), uint32_t(count)};
    decision.nesting = 1;
    decision.sentence = sentenceOf(test.result);
    if (test.result != SlopeTest::Result::Untested) {
        decision.operands = {test.slope, test.horizon};
        decision.operandCount = 2;
    }
    record.say(atLine(BandsLine::Slopes, decision));
}

}  // namespace cullscope::spherical
