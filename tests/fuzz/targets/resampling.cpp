#include "core/mesh/resample.h"
#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"
#include "tests/support/sound_mesh.h"

namespace cullscope::fuzz {

void resampling(std::string_view input) {
    Values values(input);
    const size_t wanted = 1 + values.number<uint16_t>() % 512;
    const size_t fewest = 1 + values.below(16);
    const MeshPointer mesh = meshOf(values);
    if (!mesh) return;
    accepted({ErrorKind::Usage}, [&] { require(test::isSound(*resampled(*mesh, wanted)), "a resampled mesh is not sound"); });
    for (const MeshLevel& level : quadricLevels(*mesh, fewest))
        for (const uint32_t index : level.indices) require(index < mesh->vertexCount(), "a level has a vertex of its own");
}

}  // namespace cullscope::fuzz
