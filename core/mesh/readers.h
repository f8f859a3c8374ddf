#pragma once

#include <string>

#include "core/mesh/byte_source.h"
#include "core/mesh/mesh_assembler.h"

namespace cullscope {

/// The input and output of the reader of one format: it reads `source` and adds the objects to `assembler`; it counts
/// `assembler.report.facesRead` itself. `objectName` is for files that name no objects.
struct ReadJob {
    ByteSource& source;
    MeshAssembler& assembler;
    const Progress& progress;
    std::string objectName;
};

void readObj(ReadJob& job);
void readPly(ReadJob& job);
void readStl(ReadJob& job);
void readOff(ReadJob& job);
void readOm(ReadJob& job);

}  // namespace cullscope
