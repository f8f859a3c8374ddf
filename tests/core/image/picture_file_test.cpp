#include "core/image/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/support/refusal.h"

namespace cullscope::picture_file_test {
namespace {

using testing::HasSubstr;

constexpr float kNothing = std::numeric_limits<float>::infinity();

class PictureFile : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override { std::filesystem::create_directories(m_folder); }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return m_folder / name; }
    [[nodiscard]] Picture writtenAndRead(const Picture& picture, const std::string& ending) const {
        writePicture(file("a." + ending), picture);
        return readPicture(file("a." + ending));
    }
    [[nodiscard]] size_t filesWritten() const {
        return static_cast<size_t>(
            std::distance(std::filesystem::directory_iterator(m_folder), std::filesystem::directory_iterator()));
    }

private:
    std::filesystem::path m_folder = std::filesystem::temp_directory_path() / ("cullscope-pictures-" + std::to_string(getpid()));
};

/// Every byte value in red and green; blue differs between rows; opaque.
Picture opaquePicture() {
    Picture picture{{256, 5}, {}, {}};
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 256; ++x)
            for (const int value : {x, 255 - x, 50 * y, 255}) picture.rgba.push_back(static_cast<uint8_t>(value));
    return picture;
}

/// At least that many bytes of JSON like a session's: braces, quotes, line breaks, Korean text.
std::string longText(size_t bytes) {
    const auto view = [](size_t number) -> nlohmann::json {
        const std::string name = "절두체 컬링 " + std::to_string(number);
        return {{"이름", name}, {"path", "C:\\모델\\\"bunny\".obj"}, {"eye", {1.5, -2, 3e-7}}};
    };
    nlohmann::json json;
    const size_t views = bytes / view(0).dump().size() + 1;
    for (size_t i = 0; i < views; ++i) json["views"].push_back(view(i));
    return json.dump(1);
}

/// While this object lives no file grows beyond that many bytes, as on a disk with room for a part of the data.
class NearlyFullDisk {
public:
    explicit NearlyFullDisk(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit full = m_before;
        full.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &full);
    }
    ~NearlyFullDisk() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    NearlyFullDisk(const NearlyFullDisk&) = delete;
    NearlyFullDisk& operator=(const NearlyFullDisk&) = delete;

private:
    rlimit m_before{};
    void (*m_handler)(int);
};

/// Noise, which no format can compress.
Picture noisyPicture() {
    Picture picture{{256, 256}, std::vector<uint8_t>(256 * 256 * 4), {}};
    std::mt19937 random(7);
    for (uint8_t& byte : picture.rgba) byte = static_cast<uint8_t>(random());
    return picture;
}

