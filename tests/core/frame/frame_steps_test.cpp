#include <gmock/gmock.h>

#include "core/frame/curve.h"
#include "core/frame/decided_ahead.h"
#include "core/frame/entry_words.h"
#include "core/frame/frame_context.h"
#include "core/frame/frame_stepper.h"

namespace cullscope::frame_steps_test {
namespace {

using testing::ElementsAre;

Decision about(const Subject& subject, Decision::Outcome outcome, uint32_t commands, uint8_t line = 0,
               Cause cause = Cause::OutsideFrustum) {
    Decision decision = ending(subject, outcome, cause);
    decision.commands = commands;
    decision.line = line;
    return decision;
}

/// Decisions about three objects and the cells of the last one, with a draw of the first object, one of the rest, and a decision
/// after all commands.
FrameLog madeUpLog() {
    using Outcome = Decision::Outcome;
    FrameLog log;
    log.recorded = true;
    log.decisions = {about(Subject::ofObject(0), Outcome::Open, 0, 1),
                     about(Subject::ofObject(0), Outcome::Drawn, 0, 3),
                     about(Subject::ofObject(1), Outcome::Culled, 1, 2, Cause::Hidden),
                     about(Subject::ofCell(7, 2), Outcome::Drawn, 1, 3),
                     about(Subject::ofCell(8, 2), Outcome::Culled, 1, 2, Cause::BackFacing),
                     about(Subject::ofObject(2), Outcome::Open, 2)};
    log.decisions[3].places = {2, 3};
    log.commands = {DrawList{Facing::TwoSided, {{0, 0, 30}}}, DrawList{Facing::TwoSided, {{2, 3, 9}, {2, 30, 6}}}};
    return log;
}

std::shared_ptr<const FrameLog> shared(FrameLog log) { return std::make_shared<const FrameLog>(std::move(log)); }

/// What each entry is: "d" or "c" with its number.
std::vector<std::string> names(const FrameLog& log) {
    const FrameEntries entries(log);
    std::vector<std::string> names;
    for (size_t i = 0; i < entries.size(); ++i) {
        const FrameEntry entry = entries.at(i);
        names.push_back((entry.command != nullptr ? "c" : "d") + std::to_string(entry.number));
    }
    return names;
}

TEST(FrameEntries, areInTheOrderInWhichTheyHappened) {
    EXPECT_THAT(names(madeUpLog()), ElementsAre("d0", "d1", "c0", "d2", "d3", "d4", "c1", "d5"));
}

TEST(FrameEntries, areThoseThatAPartOfTheLogHas) {
    const FrameLog log = madeUpLog();
    const std::vector<std::string> all = names(log);
    for (size_t k = 0; k <= log.entries() + 1; ++k) {
        const FrameLog part = log.upTo(k);
        const size_t expected = std::min(k, log.entries());
        ASSERT_EQ(part.entries(), expected);
        EXPECT_EQ(names(part), std::vector<std::string>(all.begin(), all.begin() + std::ptrdiff_t(expected)));
    }
}

TEST(FrameSteps, areSingleEntriesOfAShortLog) {
    const FrameSteps steps(madeUpLog());
    EXPECT_EQ(steps.grain(), StepGrain::Entry);
    ASSERT_EQ(steps.count(), 8u);
    for (size_t step = 0; step <= 8; ++step) {
        EXPECT_EQ(steps.entriesAfter(step), step);
        EXPECT_EQ(steps.stepWith(step), step);
    }
}

TEST(FrameSteps, getCoarserOfALongLogAndEndWithAllEntries) {
    const FrameLog log = madeUpLog();
    const auto ends = [&](size_t most, StepGrain grain) {
        const FrameSteps steps(log, most);
        EXPECT_EQ(steps.grain(), grain) << most;
        EXPECT_LE(steps.count(), most);
        std::vector<size_t> found;
        for (size_t step = 0; step <= steps.count(); ++step) {
            found.push_back(steps.entriesAfter(step));
            EXPECT_EQ(steps.stepWith(found.back()), step);
        }
        return found;
    };
    EXPECT_THAT(ends(7, StepGrain::Subject), ElementsAre(0, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_THAT(ends(6, StepGrain::Object), ElementsAre(0, 2, 3, 4, 6, 7, 8)) << "both cells of one object";
    EXPECT_THAT(ends(3, StepGrain::Commands), ElementsAre(0, 3, 7, 8));
    EXPECT_THAT(ends(2, StepGrain::Share), ElementsAre(0, 4, 8));
}

TEST(FrameSteps, ofBatchesBeforeOneCommandAreShares) {
    FrameLog log;
    for (uint32_t i = 0; i < 1000; ++i) log.decisions.push_back(about(Subject::ofObject(i % 32), Decision::Outcome::Open, 0));
    log.commands = {DrawList{}};
    const FrameSteps steps(log, 100);
    EXPECT_EQ(steps.grain(), StepGrain::Share);
    EXPECT_EQ(steps.count(), 100u);
}

TEST(FrameSteps, ofAMillionEntriesSayThatTheyAreCoarser) {
    FrameLog log;
    for (uint32_t i = 0; i < 1'000'000; ++i)
        log.decisions.push_back(about(Subject::ofCell(i, i / 100), Decision::Outcome::Open, 0));
    const FrameSteps steps(log);
    EXPECT_EQ(steps.grain(), StepGrain::Object);
    EXPECT_EQ(steps.count(), 10'000u);
    EXPECT_EQ(steps.entriesAfter(steps.count()), log.entries());
}

TEST(FrameSteps, aShareOfAnotherLogIsRounded) {
    EXPECT_EQ(entriesAtShare(3, 8, 8), 3u);
    EXPECT_EQ(entriesAtShare(3, 8, 16), 6u);
    EXPECT_EQ(entriesAtShare(8, 8, 100), 100u);
    EXPECT_EQ(entriesAtShare(5, 0, 3), 3u);
}

TEST(FrameStepper, backAndJumpLeadToTheStepThatForwardLedTo) {
    FrameStepper forward(shared(madeUpLog())), jumping(shared(madeUpLog()));
    EXPECT_EQ(forward.step(), forward.count()) << "begins with the whole frame";
    EXPECT_FALSE(forward.forward());
    forward.jump(0);
    EXPECT_FALSE(forward.current());
    EXPECT_FALSE(forward.back());
    for (size_t step = 1; step <= forward.count(); ++step) {
        ASSERT_TRUE(forward.forward());
        jumping.jump(step);
        EXPECT_EQ(jumping.entries(), forward.entries());
        EXPECT_EQ(jumping.current()->number, forward.current()->number);
    }
    ASSERT_TRUE(forward.back());
    EXPECT_EQ(forward.step(), forward.count() - 1);
    forward.jump(1000);
    EXPECT_EQ(forward.step(), forward.count());
}

TEST(FrameStepper, stopsAtBreakpointsOfEveryTraitInBothDirections) {
    using Trait = EntryKind::Trait;
    const auto stops = [](const EntryKind& kind, bool back) {
        FrameStepper stepper(shared(madeUpLog()));
        stepper.setBreakpoints({kind});
        stepper.jump(back ? stepper.count() : 0);
        std::vector<size_t> found;
        while (back ? stepper.runBack(100) && stepper.step() > 0 : stepper.run(100)) {
            found.push_back(stepper.step());
            if (!isOfKind(*stepper.current(), stepper.breakpoints())) break;
            if (!back && stepper.step() == stepper.count()) break;
        }
        return found;
    };
    EXPECT_THAT(stops({Trait::Cause, uint8_t(Cause::Hidden)}, false), ElementsAre(4, 8)) << "and at the end";
    EXPECT_THAT(stops({Trait::Outcome, uint8_t(Decision::Outcome::Drawn)}, true), ElementsAre(5, 2));
    EXPECT_THAT(stops({Trait::Subject, uint8_t(Subject::Kind::Cell)}, true), ElementsAre(6, 5));
    EXPECT_THAT(stops({Trait::Line, 2}, true), ElementsAre(6, 4));
    EXPECT_THAT(stops({Trait::Commands, 0}, true), ElementsAre(7, 3));
}

TEST(FrameStepper, playsSoManyStepsASecondAndEndsAtTheEnd) {
    FrameStepper stepper(shared(madeUpLog()));
    stepper.jump(0);
    stepper.setSpeed(10.0);
    EXPECT_TRUE(stepper.play(0.05));
    EXPECT_EQ(stepper.step(), 0u);
    EXPECT_TRUE(stepper.play(0.06));
    EXPECT_EQ(stepper.step(), 1u) << "the half step was kept";
    EXPECT_TRUE(stepper.play(0.3));
    EXPECT_EQ(stepper.step(), 4u);
    EXPECT_FALSE(stepper.play(100.0));
    EXPECT_EQ(stepper.step(), stepper.count());
    stepper.jump(0);
    stepper.setBreakpoints({{EntryKind::Trait::Commands, 0}});
    EXPECT_FALSE(stepper.play(0.5));
    EXPECT_EQ(stepper.step(), 3u) << "the first draw";
}

TEST(EntryKinds, areThoseThatTheLogContains) {
    using Trait = EntryKind::Trait;
    const std::map<EntryKind, uint64_t> kinds = countKinds(madeUpLog());
    EXPECT_EQ(kinds.at({Trait::Outcome, uint8_t(Decision::Outcome::Culled)}), 2u);
    EXPECT_EQ(kinds.at({Trait::Cause, uint8_t(Cause::Hidden)}), 1u);
    EXPECT_EQ(kinds.at({Trait::Line, 2}), 2u);
    EXPECT_EQ(kinds.at({Trait::Commands, 0}), 2u);
    EXPECT_FALSE(kinds.contains({Trait::Subject, uint8_t(Subject::Kind::Node)}));
    EXPECT_EQ(kindWords({Trait::Cause, uint8_t(Cause::Hidden)}, {}).english(), "Left out: hidden");
    EXPECT_EQ(kindWords({Trait::Line, 2}, {{"for each", 0}, {"leave it out", 1}}).english(), "Line 2: leave it out");
    EXPECT_EQ(kindWords({Trait::Line, 9}, {}).english(), "Line 9");
}

TEST(EntryWords, haveTheComparedValuesAsNumbers) {
    Decision decision = about(Subject::ofObject(0), Decision::Outcome::Culled, 0);
    decision.sentence = "S %1 ≤ %2: hidden";
    decision.operands = {0.53312345, 2.0 / 3.0};
    decision.operandCount = 2;
    EXPECT_EQ(entryWords({nullptr, &decision, 0}).english(), "S 0.533123 ≤ 0.666667: hidden");
    const Decision end = about(Subject::ofNode(3), Decision::Outcome::Culled, 0, 0, Cause::Hidden);
    EXPECT_EQ(entryWords({nullptr, &end, 0}).english(), "Left out: hidden");
    const Command draw = DrawList{Facing::TwoSided, {{0, 0, 30}, {0, 60, 6}}};
    EXPECT_EQ(entryWords({&draw, nullptr, 0}).english(), "Triangles of the scene are drawn: 12 (ranges: 2)");
    const Decision plane = planeTest(Subject::ofObject(0), FrustumPlane::Left, -2.5, 1.0, 0.01);
    EXPECT_EQ(
        entryWords({nullptr, &plane, 0}).english(),
        "Tested against the left plane: even the nearest point of the bounds lies 2.5 outside, more than the bound of 0.01.");
}

TEST(DecidedAhead, isWhatTheNextDrawListHasOfTheSubjectsNamedAsDrawn) {
    const FrameLog log = madeUpLog();
    const auto ahead = [&](size_t entries) { return decidedAhead(log, entries).ranges; };
    EXPECT_TRUE(ahead(0).empty());
    EXPECT_TRUE(ahead(1).empty()) << "a test alone";
    EXPECT_THAT(ahead(2), ElementsAre(DrawRange{0, 0, 30}));
    EXPECT_TRUE(ahead(3).empty()) << "it is drawn now";
    EXPECT_TRUE(ahead(4).empty());
    EXPECT_THAT(ahead(5), ElementsAre(DrawRange{2, 6, 6})) << "places 2 to 4 of the cell, of which the range has 2 and 3";
    EXPECT_TRUE(ahead(7).empty());
    EXPECT_TRUE(ahead(100).empty());
}

TEST(DecidedAhead, rangesOfCellsAreDrawnAsCellsAre) {
    FrameLog log = madeUpLog();
    log.decisions[3].subject = {Subject::Kind::Cells, 4, 2};
    const DrawList ahead = decidedAhead(log, 5);
    ASSERT_EQ(ahead.ranges.size(), 1u);
    EXPECT_EQ(ahead.ranges.front(), (DrawRange{2, 6, 6})) << "the part of the range at places 2 to 4 that the list draws";
}

TEST(CurveUpTo, hasWhatLiesBeforeTheValueAlone) {
    Curve curve;
    curve.areas = {{{}, TriangleState::Visible, {{0, 10, 1}, {10, 20, 2}}}, {{}, TriangleState::Hidden, {{20, 30, 1}}}};
    curve.lines = {{{}, {{0, 0}, {10, 0}, {10, 1}, {20, 1}, {20, 2}, {30, 2}}}};
    curve.uprights = {{{}, 90.0}, {{}, 20.0, true}};
    curve.intervals = {{0, 10, {}}, {10, 20, {}}, {20, 30, {}}};
    curve.summary = {{"axes"}, {"beyond 20 nothing"}};
    const Curve part = curveUpTo(curve, 10);
    EXPECT_EQ(part.areas[0].boxes.size(), 1u);
    EXPECT_TRUE(part.areas[1].boxes.empty());
    EXPECT_EQ(part.lines[0].points.size(), 3u);
    EXPECT_TRUE(part.uprights[0].at) << "a line that only guides the eye";
    EXPECT_FALSE(part.uprights[1].at) << "the limit is not known yet";
    EXPECT_EQ(part.intervals.size(), 1u);
    EXPECT_EQ(part.summary.size(), 1u);
    EXPECT_EQ(curveUpTo(curve, 30).areas[1].boxes.size(), 1u);
    EXPECT_TRUE(curveUpTo(curve, 30).uprights[1].at);
}

}  // namespace
}  // namespace cullscope::frame_steps_test
