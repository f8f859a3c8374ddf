#pragma once

namespace cullscope {

/// Has the C library keep up to 128 MB of freed memory for the next allocation, where it would give it back to the system, and
/// serve blocks of up to 32 MB from it. A software OpenGL allocates the shaded vertices of each draw call anew and frees them
/// after it: pages that the system takes back then come as page faults in the next call, which take a tenth to a quarter of a
/// frame. For the whole process and for good; of no effect with other C libraries than glibc.
void keepFreedMemory();

}  // namespace cullscope
