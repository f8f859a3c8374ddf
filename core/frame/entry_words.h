#pragma once

#include "core/frame/frame_steps.h"
#include "core/frame/words.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What stands for %1, %2, … in a decision's own sentence: the plane's name, then the operands with six significant digits.
/// The sentence says on which side of a plane a distance lies, so those of a plane test are without their sign.
[[nodiscard]] std::vector<Term> decisionTerms(const Decision& decision);
/// What a decision is about: "The object \"Buddha\"", "Node 12". English, marked for translation.
[[nodiscard]] Words subjectWords(const Scene& scene, const Subject& subject);
/// What a decision found or what a command did, with its values as numbers. English, marked for translation.
[[nodiscard]] Words entryWords(const FrameEntry& entry);
/// The entry in one English line for a terminal: its subject and its words.
[[nodiscard]] std::string entryLine(const Scene& scene, const FrameEntry& entry);

}  // namespace cullscope
