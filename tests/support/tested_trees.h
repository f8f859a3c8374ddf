#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "core/mesh/parametric.h"
#include "core/spatial/cell_tree.h"
#include "tests/support/long_mode.h"
#include "tests/support/spherical_meshes.h"

namespace cullscope::test {

inline constexpr std::array<CellTree::Options, 6> kAllOptions{{{MapLayout::Octahedral, 0},
                                                               {MapLayout::Octahedral, 4},
                                                               {MapLayout::Octahedral, 9},
                                                               {MapLayout::LatitudeLongitude, 0},
                                                               {MapLayout::LatitudeLongitude, 4},
                                                               {MapLayout::LatitudeLongitude, 9}}};

inline const std::vector<MeshPointer>& testedMeshes() {
    static const std::vector<MeshPointer> kMeshes = [] {
        std::vector<MeshPointer> meshes = mapTestMeshes();
        meshes.push_back(bowlMesh(20'000));
        return meshes;
    }();
    return kMeshes;
}

inline std::string named(const TriangleMesh& mesh, const CellTree::Options& options) {
    return mesh.name() + ", " + mapLayoutId(options.layout) + ", level " + std::to_string(options.level);
}

/// Calls check(tree) for every mesh with every combination of options; in small samples with one level of each layout.
template <typename Check>
void forAllTrees(const Check& check) {
    for (const MeshPointer& mesh : testedMeshes())
        for (const CellTree::Options& options : kAllOptions) {
            if (fewSamples() && options.level != 4) continue;
            SCOPED_TRACE(named(*mesh, options));
            check(CellTree(mesh, options));
            if (testing::Test::HasFatalFailure()) return;
        }
}

}  // namespace cullscope::test
