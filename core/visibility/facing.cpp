#include "core/visibility/facing.h"

#include <algorithm>

#include "core/base/message.h"

namespace cullscope {

ParameterDeclaration facingParameter(std::string defaultId) {
    return choiceParameter("facing", std::move(defaultId),
                           CULLSCOPE_TR("Which faces are drawn: both sides, or only those whose front is turned to the eye."),
                           {{"auto", CULLSCOPE_TR("front where every mesh is closed, else two-sided")},
                            {"two-sided", CULLSCOPE_TR("both sides")},
                            {"front", CULLSCOPE_TR("front sides only")}});
}

Facing resolveFacing(const ParameterSet& parameters, const Scene& scene) {
    const auto isFacing = [](const ParameterDeclaration& declaration) { return declaration.key == "facing"; };
    if (std::ranges::none_of(parameters.declarations(), isFacing)) return Facing::TwoSided;
    const std::string& choice = parameters.choice("facing");
    if (choice == "auto") return scene.frontFacesSuffice() ? Facing::Front : Facing::TwoSided;
    return choice == "front" ? Facing::Front : Facing::TwoSided;
}

}  // namespace cullscope
