#include <cstdio>
#include <map>
#include <set>
#include <span>

#include "core/geometry/random.h"
#include "core/gpu/colour.h"
#include "core/image/view_picture.h"
#include "core/measure/reference.h"
#include "core/mesh/parametric.h"
#include "tests/support/colour_difference.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

// Verdict colours can be distinguished: any two that are neighbours in a picture of the field differ by ΔE₀₀ ≥ 8, with normal
// colour vision, in grey and with each of three colour-vision deficiencies, on the light and on the dark background.

namespace cullscope::test::verdict_colour_test {
namespace {

constexpr double kLeastDifference = 8.0;
const std::array<Vec3f, 2> kBackgrounds{Vec3f(1.0f), Vec3f(0x14, 0x17, 0x1C) / 255.0f};

constexpr int kBackground = int(kTriangleStateCount);
const char* nameOf(int label) {
    return label == kBackground ? "background" : triangleStateName(static_cast<TriangleState>(label));
}

ScenePointer field(int n, double spacing) {
    std::vector<Mat4> places;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) places.push_back(translation(Vec3(i - (n - 1) / 2.0, 0, j - (n - 1) / 2.0) * spacing));
    return copiesOf(sphereMesh(500), places);
}

View observer() { return {{{9, 8, 14}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.5, 100}, {480, 360}}; }

TriangleStates statesOf(const ScenePointer& scene, const char* id, const Vec3& eye) {
    const View culling({eye, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.05, 100}, {320, 240});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const CullerPointer strategy = makeCuller(id);
    strategy->build(*scene);
    const Culled frame = strategy->cull(culling, Recording::On);
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), buffers, culling, strategy->referenceFacing());
    return triangleStates(*scene, frame.log, truth.visible());
}

/// States that no strategy produces: each object has one of these at random, so that all are neighbours in the picture.
TriangleStates everyState(const Scene& scene, const std::vector<TriangleState>& of) {
    TriangleStates states;
    Random random(3);
    for (size_t i = 0; i < scene.instances().size(); ++i)
        states.states.insert(states.states.end(), scene.meshOf(i).triangleCount(), of[random.bits() % of.size()]);
    return states;
}

/// A picture by verdict, with the state of every pixel.
class LabelledPicture {
public:
    LabelledPicture(const ScenePointer& scene, const std::vector<TriangleState>& states, const Vec3f& background)
        : m_buffers(scene, Upload::Vbo), m_background(background), m_states(states) {
        m_palette = verdictPalette(background);
        m_colours = drawn(m_palette);
        m_labels.assign(m_colours.size() / 4, kBackground);
        const auto items = GlEnvironment::renderer().drawItemBuffer(m_buffers, observer(), everything(*scene, Facing::TwoSided));
        m_own.assign(m_labels.size(), 0);
        for (size_t i = 0; i < m_labels.size(); ++i) label(i, items.triangle[i]);
        for (size_t state = 0; state < m_palette.size(); ++state) labelByColour(state);
    }

    [[nodiscard]] const std::vector<int>& labels() const { return m_labels; }
    /// The mean colour of a label's pixels, in linear light. A halo counts only where no other pixel of its state is visible.
    [[nodiscard]] Vec3 mean(int wanted) const {
        std::array<Vec3, 2> sums{Vec3(0.0), Vec3(0.0)};
        std::array<size_t, 2> pixels{};
        for (size_t i = 0; i < m_labels.size(); ++i) {
            if (m_labels[i] != wanted) continue;
            sums[m_own[i]] += linearOf(Vec3(m_colours[4 * i], m_colours[4 * i + 1], m_colours[4 * i + 2]) / 255.0);
            ++pixels[m_own[i]];
        }
        const size_t counted = pixels[1] > 0 ? 1 : 0;
        return sums[counted] / double(pixels[counted]);
    }
    [[nodiscard]] std::map<std::pair<int, int>, size_t> neighbours() const {
        std::map<std::pair<int, int>, size_t> pairs;
        const auto width = size_t(observer().viewport().width);
        for (size_t i = 0; i < m_labels.size(); ++i)
            for (const size_t next : {i + 1, i + width}) {
                if (next >= m_labels.size() || (next == i + 1 && next % width == 0) || m_labels[i] == m_labels[next]) continue;
                ++pairs[std::minmax(m_labels[i], m_labels[next])];
            }
        return pairs;
    }

private:
    using VerdictPalette = std::array<PaletteEntry, kTriangleStateCount>;

