#include "core/visibility/facing.h"

#include <algorithm>

#include "core/base/message.h"

namespace cullscope {

ParameterDeclaration facingParameter(std::string defaultId) {
    return choiceParameter("facing", std::move(defaultId),
                           CULLSCOPE_TR("Which faces are drawn: both sides, or only those whose front is turned to the eye."),
                           {{"auto", CULLSCOPE_TR("front sides of each object whose mesh is closed, both sides of the others")},
                            {"two-sided", CULLSCOPE_TR("both sides")},
                            {"front", CULLSCOPE_TR("front sides only")}});
}

Facing facingByObject(const Scene& scene) {
    size_t front = 0, other = 0;
    for (size_t i = 0; i < scene.instances().size(); ++i)
        if (scene.meshOf(i).triangleCount() > 0) ++(scene.frontFacesSuffice(i) ? front : other);
    if (other == 0 && front > 0) return Facing::Front;
    return front > 0 ? Facing::ByObject : Facing::TwoSided;
}

Facing resolveFacing(const ParameterSet& parameters, const Scene& scene) {
    const auto isFacing = [](const ParameterDeclaration& declaration) { return declaration.key == "facing"; };
    if (std::ranges::none_of(parameters.declarations(), isFacing)) return Facing::TwoSided;
    const std::string& choice = parameters.choice("facing");
    if (choice == "auto") return facingByObject(scene);
    return choice == "front" ? Facing::Front : Facing::TwoSided;
}

}  // namespace cullscope
