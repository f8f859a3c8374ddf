// Boxes and spheres a second by the frustum tests: the naive loop, the batch on every level, the hierarchy, and merely reading.
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <fstream>
#include <stdexcept>

#include "tests/benchmark/experiments.h"
#include "tests/benchmark/frustum_hierarchy.h"
#include "tests/benchmark/in_turns.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr std::array<size_t, 5> kCounts{1'000, 10'000, 100'000, 1'000'000, 10'000'000};
constexpr std::array kShares{0.01, 0.1, 0.5, 1.0};
/// From this number on the cube contains the frustum, and the visible set is constant.
constexpr size_t kFewestEven = 10'000;
const std::string kBoxes = "boxes", kSpheres = "spheres", kEvenBoxes = "boxes around a constant visible set";
const std::string kNaive = "naive", kRead = "read", kHierarchical = "hierarchical";

// Required ratios: of the fastest level to the naive loop while the arrays fit the cache, where at least half is visible, and
// everywhere; beyond the cache, to reading. And the exponent of the number of objects with which the hierarchy's time may grow
// where the visible set is constant.
constexpr double kManyVisible = 2.5, kAnyVisible = 0.9, kBeyondCache = 2.0, kConstantExponent = 0.25;

/// A time is measured over as many passes as take at least this long.
constexpr double kLeastMilliseconds = 1.0;
constexpr int kTestRounds = 15, kRoundsOfMany = 7;
constexpr size_t kMany = 2'000'000;

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

/// One method of testing all objects, and the number of objects that the last pass kept.
struct Variant {
    std::string name;
    std::function<void()> pass;
    std::function<size_t()> kept;
};

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

/// The time of this process only: on a busy machine, a slow variant would be interrupted more often than a fast one.
double processorTime(const std::function<void()>& pass, size_t passes) {
    const std::clock_t start = std::clock();
    for (size_t i = 0; i < passes; ++i) pass();
    return double(std::clock() - start) * 1000.0 / CLOCKS_PER_SEC / double(passes);
}

/// The number of passes that take kLeastMilliseconds.
size_t passesOf(const std::function<void()>& pass) {
    size_t passes = 1;
    pass();
    while (processorTime(pass, passes) * double(passes) < kLeastMilliseconds) passes *= 2;
    return passes;
}

/// The milliseconds of a pass of each variant, by round.
std::vector<std::vector<double>> timesOf(const std::vector<Variant>& variants, size_t objects) {
    std::vector<std::function<double()>> contestants;
    for (const Variant& variant : variants)
        contestants.push_back([&variant, passes = passesOf(variant.pass), objects] {
            // Loads this variant's arrays into the cache, which the variant before has filled with its own.
            if (objects < kMany) variant.pass();
            return processorTime(variant.pass, passes);
        });
    return inTurns(contestants, objects < kMany ? kTestRounds : kRoundsOfMany);
}

/// A row for each variant: processor time of a pass, the median over the rounds, and ratios of times.
Rows rowsOf(const std::vector<Variant>& variants, size_t objects) {
    const std::vector<std::vector<double>> times = timesOf(variants, objects);
    const auto timesOfVariant = [&](const std::string& name) -> const std::vector<double>* {
        for (size_t i = 0; i < variants.size(); ++i)
            if (variants[i].name == name) return &times[i];
        return nullptr;
    };
    Rows rows;
    for (size_t i = 0; i < variants.size(); ++i) {
        const double milliseconds = medianOf(times[i]);
        Row cells{{"variant", variants[i].name},
                  {"kept", double(variants[i].kept())},
                  {"ms", milliseconds},
                  {"million_per_second", double(objects) / milliseconds / 1000.0}};
        if (const auto* naive = timesOfVariant(kNaive)) cells["naive_time_ratio"] = ratioInTurns(*naive, times[i]);
        if (const auto* read = timesOfVariant(kRead)) cells["time_to_read_ratio"] = ratioInTurns(times[i], *read);
        rows.push_back(std::move(cells));
    }
    return rows;
}

void expectShare(const Rows& rows, double objects, double share) {
    for (const Row& row : rows) {
        const auto& variant = std::get<std::string>(row.at("variant"));
        const double kept = std::get<double>(row.at("kept"));
        if (variant != kRead && std::abs(kept - share * objects) > 0.01 * objects)
            throw std::runtime_error("frustum-tests: " + variant + " keeps " + std::to_string(size_t(kept)) + " of " +
                                     std::to_string(size_t(objects)) + ", not the share that was placed in the view.");
    }
}

template <typename Batch, typename Naive, typename Object>
Rows contestRows(const std::vector<Object>& objects, double share) {
    Hierarchy hierarchy(objects);
    size_t kept = 0;
    Contest<Batch, Naive> contest(objects);
    std::vector<Variant> variants = contest.variants();
    variants.push_back(hierarchical(hierarchy, kept));
    Rows rows = rowsOf(variants, objects.size());
    expectShare(rows, double(objects.size()), share);
    for (Row& row : rows) {
        row["fits_cache"] = contest.fitsCache() ? 1.0 : 0.0;
        row["in_view"] = std::to_string(std::lround(100 * share)) + " % visible";
    }
    return rows;
}

