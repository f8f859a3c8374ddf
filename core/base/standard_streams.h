#pragma once

namespace cullscope {

/// To be called first in a program. A write to a pipe whose reader has ended is an error (EPIPE) from here on, and does not end
/// the program. Standard streams that are closed are opened to nothing: otherwise the next file or connection that is opened
/// would get the number of standard error, and what is said would be written into it. A closed standard output refuses writes.
void keepStandardStreams();

}  // namespace cullscope
