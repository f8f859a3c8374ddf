#pragma once

#include <stop_token>

#include "core/experiments/certify/certify.h"

namespace cullscope::cullbench {

// Blocks of a certificate are tried in processes of their own: in one process Mesa's software OpenGL shares what its contexts
// draw with, and crashed now and then where two threads drew. It also keeps the results where a driver ends a process.

/// A process of this program that tries blocks of the request (tryBlocksOfParent); it ends with the last copy of the trier, which
/// throws Error(OpenGl) where the process ends by itself. Mesa's software OpenGL draws with one thread there: it would divide
/// each of the workers' small pictures among all processors again, which takes twice as long.
[[nodiscard]] certify::BlockTrier workerProcess(const certify::CertifyRequest& request);

/// The worker's side: reads the numbers of blocks, a line each, and writes a line of blockJson for each, until the input ends.
void tryBlocksOfParent(const certify::CertifyRequest& request, std::stop_token stop);

}  // namespace cullscope::cullbench
