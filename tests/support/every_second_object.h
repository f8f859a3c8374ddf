#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/scene/scene.h"
#include "core/visibility/strategy.h"

namespace cullscope::test {

/// A file of drawn sets in which a program draws every second object of a scene; removed with this object. By it `recorded` has
/// something to decide.
class EverySecondObject {
public:
    explicit EverySecondObject(const Scene& scene) {
        std::string pattern = (std::filesystem::temp_directory_path() / "cullscope-sets-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for drawn sets");
        m_folder = pattern;
        std::ofstream out(file());
        out << R"({"poses": [{"eye": [0, 0, 1], "target": [0, 0, 0], "up": [0, 1, 0], "objects": [0)";
        for (size_t i = 2; i < scene.instances().size(); i += 2) out << ", " << i;
        out << "]}]}\n";
    }
    ~EverySecondObject() {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    EverySecondObject(const EverySecondObject&) = delete;
    EverySecondObject& operator=(const EverySecondObject&) = delete;

    /// The defaults of a strategy, with this file where it decides by one.
    [[nodiscard]] ParameterSet parametersOf(const StrategyInfo& info) const {
        ParameterSet parameters(info.parameters);
        if (!info.decidesByFile.empty()) parameters.setFromText(info.decidesByFile, file());
        return parameters;
    }

private:
    [[nodiscard]] std::string file() const { return (m_folder / "drawn.json").string(); }

    std::filesystem::path m_folder;
};

}  // namespace cullscope::test
