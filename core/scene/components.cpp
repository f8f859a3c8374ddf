#include "core/scene/components.h"

#include "core/base/message.h"

namespace cullscope {

const char* kindName(const MeshPart& part) {
    switch (part.kind) {
        case MeshPart::Kind::Solid:
            return primitive::kindName(part.solid.index());
        case MeshPart::Kind::Facets:
            return CULLSCOPE_TR("facet group");
        case MeshPart::Kind::Line:
            return CULLSCOPE_TR("line");
    }
    return "";
}

size_t Components::bytes() const {
    size_t bytes = parts.size() * sizeof(MeshPart) + firstPart.size() * sizeof(uint32_t) + groups.size() * sizeof(ObjectGroup);
    for (const ObjectGroup& group : groups)
        if (group.name.capacity() > std::string().capacity()) bytes += group.name.capacity() + 1;
    return bytes;
}

}  // namespace cullscope
