#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/gltf/container.h"

namespace tinygltf {
class Model;
struct Accessor;
}  // namespace tinygltf

namespace cullscope::gltf {

/// The arrays of a model (glTF 2.0, sections 3.6 and 5.1): from buffers, sparse or not, normalised integers as fractions
/// (section 3.6.2.2). Every access is checked: one that names what the file does not have throws Error(Input) with the accessor's
/// number. `requireMemory` is asked before an array is made.
class Accessors {
public:
    Accessors(const tinygltf::Model& model, std::string fileName, const RequireMemory& requireMemory, const Progress& progress)
        : m_model(model), m_fileName(std::move(fileName)), m_requireMemory(requireMemory), m_progress(progress) {}

    /// Numbers of elements with `components` each (1 to 4), one element after the other, as floats.
    [[nodiscard]] std::vector<float> numbers(int accessor, size_t components) const;
    /// Whole numbers without a sign, one an element.
    [[nodiscard]] std::vector<uint32_t> wholes(int accessor) const;
    /// The bytes of a buffer view, such as a compressed mesh.
    [[nodiscard]] std::span<const unsigned char> view(int view, int accessor) const;

private:
    /// Elements as they lie in the file.
    struct Elements {
        std::span<const unsigned char> bytes;
        size_t stride = 0;
        [[nodiscard]] const unsigned char* at(size_t i) const { return bytes.data() + i * stride; }
    };

    [[noreturn]] void refuse(int accessor, std::string_view sentence) const;
    [[nodiscard]] const tinygltf::Accessor& accessorAt(int accessor) const;
    [[nodiscard]] Elements elements(int accessor, int view, size_t offset, size_t count, size_t bytes, size_t stride) const;
    /// The elements that are not replaced; none of an accessor without a view, which are zeros.
    [[nodiscard]] Elements ownElements(int accessor, size_t bytes) const;
    void requireMemoryFor(int accessor, size_t bytes) const;
    /// Calls `put(element, bytes of the element)` for each element that the file has, those that replace others last.
    template <typename Put>
    void visit(int accessor, size_t bytes, Put&& put) const;
    /// Refuses another number of components than `components`, and a kind of number that no accessor may have.
    void requireShape(int accessor, size_t components) const;

    const tinygltf::Model& m_model;
    std::string m_fileName;
    const RequireMemory& m_requireMemory;
    const Progress& m_progress;
};

}  // namespace cullscope::gltf
