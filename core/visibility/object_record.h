#pragma once

#include "core/base/message.h"
#include "core/frame/frame_context.h"

namespace cullscope {

/// In a scene of more objects the tests of an object's rays, bands and cells are not recorded, only their results: they would
/// take hundreds of megabytes.
inline constexpr size_t kMostWithTests = 64;

/// Says so of a frame.
inline void sayResultsAlone(FrameContext& frame) {
    frame.sayCoarser({CULLSCOPE_TR("results alone, above %1 objects"), {std::to_string(kMostWithTests)}});
}

/// What is said of one object while it is decided. Objects are decided side by side, so that each has a record of its own, in
/// which its decisions stand as they fell; the frame gets the records one after the other.
class ObjectRecord {
public:
    /// `tests`: those of rays, bands and cells are said too.
    ObjectRecord(uint32_t instance, bool tests) : m_subject(Subject::ofObject(instance)), m_tests(tests) {}

    [[nodiscard]] const Subject& subject() const { return m_subject; }
    [[nodiscard]] bool tests() const { return m_tests; }

    void say(const Decision& decision) { m_decisions.push_back(decision); }
    /// What was found besides, at the newest decision; there is one.
    void attach(std::shared_ptr<const DecisionDetail> detail);
    /// Says all of it to a frame that is recorded.
    void sayTo(FrameContext& frame) const;

private:
    Subject m_subject;
    bool m_tests;
    std::vector<Decision> m_decisions;
    std::vector<LoggedDetail> m_details;  ///< by the numbers of these decisions, ascending
};

}  // namespace cullscope
