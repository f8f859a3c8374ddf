#pragma once

#include <bit>
#include <initializer_list>
#include <string>

#include "core/geometry/types.h"

namespace cullscope::test {

/// Writes records; each knows where the next one begins only when it ends.
class RvmBytes {
public:
    RvmBytes& begin(const std::string& letters) {
        for (const char letter : letters) whole(uint32_t(letter));
        m_nextAt = m_bytes.size();
        return whole(0).whole(1);
    }
    RvmBytes& end() {
        const auto next = uint32_t(m_bytes.size());
        for (size_t i = 0; i < 4; ++i) m_bytes[m_nextAt + i] = char(next >> (24 - 8 * i));
        return *this;
    }
    RvmBytes& whole(uint32_t value) {
        for (int i = 3; i >= 0; --i) m_bytes.push_back(char(value >> (8 * i)));
        return *this;
    }
    RvmBytes& numbers(std::initializer_list<double> values) {
        for (const double value : values) whole(std::bit_cast<uint32_t>(float(value)));
        return *this;
    }
    RvmBytes& text(std::string value) {
        value.resize((value.size() / 4 + 1) * 4, '\0');
        whole(uint32_t(value.size() / 4));
        m_bytes += value;
        return *this;
    }
    RvmBytes& head() {
        begin("HEAD").whole(2);
        for (const char* each : {"program", "note", "date", "user", "Unicode UTF-8"}) text(each);
        return end().begin("MODL").whole(1).text("project").text("name").end();
    }
    RvmBytes& group(const std::string& name) { return begin("CNTB").whole(2).text(name).numbers({0, 0, 0}).whole(13).end(); }
    RvmBytes& endGroup() { return begin("CNTE").whole(2).end(); }
    /// A primitive in millimetres, at a place in metres.
    RvmBytes& primitive(uint32_t kind, std::initializer_list<double> sizes, const Vec3& place = Vec3(0),
                        const char* letters = "PRIM", double mirror = 1.0) {
        beginPrimitive(kind, place, letters, mirror);
        return numbers(sizes).end();
    }
    RvmBytes& beginPrimitive(uint32_t kind, const Vec3& place, const char* letters = "PRIM", double mirror = 1.0) {
        begin(letters).whole(1).whole(kind);
        numbers({0.001 * mirror, 0, 0, 0, 0.001, 0, 0, 0, 0.001, place.x, place.y, place.z}).numbers({0, 0, 0, 0, 0, 0});
        return std::string(letters) == "PRIM" ? *this : whole(0);
    }
    RvmBytes& finish() { return begin("END:").end(); }
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
    size_t m_nextAt = 0;
};

/// One of everything that a file can hold.
inline std::string rvmSample() {
    RvmBytes file;
    file.head().group("/SITE").group("/PUMP");
    file.primitive(1, {1000, 800, 500, 400, 100, 0, 600}).primitive(2, {100, 200, 300}, {1, 0, 0});
    file.primitive(3, {400, 500, 100, 1.5}, {2, 0, 0}).primitive(4, {500, 50, 1.57}, {3, 0, 0});
    file.endGroup().group("/VESSEL");
    file.primitive(5, {500, 250}).primitive(6, {500, 100}, {2, 0, 0});
    file.primitive(7, {500, 300, 800, 100, 0, 0.1, 0, 0, -0.1}, {4, 0, 0}).primitive(9, {400}, {6, 0, 0}, "INSU");
    file.endGroup().group("/PIPE").primitive(8, {50, 2000}).endGroup();
    file.group("/PIPE").primitive(8, {50, 2000}, {5, 5, 5}).endGroup();
    file.group("/PIPE").primitive(8, {50, 2000}, {6, 6, 6}, "OBST", -1.0).endGroup();
    file.group("/DRAWING").primitive(10, {-100, 100}).endGroup();
    file.group("/PLATE").beginPrimitive(11, {0, 0, 3}).whole(1).whole(2);
    file.whole(4).numbers({0, 0, 0, 0, 0, 1, 1000, 0, 0, 0, 0, 1, 1000, 1000, 0, 0, 0, 1, 0, 1000, 0, 0, 0, 1});
    file.whole(4).numbers({250, 250, 0, 0, 0, 1, 250, 750, 0, 0, 0, 1, 750, 750, 0, 0, 0, 1, 750, 250, 0, 0, 0, 1}).end();
    file.endGroup().endGroup().begin("COLR").whole(1).whole(13).whole(0xff00ff00).end().finish();
    return file.bytes();
}

}  // namespace cullscope::test
