// Small files of every format, truncated at every byte and with bytes changed by a fixed seed: each must load or be refused.
#include <fstream>
#include <random>

#include "tests/support/mesh_files.h"

namespace cullscope::test::mutations_test {
namespace {

constexpr int kMutationsPerFormat = 600;
constexpr unsigned kSeconds = 240;

std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string binaryPly(bool bigEndian) {
    std::string bytes =
        "ply\nformat binary_" + std::string(bigEndian ? "big" : "little") +
        "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\nproperty short z\nproperty list uchar float extra\n"
        "element face 2\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n";
    const auto put = [&](auto value) {
        std::string raw;
        append(raw, value);
        if (bigEndian) std::ranges::reverse(raw);
        bytes += raw;
    };
    for (int vertex = 0; vertex < 4; ++vertex) {
        put(0.5 * vertex);
        put(static_cast<float>(vertex % 2));
        put(static_cast<int16_t>(vertex / 2));
        put(uint8_t{1});
        put(1.0F);
    }
    for (const std::array<int32_t, 3>& face : {std::array{0, 1, 2}, std::array{1, 3, 2}}) {
        put(uint8_t{255});
        put(uint8_t{3});
        for (const int32_t corner : face) put(corner);
    }
    return bytes;
}

std::string usualPly() {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    append(bytes, std::array<float, 9>{0, 0, 0, 1, 0, 0, 0, 1, 0}, uint8_t{3}, std::array<int32_t, 3>{0, 1, 2});
    return bytes;
}

std::string binaryStl() {
    std::string bytes(80, ' ');
    append(bytes, uint32_t{2});
    for (int triangle = 0; triangle < 2; ++triangle)
        append(bytes, std::array<float, 12>{0, 0, 1, 0, 0, 0, 1, 0, static_cast<float>(triangle), 0, 1, 0}, uint16_t{0});
    return bytes;
}

std::string binaryOff() {
    std::string bytes = "OFF BINARY\n";
    append(bytes, std::array<int32_t, 3>{3, 1, 0}, std::array<float, 9>{0, 0, 0, 1, 0, 0, 0, 1, 0},
           std::array<int32_t, 4>{3, 0, 1, 2});
    return bytes;
}

struct Sample {
    std::string name;
    std::string bytes;
};

std::vector<Sample> samples() {
    const std::string data = CULLSCOPE_SOURCE_DIR "/tests/core/mesh/data/";
    return {
        {"a.obj",
         "o first\nv 0 0 0\nv 1 0 0.5e1\nv 0 1 0\nv 1 1 0\nvn 0 0 1\ng second\nf 1//1 2//1 -2//-1\nf 1/1/1 2/2 4 3\nf -1 -2 "
         "-3\n"},
        {"b.ply",
         "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty double z\nelement "
         "face 1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"c.ply",
         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
         "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n7 0 1 2 3 -1 0 1\n"},
        {"d.ply", binaryPly(false)},
        {"e.ply", binaryPly(true)},
        {"f.ply", usualPly()},
        {"g.stl",
         "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
        {"h.stl", binaryStl()},
        {"i.off", "NOFF # normals\n4 2 5\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n3 0 1 2 255 0 0\n4 0 1 3 2\n"},
        {"j.off", binaryOff()},
        {"k.om", contents(data + "quad.om")},
        {"l.om", contents(data + "triangle-double.om")},
    };
}

std::string mutated(std::string bytes, std::mt19937& random) {
    const size_t changes = 1 + random() % 4;
    for (size_t change = 0; change < changes; ++change) {
        const size_t at = random() % bytes.size();
        switch (random() % 5) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
                break;
            case 2:
                bytes.insert(at, bytes, random() % bytes.size(), random() % 16);
                break;
            case 3:
                bytes.erase(at, 1 + random() % 8);
                break;
            default:
                bytes[at] = "0123456789-. \n/#e"[random() % 17];
                break;
        }
        if (bytes.empty()) bytes = "0";
    }
    return bytes;
}

class Mutations : public MeshFiles {};

TEST_F(Mutations, everyTruncationLoadsOrIsRefused) {
    for (const Sample& sample : samples()) {
        EXPECT_EQ(tryLoading(write(sample.name, sample.bytes)), Outcome::Loaded) << sample.name;
        const bool fine = succeedsInChild(
            [&] {
                for (size_t length = 0; length < sample.bytes.size(); ++length)
                    if (tryLoading(write(sample.name, std::string_view(sample.bytes).substr(0, length))) == Outcome::Wrong)
                        return false;
                return true;
            },
            kSeconds);
        EXPECT_TRUE(fine) << sample.name << "; the last file is in the folder";
    }
}

TEST_F(Mutations, everySeededMutationLoadsOrIsRefused) {
    for (const Sample& sample : samples()) {
        const bool fine = succeedsInChild(
            [&] {
                std::mt19937 random(20240229);
                for (int round = 0; round < kMutationsPerFormat; ++round) {
                    if (tryLoading(write(sample.name, mutated(sample.bytes, random))) != Outcome::Wrong) continue;
                    std::fprintf(stderr, "round %d of %s\n", round, sample.name.c_str());
                    return false;
                }
                return true;
            },
            kSeconds);
        EXPECT_TRUE(fine) << sample.name;
    }
}

}  // namespace
}  // namespace cullscope::test::mutations_test
