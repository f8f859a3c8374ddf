#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/experiments/certify/certify.h"

namespace cullscope::cullbench {

// Blocks of a certificate are tried in processes of their own: in one process Mesa's software OpenGL shares what its contexts
// draw with, and crashed now and then where two threads drew. It also keeps the results where a driver ends a process.

/// A process of this program with these words, which tries blocks (tryBlocksOfParent); it ends with the last copy of the trier.
/// Throws Error(OpenGl) where the process ends by itself.
[[nodiscard]] certify::BlockTrier workerProcess(const std::vector<std::string>& words);

/// The worker's side: reads the numbers of blocks, a line each, and writes a line of blockJson for each, until the input ends.
void tryBlocksOfParent(const certify::CertifyRequest& request, std::stop_token stop);

}  // namespace cullscope::cullbench