/// The scene grows around a view whose visible set is constant.
Rows evenRows(size_t count) {
    Hierarchy hierarchy(evenBoxes(frustumView(), count));
    size_t kept = 0;
    Rows rows = rowsOf({hierarchical(hierarchy, kept)}, count);
    rows.front()["visible_share"] = double(kept) / double(count);
    rows.front()["fits_cache"] = 0.0;
    rows.front()["in_view"] = std::to_string(std::lround(kConstantVisible)) + " visible";
    return rows;
}

Rows measuredRows(const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
    const std::string& shape = setting.words("shape");
    const auto count = size_t(setting.number("objects"));
    if (shape == kEvenBoxes) return evenRows(count);
    const double share = setting.number("visible_share");
    if (shape == kBoxes) return contestRows<BoxBatch, NaiveBox>(scatteredBoxes(frustumView(), count, share), share);
    return contestRows<SphereBatch, NaiveSphere>(scatteredSpheres(frustumView(), count, share), share);
}

std::vector<CellValue> variantNames() {
    std::vector<CellValue> names{kNaive};
    for (const SimdLevel level : availableSimdLevels()) names.emplace_back(std::string(simdLevelName(level)));
    names.emplace_back(kRead);
    names.emplace_back(kHierarchical);
    return names;
}

std::vector<CellValue> countsBetween(size_t least, size_t most) {
    std::vector<CellValue> counts;
    for (const size_t count : kCounts)
        if (count >= least && count <= most) counts.emplace_back(double(count));
    return counts;
}

RowPlot speedPlot(const std::string& shape) {
    RowPlot described{logPlot("Million " + shape + " a second, half of them visible", "objects", "million/s")};
    described.x = "objects";
    described.y = {{"million_per_second"}};
    described.lines = {"variant"};
    described.rows = {{"shape", {shape}}, {"visible_share", {0.5}}};
    return described;
}

RowPlot hierarchyPlot() {
    RowPlot described{logPlot("Time of the hierarchy over the size of the scene", "objects", "ms")};
    described.x = "objects";
    described.y = {{"ms"}};
    described.lines = {"in_view"};
    described.rows = {{"variant", {kHierarchical}}, {"shape", {kBoxes, kEvenBoxes}}};
    described.namesExponents = true;
    return described;
}

std::vector<Check> contestChecks() {
    const std::string best = simdLevelName(bestSimdLevel());
    const auto within = [&](std::vector<CellValue> shares) {
        return RowFilter{{"variant", {best}}, {"visible_share", std::move(shares)}, {"fits_cache", {1.0}}};
    };
    return {everyRowCheck("within the cache, half or more visible: the naive loop's time over that of " + best,
                          within({0.5, 1.0}), "naive_time_ratio", {kManyVisible}),
            everyRowCheck("within the cache, less visible: the same", within({0.01, 0.1}), "naive_time_ratio", {kAnyVisible}),
            everyRowCheck("beyond the cache: the time of " + best + " over that of reading",
                          {{"variant", {best}}, {"fits_cache", {0.0}}}, "time_to_read_ratio", {.most = kBeyondCache}),
            exponentCheck("hierarchy, constant visible set: time grows with the objects to the power of",
                          {{{"shape", {kEvenBoxes}}}, "objects", "ms"}, {.most = kConstantExponent})};
}

std::string cacheNote() {
    char note[96];
    std::snprintf(note, sizeof note, "cache (L2 + L3): %.1f MiB; fastest level: %s", double(cacheBytes()) / 0x1p20,
                  simdLevelName(bestSimdLevel()));
    return note;
}

}  // namespace

Experiment frustumTests(size_t largest) {
    Experiment experiment;
    experiment.id = "frustum-tests";
    experiment.title = "Boxes and spheres a second by the frustum tests";
    experiment.notes = {{cacheNote(), {}}};
    Axis shapes{"shape", "shape", Axis::Kind::Label, {kBoxes, kSpheres}};
    if (largest >= kFewestEven) shapes.values.emplace_back(kEvenBoxes);
    const Axis objects{"objects", "objects", Axis::Kind::Label, countsBetween(0, largest)};
    const Axis shares{"visible_share", "visible share", Axis::Kind::Label, axisValues(kShares)};
    experiment.axes = {shapes, objects, shares, {"variant", "variant", Axis::Kind::InTurns, variantNames()}};
    // The share that is visible of the third shape follows from the number of objects.
    experiment.settings = settingsOf({{"shape", "", Axis::Kind::Label, {kBoxes, kSpheres}}, objects, shares});
    for (Setting& setting : settingsOf({{"shape", "", Axis::Kind::Label, {kEvenBoxes}},
                                        {"objects", "", Axis::Kind::Label, countsBetween(kFewestEven, largest)}}))
        experiment.settings.push_back(std::move(setting));
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns[2].decimals = 5;
    const std::vector<ResultColumn> measured{{"in_view", "in view", Origin::Axis},
                                             {"kept", "kept"},
                                             {"ms", "ms", Origin::Measured, 4},
                                             {"million_per_second", "million/s", Origin::Measured, 1},
                                             {"naive_time_ratio", "x naive [95 %]", Origin::Measured, 2},
                                             {"time_to_read_ratio", "time / reading's [95 %]", Origin::Measured, 2},
                                             {"fits_cache", "fits the cache"}};
    experiment.columns.insert(experiment.columns.end(), measured.begin(), measured.end());
    experiment.plots = {speedPlot(kBoxes), speedPlot(kSpheres), hierarchyPlot()};
    experiment.checks = contestChecks();
    experiment.measured = measuredRows;
    return experiment;
}

}  // namespace cullscope::benchmark
