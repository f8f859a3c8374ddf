#include "core/visibility/small_feature/small_feature_parameters.h"

#include "core/base/message.h"
#include "core/spatial/regular_octree.h"
#include "core/visibility/facing.h"

namespace cullscope::small_feature {

Show featureListing() {
    return listingShow({{CULLSCOPE_TR("for each node of octrees L and S"), 0},
                        {CULLSCOPE_TR("test its box against the six planes"), 1},
                        {CULLSCOPE_TR("outside: leave its components out"), 1},
                        {CULLSCOPE_TR("leaf of L: draw its components"), 1},
                        {CULLSCOPE_TR("leaf of S: t = value ÷ distance"), 1},
                        {CULLSCOPE_TR("if t < k′·tan θ: leave it out"), 2},
                        {CULLSCOPE_TR("else draw its components"), 2}});
}

std::vector<ParameterDeclaration> featureParameters() {
    ParameterDeclaration outline{kOutline,
                                 ParameterType::Real,
                                 30.0,
                                 0.0,
                                 100.0,
                                 "%",
                                 CULLSCOPE_TR("How many of the components, the largest ones, are the outline, which is always "
                                              "drawn. The paper names no number."),
                                 {}};
    const auto threshold = bySize({kThreshold,
                                   ParameterType::Real,
                                   0.002,
                                   0.0,
                                   1.0,
                                   "",
                                   CULLSCOPE_TR("A leaf is left out where its largest occupancy value, divided by its distance, "
                                                "is below this: k′·tan θ."),
                                   {}},
                                  1e-4);
    ParameterDeclaration hold{kHoldFps,
                              ParameterType::Real,
                              0.0,
                              0.0,
                              1000.0,
                              "fps",
                              CULLSCOPE_TR("How many frames per second threshold and outline hold, by the frames' own times; 0: "
                                           "they stay as they are set."),
                              {}};
    const auto levels = [](const char* key, const char* description) {
        return readWhenBuilding(
            {key, ParameterType::Integer, int64_t{4}, 1.0, double(RegularOctree::kMostLevels), "", description, {}});
    };
    return {facingParameter(),
            readWhenBuilding(outline),
            threshold,
            levels(kOutlineLevels, CULLSCOPE_TR("Levels of octree L, which holds the outline; the root is one of them.")),
            levels(kDetailLevels, CULLSCOPE_TR("Levels of octree S, which holds the details; the root is one of them.")),
            choiceParameter("boxes", "contents",
                            CULLSCOPE_TR("Which box of a node is tested and has the distance; the paper can be read both ways."),
                            {{"contents", CULLSCOPE_TR("the box around its components")},
                             {"cells", CULLSCOPE_TR("the octree's cell, over which components reach")}}),
            choiceParameter("at-rest", "culled", CULLSCOPE_TR("What is drawn while the camera does not move."),
                            {{"culled", CULLSCOPE_TR("the same as in motion")},
                             {"whole", CULLSCOPE_TR("everything in the frustum, as in the paper's Figure 8")}}),
            hold};
}

}  // namespace cullscope::small_feature
