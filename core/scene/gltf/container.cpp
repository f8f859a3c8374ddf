#include "core/scene/gltf/container.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/error.h"

namespace cullscope::gltf {
namespace {

constexpr size_t kHeaderBytes = 12, kChunkBytes = 8;
constexpr uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

uint32_t wholeAt(std::string_view content, size_t byte) {
    uint32_t value = 0;
    std::memcpy(&value, content.data() + byte, sizeof(value));
    return value;
}

/// Memory that tinygltf takes for one object (a material is the largest) and for one value, with the growth of arrays.
constexpr uint64_t kBytesOfObject = 4096, kBytesOfValue = 400, kBytesOfLetter = 4;

/// Walks JSON text once, without judging whether it is JSON.
class JsonWalk {
public:
    JsonWalk(char* json, size_t length, size_t firstByte, const std::string& fileName)
        : m_json(json), m_length(length), m_firstByte(firstByte), m_fileName(fileName) {}

    void walk() {
        for (size_t at = 0; at < m_length; ++at) switch (m_json[at]) {
                case '"':
                    at = passString(at);
                    break;
                case '{':
                case '[':
                    open(at);
                    break;
                case '}':
                case ']':
                    if (m_depth > 0) --m_depth;
                    break;
                case ',':
                case ':':
                    ++values;
                    break;
                default:
                    break;
            }
    }

    uint64_t objects = 0, values = 0, buffers = 0;

private:
    /// From the quotation mark of a string to that at its end. Names of the file's sections are noticed.
    size_t passString(size_t at) {
        size_t end = at + 1;
        while (end < m_length && m_json[end] != '"') end += m_json[end] == '\\' ? 2 : 1;
        if (m_depth == 1 && end < m_length && namesSection(end + 1)) {
            m_section.assign(m_json + at + 1, end - at - 1);
            constexpr std::array<std::string_view, 4> kNotShown{"images", "textures", "materials", "samplers"};
            if (std::ranges::find(kNotShown, m_section) != kNotShown.end()) m_json[at + 1] = '-';
        }
        return end;
    }

    [[nodiscard]] bool namesSection(size_t at) const {
        while (at < m_length && std::strchr(" \t\r\n", m_json[at]) != nullptr && m_json[at] != '\0') ++at;
        return at < m_length && m_json[at] == ':';
    }

    void open(size_t at) {
        constexpr size_t kDepthInSection = 2;  // within the file's object and the section's array
        if (m_json[at] == '{') {
            ++objects;
            if (m_depth == kDepthInSection && m_section == "buffers") ++buffers;
        }
        if (++m_depth > kDeepest)
            throwInput(CULLSCOPE_TR("%1, byte %2: objects and arrays lie deeper in each other than %3. Export the file again."),
                       {m_fileName, std::to_string(m_firstByte + at), std::to_string(kDeepest)});
    }

    char* m_json;
    size_t m_length, m_firstByte, m_depth = 0;
    const std::string& m_fileName;
    std::string m_section;
};

}  // namespace

Container containerOf(std::string_view content, const std::string& fileName) {
    const auto refuse = [&](size_t byte, std::string_view sentence, uint64_t more = 0) {
        throwInput(sentence, {fileName, std::to_string(byte), std::to_string(more)});
    };
    if (!content.starts_with("glTF")) return {content, {}, false};
    if (content.size() < kHeaderBytes + kChunkBytes)
        refuse(content.size(),
               CULLSCOPE_TR("%1 ends at byte %2, before everything that it promises. The file was cut off: fetch it again."));
    if (const uint32_t version = wholeAt(content, 4); version != 2)
        refuse(4, CULLSCOPE_TR("%1, byte %2: this is glTF of version %3; only version 2 is read. Export the scene as glTF 2.0."),
               version);
    const uint32_t length = wholeAt(content, 8);
    const auto chunkAt = [&](size_t byte) {
        const uint32_t bytes = wholeAt(content, byte);
        if (byte + kChunkBytes + uint64_t{bytes} > length)
            refuse(byte,
                   CULLSCOPE_TR("%1, byte %2: a chunk is to have %3 bytes, more than the file. The file was cut off or changed: "
                                "fetch it again."),
                   bytes);
        return content.substr(byte + kChunkBytes, bytes);
    };
    if (length > content.size())
        refuse(8, CULLSCOPE_TR("%1, byte %2: the file is to have %3 bytes and has fewer. The file was cut off: fetch it again."),
               length);
    if (length < kHeaderBytes + kChunkBytes || wholeAt(content, kHeaderBytes + 4) != kJsonChunk)
        refuse(kHeaderBytes, CULLSCOPE_TR("%1, byte %2: a chunk of JSON must stand here. Export the file again."));
    Container container{chunkAt(kHeaderBytes), {}, true};
    if (container.json.size() % 4 != 0)
        refuse(kHeaderBytes,
               CULLSCOPE_TR("%1, byte %2: the chunk has %3 bytes, which is no multiple of 4. Export the file again."),
               container.json.size());
    const size_t next = kHeaderBytes + kChunkBytes + container.json.size();
    if (next + kChunkBytes <= length && wholeAt(content, next + 4) == kBinaryChunk) container.binary = chunkAt(next);
    return container;
}

void prepareJson(char* json, size_t length, size_t firstByte, size_t binaryBytes, const std::string& fileName,
                 const RequireMemory& requireMemory) {
    JsonWalk walk(json, length, firstByte, fileName);
    walk.walk();
    requireMemory(kBytesOfObject * walk.objects + kBytesOfValue * walk.values + kBytesOfLetter * length +
                  walk.buffers * binaryBytes);
}

}  // namespace cullscope::gltf
