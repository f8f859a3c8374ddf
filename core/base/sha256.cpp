#include "core/base/sha256.h"

#include <openssl/evp.h>

#include <array>

namespace cullscope {

struct Sha256::Implementation {
    EVP_MD_CTX* context = EVP_MD_CTX_new();
    ~Implementation() { EVP_MD_CTX_free(context); }
};

Sha256::Sha256() : m_implementation(std::make_unique<Implementation>()) {
    EVP_DigestInit_ex(m_implementation->context, EVP_sha256(), nullptr);
}

Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes) { EVP_DigestUpdate(m_implementation->context, bytes.data(), bytes.size()); }

std::string Sha256::hexadecimal() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    EVP_DigestFinal_ex(m_implementation->context, digest.data(), &length);
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
        text += kDigits[digest[i] >> 4];
        text += kDigits[digest[i] & 15];
    }
    return text;
}

}  // namespace cullscope
