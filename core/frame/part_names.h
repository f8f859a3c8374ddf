#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// What the parts of cut objects (named_parts.h) are called: A1, A2, … of an object A. Where another object's name would be one
/// of these, or could be one with more digits, a dot stands before the number: A.1.
class PartNames {
public:
    explicit PartNames(const Scene& scene);

    /// Of an object's part; `number` from 1.
    [[nodiscard]] std::string of(size_t object, size_t number) const;

private:
    const Scene& m_scene;
    std::vector<std::string> m_sorted;  ///< the objects' names
};

}  // namespace cullscope
