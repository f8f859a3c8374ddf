#pragma once

#include <string>
#include <vector>

#include "core/mesh/load.h"
#include "core/scene/scene.h"

namespace cullscope::test {

/// Of a scene's objects, in their order.
inline std::vector<std::string> namesOf(const Scene& scene) {
    std::vector<std::string> names;
    for (const Instance& instance : scene.instances()) names.push_back(instance.name);
    return names;
}

/// What a reader says that it left out, in English.
inline std::vector<std::string> remarksOf(const LoadReport& report) {
    std::vector<std::string> remarks;
    for (const Message& remark : report.remarks) remarks.push_back(remark.english());
    return remarks;
}

}  // namespace cullscope::test
