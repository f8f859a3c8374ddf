// What is read of a picture's file, and by which reader.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <tuple>

#include "core/image/jpeg_scans.h"
#include "core/image/picture_file.h"
#include "core/image/stated_lengths.h"
#include "tests/support/peak_memory.h"
#include "tests/support/refusal.h"

namespace cullscope::picture_reading_test {
namespace {

using testing::HasSubstr;

class PictureReading : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(m_folder); }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return m_folder / name; }

private:
    std::filesystem::path m_folder =
        std::filesystem::temp_directory_path() / ("cullscope-picture-reading-" + std::to_string(getpid()));
};

std::string textOf(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

Picture smallPicture() { return {{16, 5}, std::vector<uint8_t>(16 * 5 * 4, 200), {}}; }

/// A file's bytes with another size stated: 16384 x 16384.
std::string claimingMore(std::string bytes, const std::string& ending) {
    const auto put = [&](size_t place, uint32_t value, bool bigEndian) {
        for (size_t byte = 0; byte < 4; ++byte)
            bytes[place + byte] = static_cast<char>(value >> 8 * (bigEndian ? 3 - byte : byte));
    };
    if (ending == "png") {
        for (const size_t place : {size_t{16}, size_t{20}}) put(place, 16384, true);
        uint32_t crc = ~uint32_t{0};  // of the chunk's type and content (ISO 3309)
        for (size_t i = 12; i < 29; ++i) {
            crc ^= static_cast<unsigned char>(bytes[i]);
            for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
        }
        put(29, ~crc, true);
    } else {
        for (const std::string_view window : {"dataWindow", "displayWindow"}) {
            const size_t place = bytes.find(window) + window.size() + sizeof("box2i") + 5;  // past type and length
            for (const size_t corner : {place + 8, place + 12}) put(corner, 16383, false);
        }
    }
    return bytes;
}

TEST_F(PictureReading, metadataTakesNoMemoryForThePixelsThatAFileClaims) {
    Picture picture = smallPicture();
    picture.metadata = {{"cullscope:scene", "bunny"}};
    for (const std::string ending : {"png", "exr"}) {
        writePicture(file("a." + ending), picture);
        const std::filesystem::path claiming = file("b." + ending);
        std::ofstream(claiming, std::ios::binary) << claimingMore(textOf(file("a." + ending)), ending);
        std::string found;
        try {
            for (const auto& [name, text] : readPictureMetadata(claiming))
                if (name == "cullscope:scene") found = text;
        } catch (const Error& error) {
            // A reader may find that a file is too short for its size, before it takes memory for it.
            EXPECT_THAT(error.what(), HasSubstr("is no picture that can be read"));
            EXPECT_EQ(ending, "exr");
            found = "bunny";
        }
        EXPECT_EQ(found, "bunny") << ending;
        if (!test::memoryIsTheWorks()) continue;
        EXPECT_LT(test::peakBytesOf([&] { (void)readPictureMetadata(claiming); }), size_t{16} << 20) << ending;
    }
}

/// A JPEG's header by hand: its frame of that kind (SOF0: 0xC0, SOF2: 0xC2), then a scan of so many of its three components.
std::string jpegHeader(char frame, int width, int height, char ofScan) {
    const auto number = [](int value) { return std::string{static_cast<char>(value >> 8), static_cast<char>(value)}; };
    std::string bytes = "\xff\xd8\xff\xfe" + number(5) + "abc\xff\xff";
    bytes += frame + number(17) + "\x08" + number(height) + number(width) + "\x03";
    for (char component = 1; component <= 3; ++component) bytes += {component, 0x11, 0};
    bytes += "\xff\xda" + number(6 + 2 * ofScan) + ofScan;
    for (char component = 1; component <= ofScan; ++component) bytes += {component, 0};
    return bytes + std::string(3, '\0') + "\xff\xd9";
}

TEST_F(PictureReading, largeJpegsInSeveralScansAreRefused) {
    const auto write = [&](const std::string& bytes) { std::ofstream(file("a.jpg"), std::ios::binary) << bytes; };
    for (const auto& [frame, ofScan] : {std::pair{'\xc2', char{3}}, {'\xc2', char{1}}, {'\xc0', char{1}}}) {
        write(jpegHeader(frame, 16384, 16000, ofScan));
        EXPECT_EQ(sizeKeptWhole(file("a.jpg")), (Viewport{16384, 16000}));
        const auto read = [&] { (void)readPictureMetadata(file("a.jpg")); };
        EXPECT_THAT(test::refusalOf(read, ErrorKind::Input), HasSubstr("a progressive JPEG of 16384x16000 pixels takes memory"));
    }
    write(jpegHeader('\xc0', 16384, 16000, 3));
    EXPECT_EQ(sizeKeptWhole(file("a.jpg")), std::nullopt) << "row after row";
    for (const std::string& broken : {std::string(), std::string("\xff\xd8"), jpegHeader('\xc2', 1, 1, 1).substr(0, 15)}) {
        write(broken);
        EXPECT_EQ(sizeKeptWhole(file("a.jpg")), std::nullopt);
    }
    writePicture(file("b.jpg"), smallPicture());
    EXPECT_EQ(sizeKeptWhole(file("b.jpg")), std::nullopt);
}

TEST_F(PictureReading, lengthsInTheHeaderOfAnExrThatItsValuesHaveNotAreRefused) {
    Picture picture = smallPicture();
    picture.metadata = {{"cullscope:scene", "bunny"}};
    writePicture(file("a.exr"), picture);
    EXPECT_FALSE(statesWrongLength(PictureFormat::Exr, file("a.exr")));
    const std::string exr = textOf(file("a.exr"));
    const std::string text("scene\0string\0", 13), channels("chlist\0", 7), window("box2i\0", 6);
    for (const auto& [before, stated] : {std::pair{text, '\x7f'}, {channels, '\0'}, {window, '\0'}}) {
        std::string changed = exr;
        const size_t lowest = changed.find(before) + before.size();
        changed[lowest + (stated == '\0' ? 0 : 3)] = stated;
        std::ofstream(file("b.exr"), std::ios::binary) << changed;
        EXPECT_TRUE(statesWrongLength(PictureFormat::Exr, file("b.exr"))) << before;
        const auto read = [&] { (void)readPictureMetadata(file("b.exr")); };
        EXPECT_THAT(test::refusalOf(read, ErrorKind::Input), HasSubstr("states a length"));
    }
    for (const std::string& broken : {std::string(), exr.substr(0, 20), std::string("\x76\x2f\x31\x01")}) {
        std::ofstream(file("b.exr"), std::ios::binary) << broken;
        EXPECT_FALSE(statesWrongLength(PictureFormat::Exr, file("b.exr"))) << "its reader says that it is cut off";
    }
}

TEST_F(PictureReading, chunkOfAPngThatEndsBeyondTheFileIsRefused) {
    Picture picture = smallPicture();
    picture.metadata = {{"cullscope:scene", "bunny"}};
    writePicture(file("a.png"), picture);
    EXPECT_FALSE(statesWrongLength(PictureFormat::Png, file("a.png")));
    const std::string png = textOf(file("a.png"));
    std::string changed = png;
    changed[changed.find("tEXt") - 4] = '\x70';
    std::ofstream(file("b.png"), std::ios::binary) << changed;
    EXPECT_THAT(test::refusalOf([&] { (void)readPictureMetadata(file("b.png")); }, ErrorKind::Input),
                HasSubstr("states a length"));
    // Its pixels are cut off, and what describes them is not.
    std::ofstream(file("c.png"), std::ios::binary) << png.substr(0, png.find("IDAT") + 8);
    EXPECT_FALSE(statesWrongLength(PictureFormat::Png, file("c.png")));
    EXPECT_EQ(readPictureMetadata(file("c.png")).at(0).second, "bunny");
}

TEST_F(PictureReading, metadataIsThatOfTheWholePicture) {
    for (const char* ending : {"png", "jpg", "tif", "exr"}) {
        const std::filesystem::path path = file(std::string("a.") + ending);
        Picture picture = smallPicture();
        picture.metadata = {{"cullscope:scene", "/tmp/절두체.obj"}, {"cullscope:session", std::string(20'000, 'x')}};
        writePicture(path, picture);
        EXPECT_EQ(readPictureMetadata(path), readPicture(path).metadata);
        EXPECT_THAT(readPictureMetadata(path), testing::IsSupersetOf(picture.metadata)) << ending;
    }
}

TEST_F(PictureReading, isReadByTheFormatOfItsNameAndItsFirstBytesAlone) {
    writePicture(file("a.png"), smallPicture());
    const std::string png = textOf(file("a.png"));
    // The smallest GIF: the library has a reader for it, which must not see it.
    const std::string gif("GIF89a\1\0\1\0\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0\1\0\1\0\0\2\2D\1\0;", 35);
    for (const auto& [name, bytes, said] :
         {std::tuple{"gif.png", gif, "its name says PNG, and it does not begin as such a file does"},
          {"png.jpg", png, "its name says JPEG"},
          {"png.tif", png, "its name says TIFF"},
          {"png.exr", png, "its name says EXR"},
          {"a.gif", gif, "its name ends neither in .png"},
          {"a", png, "its name ends neither in .png"}}) {
        const std::filesystem::path path = file(name);
        std::ofstream(path, std::ios::binary) << bytes;
        for (const std::function<void()>& read : {std::function<void()>([&] { (void)readPicture(path); }),
                                                  std::function<void()>([&] { (void)readPictureMetadata(path); })})
            EXPECT_THAT(test::refusalOf(read, ErrorKind::Input), HasSubstr(said)) << name;
    }
}

}  // namespace
}  // namespace cullscope::picture_reading_test