    [[nodiscard]] std::vector<uint8_t> drawn(const VerdictPalette& palette) const {
        Framebuffer target(observer().viewport());
        std::vector<uint8_t> bytes;
        for (const TriangleState state : m_states) bytes.push_back(uint8_t(state));
        GlEnvironment::renderer().drawByState(m_buffers, observer(), Facing::TwoSided, bytes, palette, target, {m_background});
        return target.readColour();
    }
    /// Hatch and halo have no colour of their own: a pixel that is not background and does not change with any state's colour
    /// belongs to a mark.
    void label(size_t pixel, uint32_t item) {
        const Vec3f colour = Vec3f(m_colours[4 * pixel], m_colours[4 * pixel + 1], m_colours[4 * pixel + 2]) / 255.0f;
        m_own[pixel] = item != 0 && m_states[item - 1] == TriangleState::WronglyCulled ? 1 : 0;
        if (m_own[pixel] != 0 || glm::distance(colour, m_background) > 1.0f / 512)
            m_labels[pixel] = int(TriangleState::WronglyCulled);
    }
    /// The pixels that change with a state's colour are that state's.
    void labelByColour(size_t state) {
        VerdictPalette changed = m_palette;
        changed[state].colour = Vec3f(1.0f) - changed[state].colour;
        const std::vector<uint8_t> other = drawn(changed);
        for (size_t i = 0; i < m_labels.size(); ++i) {
            if (std::equal(&m_colours[4 * i], &m_colours[4 * i] + 4, &other[4 * i])) continue;
            m_labels[i] = int(state);
            m_own[i] = 1;
        }
    }

    SceneBuffers m_buffers;
    Vec3f m_background;
    const std::vector<TriangleState>& m_states;
    VerdictPalette m_palette;
    std::vector<uint8_t> m_colours;
    std::vector<int> m_labels;
    std::vector<uint8_t> m_own;  ///< surface, hatch or line of a state; 0: background or halo
};

/// Checks every pair of neighbours; returns the states that occur.
std::set<int> check(const LabelledPicture& picture, const char* what) {
    std::array<Vec3, kTriangleStateCount + 1> means;
    for (int label = 0; label <= kBackground; ++label) means[size_t(label)] = picture.mean(label);
    std::set<int> occurring;
    double least = 1e9;
    for (const auto& [pair, pixels] : picture.neighbours()) {
        const auto& [a, b] = pair;
        occurring.insert({a, b});
        for (const Sight& sight : sights()) {
            const double difference = ciede2000(labOf(sight.seen(means[size_t(a)])), labOf(sight.seen(means[size_t(b)])));
            least = std::min(least, difference);
            EXPECT_GE(difference, kLeastDifference)
                << what << ", " << sight.name << ": " << nameOf(a) << " and " << nameOf(b) << " (" << pixels << " times)";
        }
    }
    std::printf("verdict colours: %s: least difference of neighbours %.1f\n", what, least);
    return occurring;
}

TEST(Ciede2000, givesThePublishedPairs) {
    // Table 1 of Sharma, Wu & Dalal 2005.
    struct Row {
        Lab first, second;
        double difference;
    };
    const std::vector<Row> rows{
        {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
        {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
        {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
        {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
        {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
        {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
        {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
        {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
        {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
        {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
        {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
        {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
        {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
        {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
        {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
        {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
        {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
        {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
        {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
        {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
        {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
        {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
        {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
    };
    for (const Row& row : rows) {
        EXPECT_NEAR(ciede2000(row.first, row.second), row.difference, 5e-5) << row.first.a << " " << row.second.a;
        EXPECT_NEAR(ciede2000(row.second, row.first), row.difference, 5e-5);
    }
}

TEST(VerdictColours, neighboursInAPictureOfTheFieldAreToldApart) {
    const ScenePointer scene = field(8, 2.5);
    for (const char* id : {"frustum", "backface"})
        for (const Vec3f& background : kBackgrounds) {
            const std::string what = std::string(id) + (isLight(background) ? " on light" : " on dark");
            const TriangleStates states = statesOf(scene, id, {1.2, 1, 12});
            const std::set<int> occurring = check({scene, states.states, background}, what.c_str());
            EXPECT_THAT(occurring, testing::IsSupersetOf({int(TriangleState::Visible), int(TriangleState::InVain),
                                                          int(TriangleState::BackFacing), kBackground}));
            EXPECT_EQ(occurring.contains(int(TriangleState::OutsideFrustum)), std::string(id) == "frustum");
        }
}

TEST(VerdictColours, anyTwoStatesAreToldApartBesideEachOther) {
    using enum TriangleState;
    // A whole frame beside the truth, and the first entries of a frame, which know no truth.
    const std::vector<TriangleState> whole{Visible, InVain, OutsideFrustum, BackFacing, Hidden, TooSmall, WronglyCulled};
    const std::vector<TriangleState> part{Visible, OutsideFrustum, BackFacing, Hidden, TooSmall, Undecided};
    const ScenePointer scene = field(14, 1.4);
    for (const std::vector<TriangleState>& of : {whole, part})
        for (const Vec3f& background : std::span(kBackgrounds).first(fewSamples() ? 1 : kBackgrounds.size())) {
            const TriangleStates states = everyState(*scene, of);
            const LabelledPicture picture(scene, states.states, background);
            EXPECT_EQ(check(picture, isLight(background) ? "all states on light" : "all states on dark").size(), of.size() + 1);
            EXPECT_EQ(picture.neighbours().size(), (of.size() + 1) * of.size() / 2) << "not every pair meets";
        }
}

}  // namespace
}  // namespace cullscope::test::verdict_colour_test
