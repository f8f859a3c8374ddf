#pragma once

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace cullscope {

/// Leaves numbers without a value where a vector is made or grows: for arrays that are written whole right after.
template <typename Number>
struct UninitializedAllocator : std::allocator<Number> {
    template <typename Other>
    struct rebind {
        using other = UninitializedAllocator<Other>;
    };
    using std::allocator<Number>::allocator;

    template <typename Element>
    void construct(Element* at) noexcept {
        ::new (static_cast<void*>(at)) Element;
    }
    template <typename Element, typename... Arguments>
    void construct(Element* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) Element(std::forward<Arguments>(arguments)...);
    }
};

/// A vector whose `resize` leaves new elements without a value.
template <typename Number>
using UninitializedVector = std::vector<Number, UninitializedAllocator<Number>>;

template <typename Number>
[[nodiscard]] bool operator==(const UninitializedVector<Number>& some, const std::vector<Number>& others) {
    return std::ranges::equal(some, others);
}

}  // namespace cullscope
