#include "core/scene/rvm/rvm_records.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/error.h"

namespace cullscope::rvm {
namespace {

constexpr size_t kHeaderBytes = 24;  ///< of a record: four letters, the next record's place, a number without a known meaning
constexpr uint32_t kLongestName = 1 << 16;  ///< in words of four bytes
constexpr size_t kDeepest = 1000;

uint32_t bigEndian(const char* bytes) {
    uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | uint8_t(bytes[i]);
    return value;
}

/// The letters of a record's name, each in a word of its own; empty where these are no letters.
std::string lettersAt(std::string_view bytes) {
    std::string letters;
    for (size_t i = 0; i < 4; ++i) {
        const uint32_t letter = bigEndian(bytes.data() + 4 * i);
        if (letter < 0x20 || letter > 0x7e) return {};
        letters.push_back(char(letter));
    }
    return letters;
}

class Reader {
public:
    Reader(ByteSource& source, const Visitor& visitor) : m_source(source), m_visitor(visitor) {}

    void read() {
        beginRecord();
        if (m_letters != "HEAD") refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: an RVM file begins with a record HEAD."));
        endRecord();
        beginRecord();
        if (m_letters != "MODL") refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: the record MODL is missing after HEAD."));
        endRecord();
        for (;;) {
            beginRecord();
            if (m_letters == "END:") break;
            if (m_letters == "CNTB")
                beginGroup();
            else if (m_letters == "CNTE")
                endGroup();
            else if (m_letters == "PRIM" || m_letters == "OBST" || m_letters == "INSU")
                readPrimitive();
            else if (m_letters != "COLR")
                refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: the record \"%3\" is unknown. Export the file again."), m_letters);
            endRecord();
        }
        if (m_depth > 0) refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: the file ends within a group."));
    }

private:
    [[noreturn]] void refuseAt(uint64_t byte, std::string_view sentence, const std::string& more = {}) const {
        throwInput(sentence, {m_source.name(), std::to_string(byte), more});
    }
    [[noreturn]] void refuse(std::string_view sentence, const std::string& more = {}) const {
        refuseAt(m_source.position(), sentence, more);
    }

    /// The next bytes of the record in hand.
    std::string_view bytes(size_t count) {
        if (m_source.position() + count > m_end)
            refuse(CULLSCOPE_TR("%1, byte %2: the record %3 is too short for what it holds."), m_letters);
        const std::string_view got = m_source.peek(count);
        if (got.size() < count) refuseEnd();
        return got.substr(0, count);
    }
    [[noreturn]] void refuseEnd() const {
        refuse(CULLSCOPE_TR("%1, byte %2: the file breaks off within a record. Fetch or export it again."));
    }

    uint32_t whole() {
        const uint32_t value = bigEndian(bytes(4).data());
        m_source.skip(4);
        return value;
    }
    double number() {
        const uint64_t at = m_source.position();
        const double value = std::bit_cast<float>(whole());
        if (!std::isfinite(value)) refuseAt(at, CULLSCOPE_TR("%1, byte %2: here is no number but an infinity or NaN."));
        return value;
    }
    Vec2 pair() {
        const double x = number();
        return {x, number()};
    }
    Vec3 triple() {
        const Vec2 xy = pair();
        return {xy, number()};
    }
    Angle angle() { return Angle::fromRadians(number()); }

    std::string text() {
        const uint64_t at = m_source.position();
        const uint32_t words = whole();
        if (words > kLongestName)
            refuseAt(at, CULLSCOPE_TR("%1, byte %2: here is a text of %3 words, too long to be one."), std::to_string(words));
        const std::string_view got = bytes(size_t{4} * words);
        std::string text(got.substr(0, std::min(got.find('\0'), got.size())));
        m_source.skip(size_t{4} * words);
        return text;
    }

    /// A count of items of at least `least` bytes each, of which the record has room for no more than it has bytes.
    uint32_t count(uint64_t least) {
        const uint64_t at = m_source.position();
        const uint32_t count = whole();
        if (count * least > m_end - m_source.position())
            refuseAt(at, CULLSCOPE_TR("%1, byte %2: here are to be %3 items, more than the record has room for."),
                     std::to_string(count));
        return count;
    }

    void beginRecord() {
        m_begin = m_source.position();
        const std::string_view header = m_source.peek(kHeaderBytes);
        if (header.size() < kHeaderBytes)
            refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: the file breaks off before its record END."));
        m_letters = lettersAt(header);
        if (m_letters.empty()) refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: no record of an RVM file begins here."));
        m_end = bigEndian(header.data() + 16);
        if (m_letters == "END:") return;
        if (m_end < m_begin + kHeaderBytes || m_end > m_source.size())
            refuseAt(m_begin + 16,
                     CULLSCOPE_TR(
                         "%1, byte %2: the next record is said to begin at byte %3, which is not after this one in the file."),
                     std::to_string(m_end));
        m_source.skip(kHeaderBytes);
    }

    /// What a record has beyond what is known of it is passed over.
    void endRecord() { m_source.skip(m_end - m_source.position()); }

