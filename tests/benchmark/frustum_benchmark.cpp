// Boxes and spheres a second by the frustum tests: the naive loop, the batch on every level, the hierarchy, and merely reading.
//
//   frustum_benchmark FOLDER [LARGEST]    up to 1e7 objects, or LARGEST; table and plots are written to FOLDER
//
// Ratios count: all variants run in turns. Exit status 1 where what is promised of them does not hold.
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/base/atomic_file.h"
#include "core/image/line_plot.h"
#include "tests/benchmark/frustum_benchmark.h"

namespace {

using namespace cullscope;
using namespace cullscope::benchmark;
using Samples = std::vector<FrustumSample>;

constexpr std::array<size_t, 5> kCounts{1'000, 10'000, 100'000, 1'000'000, 10'000'000};
constexpr std::array kShares{0.01, 0.1, 0.5, 1.0};
/// From this number on the cube contains the frustum, and the visible set is constant.
constexpr size_t kFewestEven = 10'000;
const std::string kBoxes = "boxes", kSpheres = "spheres", kEvenBoxes = "boxes around a constant visible set";

// Required ratios: of the fastest level to the naive loop while the arrays fit the cache, where at least half is visible, and
// everywhere; beyond the cache, to reading. And the exponent of the number of objects with which the hierarchy's time may grow
// where the visible set is constant.
constexpr double kManyVisible = 2.5, kAnyVisible = 0.9, kBeyondCache = 2.0, kConstantExponent = 0.25;

/// The sizes of L2 and L3 together. The kernel's values are used first: the C library's value for L3 is that of several
/// processors together.
size_t cacheBytes() {
    size_t bytes = 0;
    for (const int level : {2, 3}) {
        std::ifstream file("/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(level) + "/size");
        size_t kibibytes = 0;
        if (file >> kibibytes)
            bytes += kibibytes * 1024;
        else
            bytes += size_t(std::max(0L, sysconf(level == 2 ? _SC_LEVEL2_CACHE_SIZE : _SC_LEVEL3_CACHE_SIZE)));
    }
    return bytes;
}

size_t keptOf(const std::vector<uint64_t>& outside, size_t objects) {
    for (const uint64_t word : outside) objects -= size_t(std::popcount(word));
    return objects;
}

void expectShare(const Samples& samples) {
    for (const FrustumSample& s : samples)
        if (s.variant != kRead && std::abs(double(s.kept) - s.share * double(s.objects)) > 0.01 * double(s.objects))
            throw std::runtime_error("frustum_benchmark: " + s.variant + " keeps " + std::to_string(s.kept) + " of " +
                                     std::to_string(s.objects) + " " + s.shape + ", not the share that was placed in the view.");
}

/// All variants but the hierarchy, on the same objects.
template <typename Batch, typename Naive>
class Contest {
public:
    template <typename Object>
    explicit Contest(const std::vector<Object>& objects)
        : m_naive(naiveObjects(objects)), m_batch(objects), m_rejected(objects.size()) {}

    [[nodiscard]] std::vector<Variant> variants() {
        std::vector<Variant> variants{
            {kNaive, [this] { testNaively(m_naive, m_naivePlanes, m_rejected); },
             [this] { return m_rejected.size() - size_t(std::count(m_rejected.begin(), m_rejected.end(), 1)); }}};
        for (const SimdLevel level : availableSimdLevels())
            variants.push_back(
                {simdLevelName(level),
                 [this, level] { findOutside(m_batch, BatchFrustum(m_view.frustum(), m_view.eye()), level, m_outside); },
                 [this] { return keptOf(m_outside, m_batch.size()); }});
        variants.push_back(
            {kRead, [this] { m_sum = sumOf(m_batch.blocks(), m_batch.bytes() / sizeof(double)); }, [] { return size_t(0); }});
        return variants;
    }
    [[nodiscard]] bool fitsCache() const { return m_batch.bytes() <= cacheBytes(); }

private:
    View m_view = frustumView();
    NaivePlanes m_naivePlanes = naivePlanes(m_view);
    std::vector<Naive> m_naive;
    Batch m_batch;
    std::vector<uint8_t> m_rejected;
    std::vector<uint64_t> m_outside;
    volatile double m_sum = 0.0;
};

Variant hierarchical(Hierarchy& hierarchy, size_t& kept) {
    return {kHierarchical, [&hierarchy, &kept, view = frustumView()] { kept = hierarchy.kept(view); }, [&kept] { return kept; }};
}

void print(const FrustumSample& s) {
    std::printf("%9zu %-7s %5.1f %% visible, %-12s: %9.4f ms, %7.1f million/s", s.objects, s.shape.c_str(), 100 * s.share,
                s.variant.c_str(), s.milliseconds, s.millionPerSecond());
    if (s.toNaive > 0.0)
        std::printf(", naive x %6.2f, read x %6.2f%s", s.toNaive, s.toRead, s.fitsCache ? "" : ", beyond the cache");
    std::printf("\n");
    std::fflush(stdout);
}

void add(Samples added, const std::string& shape, double share, bool fitsCache, Samples& samples) {
    for (FrustumSample& s : added) {
        s.shape = shape;
        s.share = share;
        s.fitsCache = fitsCache;
        print(s);
    }
    expectShare(added);
    samples.insert(samples.end(), added.begin(), added.end());
}

template <typename Batch, typename Naive, typename Object>
void addContest(const std::vector<Object>& objects, const std::string& shape, double share, Samples& samples) {
    Hierarchy hierarchy(objects);
    size_t kept = 0;
    Contest<Batch, Naive> contest(objects);
    std::vector<Variant> variants = contest.variants();
    variants.push_back(hierarchical(hierarchy, kept));
    add(inTurns(variants, objects.size()), shape, share, contest.fitsCache(), samples);
}

void addBoxes(size_t count, double share, Samples& samples) {
    addContest<BoxBatch, NaiveBox>(scatteredBoxes(frustumView(), count, share), kBoxes, share, samples);
}

void addSpheres(size_t count, double share, Samples& samples) {
    addContest<SphereBatch, NaiveSphere>(scatteredSpheres(frustumView(), count, share), kSpheres, share, samples);
}

/// The scene grows around a view whose visible set is constant.
void addEvenBoxes(size_t count, Samples& samples) {
    Hierarchy hierarchy(evenBoxes(frustumView(), count));
    size_t kept = 0;
    Samples added = inTurns({hierarchical(hierarchy, kept)}, count);
    add(added, kEvenBoxes, double(added.front().kept) / double(count), false, samples);
}

std::vector<PlotPoint> points(const Samples& samples, const std::string& shape, const std::string& variant, double share,
                              double (*value)(const FrustumSample&)) {
    std::vector<PlotPoint> points;
    for (const FrustumSample& s : samples)
        if (s.shape == shape && s.variant == variant && (share == 0.0 || s.share == share))
            points.push_back({double(s.objects), value(s)});
    return points;
}

double speed(const FrustumSample& s) { return s.millionPerSecond(); }
double time(const FrustumSample& s) { return s.milliseconds; }

LinePlot speedPlot(const Samples& samples, const std::string& shape) {
    LinePlot plot = logPlot("Million " + shape + " a second, half of them visible", "objects", "million/s");
    std::vector<std::string> names{kNaive};
    for (const SimdLevel level : availableSimdLevels()) names.emplace_back(simdLevelName(level));
    names.push_back(kRead);
    names.push_back(kHierarchical);
    for (const std::string& name : names)
        plot.lines.push_back({name, points(samples, shape, name, 0.5, speed), false, false, {}});
    return plot;
}

LinePlot hierarchyPlot(const Samples& samples) {
    LinePlot plot = logPlot("Time of the hierarchy over the size of the scene", "objects", "ms");
    const auto addLine = [&](const std::string& name, const std::vector<PlotPoint>& line) {
        char exponent[32];
        std::snprintf(exponent, sizeof exponent, ": power %.2f", exponentOf(line));
        plot.lines.push_back({name + exponent, line, false, false, {}});
    };
    addLine("500 visible", points(samples, kEvenBoxes, kHierarchical, 0.0, time));
    for (const double share : kShares)
        addLine(std::to_string(int(100 * share + 0.5)) + " % visible", points(samples, kBoxes, kHierarchical, share, time));
    return plot;
}

void write(const std::filesystem::path& folder, const Samples& samples) {
    writeFileAtomically(folder / "frustum-tests.csv", [&](std::ostream& out) {
        out << "shape,objects,visible_share,variant,kept,ms,million_per_second,naive_time_ratio,time_to_read_ratio,fits_cache\n";
        for (const FrustumSample& s : samples)
            out << s.shape << ',' << s.objects << ',' << s.share << ',' << s.variant << ',' << s.kept << ',' << s.milliseconds
                << ',' << s.millionPerSecond() << ',' << s.toNaive << ',' << s.toRead << ',' << (s.fitsCache ? 1 : 0) << '\n';
    });
    const std::vector<LinePlot> plots{speedPlot(samples, kBoxes), speedPlot(samples, kSpheres), hierarchyPlot(samples)};
    writeFileAtomically(folder / "frustum-tests.svg", [&](std::ostream& out) { out << linePlotsSvg(plots); });
}

/// Checks the required ratios and prints those that are missed.
bool promisesHold(const Samples& samples) {
    bool hold = true;
    const auto demand = [&](bool holds, const FrustumSample& s, const char* what, double ratio) {
        if (!holds)
            std::printf("does not hold: %zu %s, %g %% visible: %s %.2f\n", s.objects, s.shape.c_str(), 100 * s.share, what,
                        ratio);
        hold = hold && holds;
    };
    for (const FrustumSample& s : samples) {
        if (s.variant != simdLevelName(bestSimdLevel())) continue;
        const double least = s.share >= 0.5 ? kManyVisible : kAnyVisible;
        if (s.fitsCache)
            demand(s.toNaive >= least, s, "naive time over its own", s.toNaive);
        else
            demand(s.toRead <= kBeyondCache, s, "its time over reading", s.toRead);
    }
    const double exponent = exponentOf(points(samples, kEvenBoxes, kHierarchical, 0.0, time));
    std::printf("hierarchy, constant visible set: time grows with objects^%.2f\n", exponent);
    return hold && exponent < kConstantExponent;
}

int run(const std::filesystem::path& folder, size_t largest) {
    std::filesystem::create_directories(folder);
    std::printf("cache (L2 + L3): %.1f MiB; fastest level: %s\n", double(cacheBytes()) / 0x1p20, simdLevelName(bestSimdLevel()));
    Samples samples;
    for (const size_t count : kCounts) {
        if (count > largest) break;
        for (const double share : kShares) addBoxes(count, share, samples);
        for (const double share : kShares) addSpheres(count, share, samples);
        if (count >= kFewestEven) addEvenBoxes(count, samples);
    }
    write(folder, samples);
    return promisesHold(samples) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
    const size_t largest = argc == 3 ? size_t(std::atof(argv[2])) : kCounts.back();
    if (argc < 2 || argc > 3 || largest < kCounts[2]) {
        std::fprintf(stderr, "frustum_benchmark FOLDER [LARGEST]; LARGEST: 1e5 or more\n");
        return 2;
    }
    return run(argv[1], largest);
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
