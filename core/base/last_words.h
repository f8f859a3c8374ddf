#pragma once

namespace cullscope {

/// From now on the C++ runtime does not abort the program where an exception is caught by nobody, or leaves a function that must
/// not throw: libraries have such functions, and the memory or the thread that they ask for may be refused there. The program
/// writes one sentence with its name to standard error, and ends with the status of ErrorKind::Input.
void endWithSentenceOnTerminate();

}  // namespace cullscope
