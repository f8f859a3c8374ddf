#pragma once

#include <array>
#include <string>

#include "core/frame/frame_steps.h"
#include "core/frame/words.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The names of what an entry speaks of, as panels and questions call it; empty: its number stands in the sentence.
struct EntryNames {
    std::string subject;
    std::array<std::string, Decision::kOperands> operands;
    bool whole = false;  ///< of a Fragment: it is a whole triangle
};

/// What stands for %1, %2, … in a decision's own sentence: the plane's name, then the operands with six significant digits, whole
/// numbers with all of theirs.
/// The sentence says on which side of a plane a distance lies, so those of a plane test are without their sign.
[[nodiscard]] std::vector<Term> decisionTerms(const Decision& decision, const EntryNames& names = {});
/// What a decision is about: "Object Buddha", "Node 12"; triangles by their numbers in the scene. Rows and triangles with a name
/// are several. English, marked for translation.
[[nodiscard]] Words subjectWords(const Scene& scene, const Subject& subject, const EntryNames& names = {});
/// What a decision found or what a command did, with its values as numbers. English, marked for translation.
[[nodiscard]] Words entryWords(const FrameEntry& entry, const EntryNames& names = {});
/// The entry in one English line for a terminal: its subject and its words.
[[nodiscard]] std::string entryLine(const Scene& scene, const FrameEntry& entry, const EntryNames& names = {});

}  // namespace cullscope
