#include "core/frame/entry_words.h"

#include <cmath>
#include <cstdio>

#include "core/base/message.h"

namespace cullscope {
namespace {

/// Six significant digits; of a whole number, such as a count, all of them.
std::string digits(double value) {
    constexpr double kMostWhole = 1e15;
    const bool whole = std::abs(value) < kMostWhole && value == std::trunc(value);
    char text[32];
    std::snprintf(text, sizeof text, whole ? "%.0f" : "%.6g", whole && value == 0.0 ? 0.0 : value);
    return text;
}

/// The words that every decision of an outcome has, for decisions without a sentence of their own.
Words outcomeWords(const Decision& decision) {
    switch (decision.outcome) {
        case Decision::Outcome::Culled:
            return {CULLSCOPE_TR("Left out: %1"), {Term::marked(causeName(decision.cause))}};
        case Decision::Outcome::PartlyDrawn:
            return {CULLSCOPE_TR("Drawn in part; the rest is left out: %1"), {Term::marked(causeName(decision.cause))}};
        case Decision::Outcome::Drawn:
            return {CULLSCOPE_TR("Is drawn"), {}};
        case Decision::Outcome::DrawnAfterAll:
            return {CULLSCOPE_TR("Left out before, and drawn after all"), {}};
        case Decision::Outcome::Open:
            break;
    }
    return {CULLSCOPE_TR("Tested"), {}};
}

struct CommandWords {
    Words operator()(const DrawList& list) const {
        return {CULLSCOPE_TR("Triangles of the scene are drawn: %1 (ranges: %2)"),
                {Term::count(list.triangleCount()), Term::count(list.ranges.size())}};
    }
    Words operator()(const OwnTrianglesPointer& own) const {
        return {CULLSCOPE_TR("Triangles of the strategy's own are drawn: %1"), {Term::count(own->triangles.size())}};
    }
    Words operator()(const FinishedPicturePointer& picture) const {
        return {CULLSCOPE_TR("A picture that the strategy made is shown: %1 × %2 pixels"),
                {Term::plain(uint64_t(picture->size.width)), Term::plain(uint64_t(picture->size.height))}};
    }
    Words operator()(const AskedBoxes& asked) const {
        if (!asked.answered)
            return asked.ends.empty()
                       ? Words{CULLSCOPE_TR("OpenGL is asked about boxes: %1; its answers come later"),
                               {Term::count(asked.boxes.size())}}
                       : Words{CULLSCOPE_TR("OpenGL is asked about boxes: %1, in groups: %2; its answers come later"),
                               {Term::count(asked.boxes.size()), Term::count(asked.ends.size())}};
        if (asked.bufferWords > 0)
            return {CULLSCOPE_TR("Boxes are drawn in OpenGL's selection mode: %1; hit records: %2; the hit buffer of %3 words "
                                 "overflowed before: %4"),
                    {Term::count(asked.boxes.size()), Term::count(asked.hits.size()), Term::plain(asked.bufferWords),
                     Term::count(uint64_t(asked.overflows))}};
        if (!asked.ends.empty())
            return {CULLSCOPE_TR("OpenGL is asked about boxes: %1, in groups: %2; groups hit: %3"),
                    {Term::count(asked.boxes.size()), Term::count(asked.ends.size()), Term::count(asked.hits.size())}};
        return {CULLSCOPE_TR("OpenGL is asked about boxes: %1; hit: %2"),
                {Term::count(asked.boxes.size()), Term::count(asked.hits.size())}};
    }
};

}  // namespace

std::vector<Term> decisionTerms(const Decision& decision, const EntryNames& names) {
    std::vector<Term> terms;
    if (decision.plane) terms.push_back(Term::marked(planeName(*decision.plane)));
    for (size_t i = 0; i < decision.operandCount; ++i) {
        const double value = decision.plane ? std::abs(decision.operands[i]) : decision.operands[i];
        terms.push_back(Term::name(names.operands[i].empty() ? digits(value) : names.operands[i]));
    }
    return terms;
}

Words subjectWords(const Scene& scene, const Subject& subject, const EntryNames& names) {
    const auto named = [&](uint32_t instance) { return Term::name(scene.instances()[instance].name); };
    const bool ofObject = subject.object < scene.instances().size();
    const Term number = names.subject.empty() ? Term::plain(subject.number) : Term::name(names.subject);
    switch (subject.kind) {
        case Subject::Kind::Object:
            if (ofObject) return {CULLSCOPE_TR("Object %1"), {named(subject.object)}};
            return {CULLSCOPE_TR("Object %1"), {number}};
        case Subject::Kind::Node:
            return {CULLSCOPE_TR("Node %1"), {number}};
        case Subject::Kind::Cell:
            if (ofObject) return {CULLSCOPE_TR("Cell %1 of %2"), {number, named(subject.object)}};
            return {CULLSCOPE_TR("Cell %1"), {number}};
        case Subject::Kind::Ray:
            if (ofObject) return {CULLSCOPE_TR("Ray %1 to %2"), {number, named(subject.object)}};
            return {CULLSCOPE_TR("Ray %1"), {number}};
        case Subject::Kind::Band:
            if (ofObject) return {CULLSCOPE_TR("Band %1 of %2"), {number, named(subject.object)}};
            return {CULLSCOPE_TR("Band %1"), {number}};
        case Subject::Kind::Fragment:
            if (names.whole && ofObject)
                return {CULLSCOPE_TR("Triangle %1 of %2"),
                        {Term::plain(subject.number), names.subject.empty() ? named(subject.object) : number}};
            if (!names.subject.empty()) return {CULLSCOPE_TR("Part %1"), {number}};
            if (ofObject) return {CULLSCOPE_TR("Part of triangle %1 of %2"), {number, named(subject.object)}};
            return {CULLSCOPE_TR("Part of triangle %1"), {number}};
        case Subject::Kind::Cells:
            if (ofObject) return {CULLSCOPE_TR("Cells of %1"), {named(subject.object)}};
            return {CULLSCOPE_TR("Several cells"), {}};
        case Subject::Kind::Rows:
            if (!names.subject.empty()) return {CULLSCOPE_TR("Rows %1 of the picture"), {number}};
            return {CULLSCOPE_TR("Row %1 of the picture"), {number}};
        case Subject::Kind::Triangles:
            if (!ofObject) return {CULLSCOPE_TR("Triangle %1"), {number}};
            if (!names.subject.empty()) return {CULLSCOPE_TR("Triangles %1 of %2"), {number, named(subject.object)}};
            return {CULLSCOPE_TR("Triangle %1 of %2"),
                    {Term::plain(scene.firstTriangle(subject.object) + subject.number), named(subject.object)}};
        case Subject::Kind::Span:
            break;
    }
    if (ofObject) return {CULLSCOPE_TR("Piece %1 of a row, of %2"), {number, named(subject.object)}};
    return {CULLSCOPE_TR("Piece %1 of a row"), {number}};
}

Words entryWords(const FrameEntry& entry, const EntryNames& names) {
    if (entry.command != nullptr) return std::visit(CommandWords{}, *entry.command);
    if (entry.decision->sentence == nullptr) return outcomeWords(*entry.decision);
    return {entry.decision->sentence, decisionTerms(*entry.decision, names)};
}

std::string entryLine(const Scene& scene, const FrameEntry& entry, const EntryNames& names) {
    const std::string words = entryWords(entry, names).english();
    return entry.decision == nullptr ? words : subjectWords(scene, entry.decision->subject, names).english() + ": " + words;
}

}  // namespace cullscope
