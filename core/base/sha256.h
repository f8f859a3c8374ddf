#pragma once

#include <memory>
#include <span>
#include <string>

namespace cullscope {

/// SHA-256 of bytes that are added in pieces (computed by OpenSSL).
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::span<const std::byte> bytes);
    template <typename T>
    void addValues(std::span<const T> values) {
        add(std::as_bytes(values));
    }
    /// Finishes the hash and returns it as 64 lower-case hexadecimal digits.
    [[nodiscard]] std::string hexadecimal();

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

}  // namespace cullscope
