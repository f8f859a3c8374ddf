#include "core/base/sha256.h"

namespace cullscope::sha256_test {
namespace {

TEST(Sha256, givesTheStandardsExamples) {
    // FIPS 180-4: the empty message and "abc".
    EXPECT_EQ(Sha256().hexadecimal(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    Sha256 hash;
    const std::string first = "a", rest = "bc";
    hash.addValues(std::span<const char>(first));
    hash.addValues(std::span<const char>(rest));
    EXPECT_EQ(hash.hexadecimal(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace cullscope::sha256_test