std::string textOf(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST_P(PictureFile, metadataComesBackWhole) {
    Picture picture = opaquePicture();
    picture.metadata = {{"cullscope:scene", "field:mesh=/home/길/a,b.obj,n=3"},
                        {"cullscope:session", longText(20'000)},
                        {"cullscope:parameter:a-name-that-is-rather-long-for-one", "p-vertex"},
                        {"cullscope:empty-lines", "\n\n a:b:c \t"},
                        {"cullscope:eye", "0.1,2,3"}};
    picture.dotsPerInch = 300.0;
    const Picture read = writtenAndRead(picture, GetParam());
    EXPECT_THAT(read.metadata, testing::UnorderedElementsAreArray(picture.metadata));
    EXPECT_NEAR(read.dotsPerInch, 300.0, 0.01);
    EXPECT_EQ(read.size, picture.size);
}

TEST_P(PictureFile, picturesWithoutMetadataHaveNone) {
    const Picture read = writtenAndRead(opaquePicture(), GetParam());
    EXPECT_TRUE(read.metadata.empty());
    EXPECT_EQ(read.dotsPerInch, 0.0);
    EXPECT_TRUE(read.depth.empty());
    EXPECT_TRUE(read.triangle.empty());
}

TEST_P(PictureFile, descriptionTooLongForTheFormatIsRefused) {
    Picture picture = opaquePicture();
    picture.metadata = {{"cullscope:session", longText(200'000)}};
    const std::string ending = GetParam();
    if (ending == "png" || ending == "exr") {
        EXPECT_EQ(writtenAndRead(picture, ending).metadata, picture.metadata);
    } else {
        EXPECT_THAT(test::refusalOf([&] { writePicture(file("a." + ending), picture); }, ErrorKind::Usage),
                    HasSubstr("Write a .png"));
        EXPECT_EQ(filesWritten(), 0u);
        // The longest accepted text is read back completely.
        picture.metadata = {{"cullscope:session", std::string(kMostDescriptionBytes - 24, 'x')}};
        EXPECT_EQ(writtenAndRead(picture, ending).metadata, picture.metadata);
    }
}

TEST_P(PictureFile, unwritablePlaceLeavesNoFile) {
    const std::string ending = GetParam();
    const Picture picture = opaquePicture();
    std::filesystem::create_symlink("/dev/full", file("full." + ending));
    EXPECT_THAT(test::refusalOf([&] { writePicture(file("full." + ending), picture); }, ErrorKind::Usage),
                HasSubstr("no space is left"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    std::ofstream(file("file")) << "not a folder";
    EXPECT_THAT(test::refusalOf([&] { writePicture(file("file") / ("a." + ending), picture); }, ErrorKind::Usage),
                HasSubstr("no folder"));
    EXPECT_THAT(test::refusalOf([&] { writePicture(file("none") / ("a." + ending), picture); }, ErrorKind::Usage),
                HasSubstr("no such"));
    EXPECT_EQ(filesWritten(), 2u);
}

TEST_P(PictureFile, diskWithRoomForAPartKeepsTheOldFile) {
    const std::filesystem::path path = file(std::string("a.") + GetParam());
    const Picture picture = noisyPicture();
    writePicture(path, picture);
    const auto whole = static_cast<rlim_t>(std::filesystem::file_size(path));
    ASSERT_GT(whole, 70'000u);
    std::ofstream(path, std::ios::trunc) << "old";
    // In the first of many blocks, in the middle, and one byte before the end.
    for (const rlim_t room : {rlim_t{1}, rlim_t{65'536}, whole / 2, whole - 1}) {
        SCOPED_TRACE(room);
        const NearlyFullDisk disk(room);
        const std::string sentence = test::refusalOf([&] { writePicture(path, picture); }, ErrorKind::Usage);
        EXPECT_THAT(sentence, testing::StartsWith(path.string() + " cannot be written: "));
        EXPECT_THAT(sentence, testing::EndsWith("Choose another place or free some space."));
        EXPECT_EQ(textOf(path), "old");
        EXPECT_EQ(filesWritten(), 1u);
    }
    // Intermediate data in memory is not a file whose size is limited.
    const NearlyFullDisk disk(whole);
    writePicture(path, picture);
    EXPECT_EQ(readPicture(path).size, picture.size);
}

TEST_P(PictureFile, damagedFileIsRefusedInOneLine) {
    const std::filesystem::path path = file(std::string("a.") + GetParam());
    writePicture(path, noisyPicture());
    const std::string whole = textOf(path);
    for (const size_t kept : {size_t{0}, size_t{5}, size_t{40}, whole.size() / 3, whole.size() * 9 / 10}) {
        SCOPED_TRACE(kept);
        std::ofstream(path, std::ios::trunc | std::ios::binary) << whole.substr(0, kept);
        try {
            // A truncated JPEG is decoded as far as it goes.
            (void)readPicture(path);
        } catch (const Error& error) {
            const std::string sentence = error.what();
            EXPECT_THAT(sentence, testing::StartsWith(path.string() + " is no picture that can be read: "));
            EXPECT_GT(sentence.size(), (path.string() + " is no picture that can be read: ").size());
            EXPECT_EQ(sentence.find_first_of("\r\n"), std::string::npos) << sentence;
        }
    }
}

TEST_P(PictureFile, damagedOrAbsentFileIsRefused) {
    const std::string name = std::string("a.") + GetParam();
    writePicture(file(name), opaquePicture());
    std::filesystem::resize_file(file(name), std::filesystem::file_size(file(name)) / 3);
    EXPECT_THAT(test::refusalOf([&] { (void)readPicture(file(name)); }, ErrorKind::Input), HasSubstr(name));
    std::ofstream(file(name)) << "this is text";
    EXPECT_THAT(test::refusalOf([&] { (void)readPicture(file(name)); }, ErrorKind::Input), HasSubstr(name));
    std::ofstream(file(name), std::ios::trunc).close();
    EXPECT_THAT(test::refusalOf([&] { (void)readPicture(file(name)); }, ErrorKind::Input), HasSubstr(name));
    EXPECT_THAT(test::refusalOf([&] { (void)readPicture(file("absent.png")); }, ErrorKind::Input), HasSubstr("absent.png"));
}

INSTANTIATE_TEST_SUITE_P(Formats, PictureFile, testing::Values("png", "jpg", "tif", "exr"),
                         [](const auto& format) { return std::string(format.param); });

TEST_F(PictureFile, losslessFormatsKeepEveryByte) {
    const Picture picture = opaquePicture();
    for (const char* ending : {"png", "tif", "tiff", "exr", "PNG"})
        EXPECT_EQ(writtenAndRead(picture, ending).rgba, picture.rgba) << ending;
}

TEST_F(PictureFile, transparentPixelsKeepTheirColour) {
    Picture picture = opaquePicture();
    for (size_t pixel = 0; pixel < picture.rgba.size() / 4; ++pixel)
        picture.rgba[4 * pixel + 3] = static_cast<uint8_t>(pixel % 7 * 42);
    for (const char* ending : {"png", "tif"}) EXPECT_EQ(writtenAndRead(picture, ending).rgba, picture.rgba) << ending;
    // Multiplied by alpha, faint colours are lost: EXR keeps alpha, and colour where alpha is large enough.
    const Picture exr = writtenAndRead(picture, "exr");
    for (size_t i = 0; i < picture.rgba.size(); ++i) {
        const uint8_t alpha = picture.rgba[i / 4 * 4 + 3];
        if (i % 4 == 3)
            ASSERT_EQ(exr.rgba[i], alpha);
        else
            ASSERT_NEAR(exr.rgba[i], alpha > 0 ? picture.rgba[i] : 0, 1);
    }
}

TEST_F(PictureFile, jpegShowsTheBackgroundThroughTransparentPixels) {
    Picture picture{{16, 16}, std::vector<uint8_t>(16 * 16 * 4, 0), {}};
    for (size_t pixel = 0; pixel < 256; ++pixel) {
        picture.rgba[4 * pixel] = 200;
        picture.rgba[4 * pixel + 3] = pixel < 128 ? 0 : 255;  // the lower half is transparent
    }
    writePicture(file("a.jpg"), picture, Vec3f(0.0F, 1.0F, 0.0F));
    const Picture read = readPicture(file("a.jpg"));
    for (const auto& [pixel, colour] : {std::pair<size_t, Vec3f>{3 * 16 + 5, {0, 255, 0}}, {12 * 16 + 5, {200, 0, 0}}})
        for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(read.rgba[4 * pixel + c], colour[static_cast<int>(c)], 6) << pixel;
    EXPECT_EQ(read.rgba[3], 255);
}

TEST_F(PictureFile, jpegKeepsAThinLineSharp) {
    Picture picture{{64, 64}, std::vector<uint8_t>(64 * 64 * 4, 255), {}};
    for (size_t y = 0; y < 64; ++y)
        for (size_t c = 1; c < 3; ++c) picture.rgba[4 * (y * 64 + 31) + c] = 0;  // a red line on white
    const Picture read = writtenAndRead(picture, "jpg");
    EXPECT_GT(read.rgba[4 * (20 * 64 + 31)] - read.rgba[4 * (20 * 64 + 31) + 1], 180);
    EXPECT_LT(read.rgba[4 * (20 * 64 + 30)] - read.rgba[4 * (20 * 64 + 30) + 1], 60);
}

TEST_F(PictureFile, exrKeepsDepthAndTriangles) {
    Picture picture = opaquePicture();
    for (size_t i = 0; i < 256 * 5; ++i) {
        picture.depth.push_back(i % 3 == 0 ? kNothing : 0.1F + static_cast<float>(i) * 1234.567F);
        picture.triangle.push_back(i % 3 == 0 ? 0U : static_cast<uint32_t>(4294967295U - i));
    }
    Picture read = writtenAndRead(picture, "exr");
    EXPECT_EQ(read.depth, picture.depth);
    EXPECT_EQ(read.triangle, picture.triangle) << "numbers above 2^24 do not go through floats";
    EXPECT_EQ(read.rgba, picture.rgba);
    picture.depth.clear();
    read = writtenAndRead(picture, "exr");
    EXPECT_TRUE(read.depth.empty());
    EXPECT_EQ(read.triangle, picture.triangle);
    EXPECT_TRUE(writtenAndRead(picture, "png").triangle.empty());
    EXPECT_TRUE(keepsDepth("x.EXR"));
    EXPECT_FALSE(keepsDepth("x.png"));
}

TEST_F(PictureFile, lowestRowOfTheFileComesFirst) {
    // A hand-written TIFF: rows from the top, a red one over a blue one. Little-endian; after the pixels, a directory of fields,
    // each with its number, type (3: short, 4: long), count and value.
    std::string bytes("II*\0\x14\0\0\0", 8);
    for (const char* pixel : {"\xff\0\0", "\xff\0\0", "\0\0\xff", "\0\0\xff"}) bytes.append(pixel, 3);
    const auto number = [&](uint32_t value, int size) {
        for (int byte = 0; byte < size; ++byte) bytes.push_back(static_cast<char>(value >> 8 * byte));
    };
    const std::vector<std::array<uint32_t, 3>> fields{{256, 1, 2}, {257, 1, 2}, {258, 3, 134}, {259, 1, 1}, {262, 1, 2},
                                                      {273, 1, 8}, {277, 1, 3}, {278, 1, 2},   {279, 1, 12}};
    number(static_cast<uint32_t>(fields.size()), 2);
    for (const auto& [tag, count, value] : fields)
        number(tag, 2), number(tag == 258 ? 3 : 4, 2), number(count, 4), number(value, 4);
    number(0, 4);
    for (int channel = 0; channel < 3; ++channel) number(8, 2);  // bits of each, at byte 134
    std::ofstream(file("hand.tif"), std::ios::binary) << bytes;
    const Picture picture = readPicture(file("hand.tif"));
    ASSERT_EQ(picture.size, (Viewport{2, 2}));
    EXPECT_EQ(picture.rgba, (std::vector<uint8_t>{0, 0, 255, 255, 0, 0, 255, 255, 255, 0, 0, 255, 255, 0, 0, 255}));
}

TEST_F(PictureFile, unknownEndingIsRefused) {
    for (const char* name : {"a.xyz", "a", "a.bmp", ".png"})
        EXPECT_THAT(test::refusalOf([&] { writePicture(file(name), opaquePicture()); }, ErrorKind::Usage),
                    HasSubstr("choose one of these endings"))
            << name;
    EXPECT_EQ(filesWritten(), 0u);
}

TEST(ForwardDistances, depthsGiveDistancesAndNothingIsInfinitelyFar) {
    const View view({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.5, 1000}, {2, 2});
    const std::vector<float> distances = forwardDistances(
        {0.0F, 1.0F, static_cast<float>(view.depthFromDistance(7.0)), static_cast<float>(view.depthFromDistance(900.0))}, view);
    EXPECT_EQ(distances[0], kNothing);
    EXPECT_NEAR(distances[1], 0.5F, 1e-6);
    EXPECT_NEAR(distances[2], 7.0F, 1e-5);
    EXPECT_NEAR(distances[3], 900.0F, 1e-2);
}

}  // namespace
}  // namespace cullscope::picture_file_test
