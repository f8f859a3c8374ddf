#include "core/scene/gltf/accessors.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/steps.h"
#include "core/scene/gltf/tiny_gltf.h"

namespace cullscope::gltf {
namespace {

template <typename Value>
Value valueAt(const unsigned char* bytes) {
    Value value{};
    std::memcpy(&value, bytes, sizeof(value));
    return value;
}

/// Bytes of one number; 0 for a kind that no accessor may have.
size_t bytesOfNumber(int kind) {
    switch (kind) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

float numberAt(const unsigned char* bytes, int kind, bool normalised) {
    const auto fraction = [&](double value, double most) {
        return static_cast<float>(normalised ? std::max(value / most, -1.0) : value);
    };
    switch (kind) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return fraction(valueAt<int8_t>(bytes), 127.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return fraction(valueAt<uint8_t>(bytes), 255.0);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return fraction(valueAt<int16_t>(bytes), 32767.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return fraction(valueAt<uint16_t>(bytes), 65535.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return fraction(valueAt<uint32_t>(bytes), 4294967295.0);
        default:
            return valueAt<float>(bytes);
    }
}

bool isWhole(int kind) {
    return kind == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || kind == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           kind == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

uint32_t wholeAt(const unsigned char* bytes, int kind) {
    if (kind == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *bytes;
    return kind == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? valueAt<uint16_t>(bytes) : valueAt<uint32_t>(bytes);
}

}  // namespace

void Accessors::refuse(int accessor, std::string_view sentence) const {
    throwInput(sentence, {m_fileName, std::to_string(accessor)});
}

const tinygltf::Accessor& Accessors::accessorAt(int accessor) const {
    if (accessor < 0 || size_t(accessor) >= m_model.accessors.size())
        refuse(accessor, CULLSCOPE_TR("%1 names the accessor %2, which it does not have. Export the file again."));
    return m_model.accessors[size_t(accessor)];
}

std::span<const unsigned char> Accessors::view(int view, int accessor) const {
    if (view >= 0 && size_t(view) < m_model.bufferViews.size()) {
        const tinygltf::BufferView& found = m_model.bufferViews[size_t(view)];
        if (found.buffer >= 0 && size_t(found.buffer) < m_model.buffers.size()) {
            const std::span<const unsigned char> buffer = m_model.buffers[size_t(found.buffer)].data;
            if (found.byteOffset <= buffer.size() && found.byteLength <= buffer.size() - found.byteOffset)
                return buffer.subspan(found.byteOffset, found.byteLength);
        }
    }
    refuse(accessor,
           CULLSCOPE_TR("%1: the accessor %2 takes its numbers from where the file has no buffer. The file was cut off or "
                        "changed: fetch or export it again."));
}

Accessors::Elements Accessors::elements(int accessor, int view, size_t offset, size_t count, size_t bytes, size_t stride) const {
    const std::span<const unsigned char> all = this->view(view, accessor);
    const size_t step = stride > 0 ? stride : bytes;
    if (offset > all.size() || (count > 0 && (bytes > all.size() - offset || count - 1 > (all.size() - offset - bytes) / step)))
        refuse(accessor,
               CULLSCOPE_TR("%1: the accessor %2 has more elements than its buffer view has room for. The file was cut off "
                            "or changed: fetch or export it again."));
    return {all.subspan(offset), step};
}

void Accessors::requireShape(int accessor, size_t components) const {
    const tinygltf::Accessor& found = accessorAt(accessor);
    const int has = tinygltf::GetNumComponentsInType(uint32_t(found.type));
    if (has != int(components) || bytesOfNumber(found.componentType) == 0)
        throwInput(
            CULLSCOPE_TR("%1: the accessor %2 does not have %3 numbers an element of a kind that can stand there. Export the "
                         "file again."),
            {m_fileName, std::to_string(accessor), std::to_string(components)});
}

Accessors::Elements Accessors::ownElements(int accessor, size_t bytes) const {
    const tinygltf::Accessor& found = accessorAt(accessor);
    if (found.bufferView < 0) return {};
    const auto view = size_t(found.bufferView);
    const size_t stride = view < m_model.bufferViews.size() ? m_model.bufferViews[view].byteStride : 0;
    return elements(accessor, found.bufferView, found.byteOffset, found.count, bytes, stride);
}

template <typename Put>
void Accessors::visit(int accessor, size_t bytes, Put&& put) const {
    const tinygltf::Accessor& found = accessorAt(accessor);
    if (found.bufferView >= 0) {
        const Elements all = ownElements(accessor, bytes);
        inSteps(found.count, m_progress, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) put(i, all.at(i));
        });
    }
    if (!found.sparse.isSparse) return;
    const auto& sparse = found.sparse;
    const int kind = sparse.indices.componentType;
    if (sparse.count < 0 || size_t(sparse.count) > found.count || !isWhole(kind) || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0)
        refuse(accessor,
               CULLSCOPE_TR("%1: the accessor %2 replaces elements in a way that is not possible. Export the file again."));
    const auto count = size_t(sparse.count);
    const Elements places =
        elements(accessor, sparse.indices.bufferView, size_t(sparse.indices.byteOffset), count, bytesOfNumber(kind), 0);
    const Elements values = elements(accessor, sparse.values.bufferView, size_t(sparse.values.byteOffset), count, bytes, 0);
    m_progress.check();
    for (size_t i = 0; i < count; ++i) {
        const uint32_t place = wholeAt(places.at(i), kind);
        if (place >= found.count)
            refuse(accessor,
                   CULLSCOPE_TR("%1: the accessor %2 replaces an element that it does not have. Export the file again."));
        put(place, values.at(i));
    }
}

void Accessors::requireMemoryFor(int accessor, size_t bytes) const {
    constexpr uint64_t kMost = uint64_t{1} << 48;  // so that no sum of bytes overflows
    m_requireMemory(std::min<uint64_t>(accessorAt(accessor).count, kMost) * bytes);
}

std::vector<float> Accessors::numbers(int accessor, size_t components) const {
    requireShape(accessor, components);
    const tinygltf::Accessor& found = accessorAt(accessor);
    const size_t bytes = bytesOfNumber(found.componentType);
    (void)ownElements(accessor, components * bytes);  // no memory is asked for more than the file has
    requireMemoryFor(accessor, components * sizeof(float));
    std::vector<float> numbers(components * found.count);
    visit(accessor, components * bytes, [&](size_t element, const unsigned char* at) {
        for (size_t i = 0; i < components; ++i)
            numbers[components * element + i] = numberAt(at + i * bytes, found.componentType, found.normalized);
    });
    return numbers;
}

std::vector<uint32_t> Accessors::wholes(int accessor) const {
    requireShape(accessor, 1);
    const tinygltf::Accessor& found = accessorAt(accessor);
    if (!isWhole(found.componentType))
        refuse(accessor, CULLSCOPE_TR("%1: the accessor %2 has to have whole numbers without a sign. Export the file again."));
    const size_t bytes = bytesOfNumber(found.componentType);
    (void)ownElements(accessor, bytes);
    requireMemoryFor(accessor, sizeof(uint32_t));
    std::vector<uint32_t> wholes(found.count);
    visit(accessor, bytes, [&](size_t element, const unsigned char* at) { wholes[element] = wholeAt(at, found.componentType); });
    return wholes;
}

}  // namespace cullscope::gltf
