#pragma once

namespace cullscope {

/// From now on the C++ runtime does not abort the program where no handler catches an exception, or one leaves a function that
/// must not throw: libraries have such functions, and the memory or the thread that they ask for may be refused there. The
/// program writes one sentence with its name to standard error, and ends with the status of ErrorKind::Input.
void endWithSentenceOnTerminate();

/// From now on the program also ends with such a sentence where a library crashes or aborts while the system refuses memory or
/// threads (memoryIsShort, threadsAreShort): drivers of OpenGL use what they were not given. Every other crash ends it as before,
/// by its signal.
void endWithSentenceOnWant();

/// While an object of this class exists, the program ends with that sentence, too, where a library exits while the system refuses
/// memory or threads: a scanner of Mesa's shader compiler exits so. For all of `main`, which returns when it is gone. One at a
/// time.
class ExitsForWant {
public:
    ExitsForWant();
    ~ExitsForWant();
    ExitsForWant(const ExitsForWant&) = delete;
    ExitsForWant& operator=(const ExitsForWant&) = delete;
};

/// In a crash whose cause is not a lack of memory or threads `look` is called, in the signal handler: it may find another cause
/// outside of the program and end it with a sentence. One at a time.
void lookAtCrashes(void (*look)());

/// Writes to standard error that the program cannot go on, most likely for lack of memory or threads, and ends it with the
/// status of ErrorKind::Input. Allocates nothing; may be called in a signal handler.
[[noreturn]] void endForWant();

}  // namespace cullscope