    void beginGroup() {
        if (++m_depth > kDeepest)
            refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: groups lie deeper in each other than %3."), std::to_string(kDeepest));
        (void)whole();  // version
        m_visitor.beginGroup(text());
        // A reference point and a colour follow; the primitives' transforms lead to the world by themselves.
    }

    void endGroup() {
        if (m_depth == 0) refuseAt(m_begin, CULLSCOPE_TR("%1, byte %2: a group ends that has not begun."));
        --m_depth;
        m_visitor.endGroup();
    }

    void readPrimitive() {
        Record record;
        record.byte = m_begin;
        (void)whole();  // version
        const uint64_t kindAt = m_source.position();
        const uint32_t kind = whole();
        for (int column = 0; column < 4; ++column) record.worldFromRecord[column] = Vec4(triple(), column == 3 ? 1.0 : 0.0);
        const Vec3 low = triple();
        record.box = {low, triple()};
        if (m_letters != "PRIM") (void)whole();  // translucency of obstructions and insulation
        readShape(record, kind, kindAt);
        m_visitor.primitive(std::move(record));
    }

    void readShape(Record& record, uint32_t kind, uint64_t kindAt);
    void readFacets(Record& record);

    ByteSource& m_source;
    const Visitor& m_visitor;
    std::string m_letters;
    uint64_t m_begin = 0, m_end = 0;  ///< of the record in hand
    size_t m_depth = 0;
};

primitive::Primitive snout(double bottom, double top, double height, const Vec2& offset, const primitive::Mitre& low,
                           const primitive::Mitre& high) {
    const bool mitred = low.x != Angle() || low.y != Angle() || high.x != Angle() || high.y != Angle();
    if (offset != Vec2(0.0) || (mitred && bottom != top)) return primitive::EccentricCone{bottom, top, height, offset, low, high};
    if (mitred) return primitive::MitredCylinder{bottom, height, low, high};
    return primitive::Cone{bottom, top, height};
}

void Reader::readShape(Record& record, uint32_t kind, uint64_t kindAt) {
    using namespace cullscope::primitive;  // Sphere is the name of a bounding sphere, too
    switch (kind) {
        case 1: {
            const Vec2 bottom = pair(), top = pair(), offset = pair();
            const double height = number();
            if (top == Vec2(0.0))
                record.solid = Pyramid{bottom, height, offset};
            else
                record.solid = PyramidFrustum{bottom, top, height, offset};
            return;
        }
        case 2:
            record.solid = Box{triple()};
            return;
        case 3: {
            const Vec2 radii = pair();
            const double height = number();
            record.solid = RectangularTorus{radii.x, radii.y, height, angle()};
            return;
        }
        case 4: {
            const Vec2 radii = pair();
            record.solid = CircularTorus{radii.x, radii.y, angle()};
            return;
        }
        case 5: {
            const Vec2 sizes = pair();
            record.solid = EllipsoidalDish{sizes.x, sizes.y};
            return;
        }
        case 6: {
            const Vec2 sizes = pair();
            record.solid = SphericalDish{sizes.x, sizes.y};
            return;
        }
        case 7: {
            const Vec2 radii = pair();
            const double height = number();
            const Vec2 offset = pair(), low = pair(), high = pair();
            const auto mitre = [](const Vec2& angles) {
                return Mitre{Angle::fromRadians(angles.x), Angle::fromRadians(angles.y)};
            };
            record.solid = snout(radii.x, radii.y, height, offset, mitre(low), mitre(high));
            return;
        }
        case 8: {
            const Vec2 sizes = pair();
            record.solid = Cylinder{sizes.x, sizes.y};
            return;
        }
        case 9:
            record.solid = primitive::Sphere{0.5 * number()};
            return;
        case 10:
            record.kind = Record::Kind::Line;
            record.line = pair();
            return;
        case 11:
            record.kind = Record::Kind::Facets;
            return readFacets(record);
        default:
            refuseAt(kindAt, CULLSCOPE_TR("%1, byte %2: there is no primitive of kind %3."), std::to_string(kind));
    }
}

void Reader::readFacets(Record& record) {
    constexpr uint64_t kCornerBytes = 24;
    const uint32_t polygons = count(4);
    for (uint32_t p = 0; p < polygons; ++p) {
        Polygon polygon;
        const uint32_t contours = count(4);
        for (uint32_t c = 0; c < contours; ++c) {
            const uint32_t corners = count(kCornerBytes);
            std::vector<Vec3> contour;
            contour.reserve(corners);
            for (uint32_t corner = 0; corner < corners; ++corner) {
                contour.push_back(triple());
                (void)triple();  // the polygon's normal follows from its corners
            }
            polygon.contours.push_back(std::move(contour));
        }
        record.polygons.push_back(std::move(polygon));
    }
}

}  // namespace

bool isRvm(ByteSource& source) {
    const std::string_view start = source.peek(16);
    return start.size() >= 16 && lettersAt(start) == "HEAD";
}

void readRecords(ByteSource& source, const Visitor& visitor) { Reader(source, visitor).read(); }

}  // namespace cullscope::rvm
