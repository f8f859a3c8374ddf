#include "core/mesh/load.h"

#include <new>

#include "core/base/error.h"
#include "core/mesh/file_format.h"
#include "core/mesh/readers.h"

namespace cullscope {
namespace {

/// The share of the progress for reading; the rest is for checking and computing normals.
constexpr double kReadingShare = 0.75;

void read(MeshFormat format, ReadJob& job) {
    switch (format) {
        case MeshFormat::Obj:
            return readObj(job);
        case MeshFormat::Ply:
            return readPly(job);
        case MeshFormat::Stl:
            return readStl(job);
        case MeshFormat::Off:
            return readOff(job);
        case MeshFormat::Om:
            return readOm(job);
    }
}

LoadedFile loadFrom(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    ByteSource source(path, progress.part(0.0, kReadingShare), options.hash, options.memoryLimitBytes);
    const MeshFormat format = formatOf(path, source);
    MeshAssembler assembler(source.name(), options, progress.part(kReadingShare, 1.0));
    ReadJob job{source, assembler, progress, withoutPacking(path).stem().string()};
    read(format, job);
    LoadedFile file;
    file.objects = assembler.finish();
    file.report = std::move(assembler.report);
    file.sha256 = source.sha256();  // also reads bytes that the format does not need
    progress.tell(1.0, CULLSCOPE_TR("Checking the mesh"));
    return file;
}

}  // namespace

LoadedFile loadMeshFile(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    try {
        return loadFrom(path, options, progress);
    } catch (const std::bad_alloc&) {
        throwInput(CULLSCOPE_TR("%1 needs more memory than this machine gives. Simplify the mesh or split the file."),
                   {path.string()});
    }
}

const std::vector<std::string>& readableMeshExtensions() {
    static const std::vector<std::string> extensions{"obj", "ply", "stl", "off", "om"};
    return extensions;
}

}  // namespace cullscope
