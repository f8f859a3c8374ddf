// Files compressed with gzip and xz.
#include "core/base/error.h"
#include "core/mesh/byte_source.h"
#include "tests/support/mesh_files.h"
#include "tests/support/packed_bytes.h"
#include "tests/support/sound_mesh.h"

namespace cullscope::test::load_packed_test {
namespace {

using testing::HasSubstr;

const std::string kObj = "o a b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no second\nv 0 0 1\nf 1 2 4\n";
constexpr size_t kXzHeaderBytes = 12;

std::string binaryStl(uint32_t triangles) {
    std::string bytes(80, ' ');
    append(bytes, triangles);
    for (uint32_t i = 0; i < triangles; ++i) {
        const auto x = static_cast<float>(i);
        append(bytes, 0.0F, 0.0F, 1.0F, x, 0.0F, 0.0F, x + 1.0F, 0.0F, 0.0F, x, 1.0F, 0.0F, uint16_t{0});
    }
    return bytes;
}

/// Files by their names, one of each format that is recognised by its content, its extension or its size.
std::vector<std::pair<std::string, std::string>> filesOfEachFormat() {
    return {{"a.obj", kObj},
            {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
            {"a.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
            {"text.stl",
             "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
             "endfacet\nendsolid s\n"},
            {"binary.stl", binaryStl(7000)}};
}

class PackedFiles : public MeshFiles {
protected:
    void expectSame(const LoadedFile& packed, const LoadedFile& plain) const {
        ASSERT_EQ(packed.objects.size(), plain.objects.size());
        for (size_t i = 0; i < plain.objects.size(); ++i) {
            EXPECT_EQ(packed.objects[i].name, plain.objects[i].name);
            EXPECT_TRUE(std::ranges::equal(packed.objects[i].mesh->positions(), plain.objects[i].mesh->positions()));
            EXPECT_TRUE(std::ranges::equal(packed.objects[i].mesh->indices(), plain.objects[i].mesh->indices()));
        }
        EXPECT_EQ(packed.sha256, plain.sha256);
        EXPECT_EQ(packed.report.facesRead, plain.report.facesRead);
    }
};

TEST_F(PackedFiles, areReadAsTheirContentIs) {
    for (const auto& [name, bytes] : filesOfEachFormat()) {
        SCOPED_TRACE(name);
        const LoadedFile plain = load(name, bytes);
        expectSame(load(name + ".gz", gzipped(bytes)), plain);
        expectSame(load(name + ".xz", xzPacked(bytes)), plain);
        expectSame(load(name + ".XZ", xzPacked(bytes)), plain);
    }
}

TEST_F(PackedFiles, contentDecidesOverTheExtensionOfThePacking) {
    const LoadedFile plain = load("a.obj", kObj);
    expectSame(load("a.obj.gz", kObj), plain);
    expectSame(load("a.obj.gz", xzPacked(kObj)), plain);
    EXPECT_EQ(load("packed.obj", gzipped(kObj)).objects.size(), 2u);
}

TEST_F(PackedFiles, membersThatFollowEachOtherAreOneContent) {
    const LoadedFile plain = load("a.obj", kObj);
    const std::string first = kObj.substr(0, 20), rest = kObj.substr(20);
    expectSame(load("a.obj.gz", gzipped(first) + gzipped("") + gzipped(rest)), plain);
    expectSame(load("a.obj.xz", xzPacked(first) + xzPacked(rest) + std::string(8, '\0')), plain);
    expectSame(load("a.obj.gz", gzipped(kObj) + std::string(5000, '\0')), plain);
    EXPECT_THAT(refusal("a.obj.gz", gzipped(kObj) + "more"), HasSubstr("damaged"));
    EXPECT_THAT(refusal("a.obj.xz", xzPacked(kObj) + "more than a header"), HasSubstr("damaged"));
}

TEST_F(PackedFiles, everyTruncationIsRefusedWithTheByteWhereTheFileEnds) {
    for (const std::string& packed : {gzipped(kObj), xzPacked(kObj)}) {
        // Shorter ones are not recognised as compressed.
        for (size_t length = kXzHeaderBytes; length < packed.size(); ++length)
            EXPECT_THAT(refusal("a.obj.xz", packed.substr(0, length)), HasSubstr("ends at byte " + std::to_string(length)));
    }
}

TEST_F(PackedFiles, everyBitThatChangesTheContentIsFound) {
    const LoadedFile plain = load("a.obj", kObj);
    for (const std::string& packed : {gzipped(kObj), xzPacked(kObj)}) {
        size_t refused = 0;
        for (size_t bit = 8 * kXzHeaderBytes; bit < 8 * packed.size(); ++bit) {
            std::string bytes = packed;
            bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
            try {
                expectSame(load("a.obj.xz", bytes), plain);
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::Input);
                EXPECT_THAT(error.what(), HasSubstr("a.obj.xz"));
                ++refused;
            }
        }
        EXPECT_GT(refused, 7 * (packed.size() - kXzHeaderBytes));
    }
}

TEST_F(PackedFiles, contentBeyondTheMemoryIsRefusedBeforeItIsRead) {
    const std::string spaces(size_t{8} << 20, '\n');
    LoadOptions options;
    options.memoryLimitBytes = size_t{4} << 20;
    for (const std::string& packed : {gzipped(spaces), xzPacked(spaces)}) {
        EXPECT_LT(packed.size(), spaces.size() / 100);
        try {
            (void)loadMeshFile(write("bomb.obj.gz", packed), options);
            ADD_FAILURE() << "was not refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            EXPECT_THAT(error.what(), HasSubstr("bomb.obj.gz"));
            EXPECT_THAT(error.what(), HasSubstr("may be used on this machine"));
        }
    }
}

TEST_F(PackedFiles, whatIsCompressedTwiceOrEmptyIsSaid) {
    EXPECT_THAT(refusal("a.obj.gz.xz", xzPacked(gzipped(kObj))), HasSubstr("compressed twice"));
    EXPECT_THAT(refusal("a.obj.gz", gzipped("")), HasSubstr("empty"));
    EXPECT_THAT(refusal("a.obj.gz", gzipped("v 0 0 0\n")), HasSubstr("no faces"));
    EXPECT_THAT(refusal("a.obj.xz", xzPacked("v 0 0\n")), HasSubstr("line 1"));
    EXPECT_THAT(refusal("tool.xz", xzPacked("hello")), HasSubstr("none of the mesh formats"));
}

TEST_F(PackedFiles, sizeAndPositionsAreThoseOfTheContent) {
    const std::string bytes = binaryStl(20'000);
    for (const std::string& packed : {gzipped(bytes), xzPacked(bytes)}) {
        double last = 0.0;
        Progress progress;
        progress.report = [&](double share, std::string_view) {
            EXPECT_GE(share, last);
            last = share;
        };
        ByteSource source(write("a.stl.gz", packed), progress, false);
        EXPECT_EQ(source.size(), bytes.size());
        source.skip(700'001);
        EXPECT_EQ(source.position(), 700'001u);
        EXPECT_EQ(source.peek(64).substr(0, 64), bytes.substr(700'001, 64));
        source.skip(source.remaining());
        EXPECT_TRUE(source.peek(1).empty());
        EXPECT_DOUBLE_EQ(last, 1.0);
    }
}

TEST_F(PackedFiles, unpackingStopsOnRequest) {
    const std::filesystem::path path = write("a.obj.xz", xzPacked(std::string(size_t{64} << 20, '\n')));
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    size_t told = 0;
    progress.report = [&](double, std::string_view) {
        if (++told == 3) stop.request_stop();
    };
    try {
        (void)loadMeshFile(path, {}, progress);
        ADD_FAILURE() << "was not stopped";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
    }
    EXPECT_EQ(told, 3u);
}

}  // namespace
}  // namespace cullscope::test::load_packed_test
