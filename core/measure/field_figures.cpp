#include "core/measure/field_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "core/geometry/random.h"

namespace cullscope {
namespace {

constexpr size_t kDifferences = 3 * 255 + 1;
constexpr double kHigh = 0.99;

/// In the order of fieldFigures(): first those that are a sum over the views ÷ another sum over the views.
enum Figure : size_t {
    TriangleMisses,
    TriangleWaste,
    ObjectMisses,
    ObjectWaste,
    LostPixels,
    PixelErrors,
    PoppingEvents,
    PoppingPixels,
    PoppingFrames,
    PoppingRate,
    DifferenceMean,
    Silhouette,
    SumCount,
    DifferenceHigh = SumCount,
    PixelErrorsMost,
    FigureCount
};

constexpr std::array<FieldFigure, FigureCount> kFigures{{
    {"triangle_false_negative_rate", CULLSCOPE_TR("false negatives, triangles, %"), 3, 100.0,
     CULLSCOPE_TR("Of the visible triangles, those that were not drawn")},
    {"triangle_false_positive_rate", CULLSCOPE_TR("false positives, triangles, %"), 1, 100.0,
     CULLSCOPE_TR("Of the triangles that are not visible, those that were drawn")},
    {"object_false_negative_rate", CULLSCOPE_TR("false negatives, objects, %"), 3, 100.0,
     CULLSCOPE_TR("Of the visible objects, those of which no triangle was drawn")},
    {"object_false_positive_rate", CULLSCOPE_TR("false positives, objects, %"), 1, 100.0,
     CULLSCOPE_TR("Of the objects that are not visible, those of which a triangle was drawn")},
    {"lost_pixel_rate", CULLSCOPE_TR("missed of the covered pixels, ppm"), 1, 1e6,
     CULLSCOPE_TR("Of the pixels in which the truth has a surface, those in which the strategy has a farther one or none")},
    {"pixel_error_rate", CULLSCOPE_TR("pixel errors, ppm"), 1, 1e6,
     CULLSCOPE_TR("Of all pixels, those that show a farther or a nearer surface than the truth, or none")},
    {"popping_events_per_1000_frames", CULLSCOPE_TR("popping, events per 1,000 frames"), 1, 1.0,
     CULLSCOPE_TR("How often an object begins to lose pixels, in a thousand frames along the path")},
    {"popping_pixels", CULLSCOPE_TR("popping, pixels"), 1, 1.0,
     CULLSCOPE_TR("The most pixels that an object loses in one frame of such an event, mean over the events")},
    {"popping_frames", CULLSCOPE_TR("popping, duration in frames"), 1, 1.0,
     CULLSCOPE_TR("For how many frames an object loses pixels in such an event, mean over the events")},
    {"popping_pixel_rate", CULLSCOPE_TR("popping, pixels that change, ppm"), 1, 1e6,
     CULLSCOPE_TR("Of all pixels, those that are lost in a frame or in the one before it, and not in both")},
    {"image_difference_mean", CULLSCOPE_TR("image difference, mean, ppm"), 1, 1e6,
     CULLSCOPE_TR("Difference from the shaded picture of everything, mean of all pixels and colours, of the full range")},
    {"silhouette_error_px", CULLSCOPE_TR("silhouette error, pixels"), 4, 1.0,
     CULLSCOPE_TR("Pixels that one of both pictures alone covers, for each pixel of the outline: about the mean distance of both "
                  "outlines")},
    {"image_difference_p99", CULLSCOPE_TR("image difference, p99, %"), 2, 100.0,
     CULLSCOPE_TR("Difference from the shaded picture of everything that 99 % of the pixels do not exceed, of the full range")},
    {"pixel_error_rate_max", CULLSCOPE_TR("pixel errors of the worst view, ppm"), 1, 1e6,
     CULLSCOPE_TR("Pixel errors of the view that has the largest share of them")},
}};

struct Share {
    double part = 0.0, whole = 0.0;
};
using Shares = std::array<Share, SumCount>;

double errorPixels(const FrameMeasurement& frame) { return double(frame.lostPixels + frame.wronglyNearerPixels); }

/// The parts of one view in the figures that are sums.
Shares sharesOf(const FrameMeasurement& frame) {
    const Accuracy& errors = *frame.accuracy;
    Shares shares;
    shares[TriangleMisses] = {double(errors.falselyCulledTriangles), double(errors.visibleTriangles)};
    shares[TriangleWaste] = {double(errors.needlesslyDrawnTriangles), double(errors.sceneTriangles - errors.visibleTriangles)};
    shares[ObjectMisses] = {double(errors.falselyCulledObjects), double(errors.visibleObjects)};
    shares[ObjectWaste] = {double(errors.needlesslyDrawnObjects), double(errors.sceneObjects - errors.visibleObjects)};
    shares[LostPixels] = {double(frame.lostPixels), double(errors.coveredPixels)};
    shares[PixelErrors] = {errorPixels(frame), double(errors.pixels)};
    shares[PoppingEvents].whole = 1.0;
    shares[PoppingRate] = {double(frame.toggledPixels), double(errors.pixels)};
    shares[DifferenceMean] = {meanDifference(frame.pictureDifferences) * double(errors.pixels), double(errors.pixels)};
    shares[Silhouette] = {double(errors.differentlyCovered), double(errors.outlinePixels)};
    return shares;
}

/// Adds the same resamples of the views for all figures at once.
class Bootstrap {
public:
    explicit Bootstrap(size_t views) : m_views(views) {}

    template <typename Sum, typename Add>
    std::vector<Sum> sums(const Sum& zero, const Add& add) const {
        Random random(1);
        std::vector<Sum> all(kResamples, zero);
        for (Sum& sum : all)
            for (size_t view = 0; view < m_views; ++view) add(sum, random.bits() % m_views);
        return all;
    }

private:
    size_t m_views;
};

void addShares(Shares& sum, const Shares& one) {
    for (size_t i = 0; i < SumCount; ++i) {
        sum[i].part += one[i].part;
        sum[i].whole += one[i].whole;
    }
}

/// The objects of ascending triangles or intervals of them, ascending and each once.
std::vector<size_t> objectsOf(const std::vector<uint32_t>& ascending, const Scene& scene) {
    std::vector<size_t> objects;
    for (const uint32_t triangle : ascending)
        if (objects.empty() || triangle >= scene.firstTriangle(objects.back() + 1)) objects.push_back(scene.instanceOf(triangle));
    return objects;
}
std::vector<size_t> objectsOf(const TriangleIntervals& intervals, const Scene& scene) {
    std::vector<size_t> objects;
    for (const auto& [first, end] : intervals)
        for (uint64_t triangle = first; triangle < end; triangle = scene.firstTriangle(objects.back() + 1))
            if (const size_t object = scene.instanceOf(triangle); objects.empty() || object != objects.back())
                objects.push_back(object);
    return objects;
}

void countObjects(Accuracy& accuracy, const Reference& reference, const TriangleIntervals& given, const Scene& scene) {
    const std::vector<size_t> visible = objectsOf(reference.visibleTriangles, scene), drawn = objectsOf(given, scene);
    std::vector<size_t> both;
    std::ranges::set_intersection(visible, drawn, std::back_inserter(both));
    for (size_t object = 0; object < scene.instances().size(); ++object)
        if (scene.firstTriangle(object + 1) > scene.firstTriangle(object)) ++accuracy.sceneObjects;
    accuracy.sceneTriangles = scene.triangleCount();
    accuracy.visibleObjects = visible.size();
    accuracy.submittedObjects = drawn.size();
    accuracy.falselyCulledObjects = visible.size() - both.size();
    accuracy.needlesslyDrawnObjects = drawn.size() - both.size();
}

void countOutline(Accuracy& accuracy, const Reference& reference, const ShownPixels& shown) {
    const auto width = size_t(reference.size.width), height = size_t(reference.size.height);
    accuracy.pixels = width * height;
    for (size_t pixel = 0; pixel < reference.triangle.size(); ++pixel) {
        const bool truly = reference.triangle[pixel] != 0;
        const bool covered = shown.triangle.empty() ? shown.depth[pixel] > 0.0f : shown.triangle[pixel] != 0;
        if (truly != covered) ++accuracy.differentlyCovered;
        if (!truly) continue;
        const size_t x = pixel % width, y = pixel / width;
        const auto open = [&](bool within, size_t neighbour) { return within && reference.triangle[neighbour] == 0; };
        if (open(x > 0, pixel - 1) || open(x + 1 < width, pixel + 1) || open(y > 0, pixel - width) ||
            open(y + 1 < height, pixel + width))
            ++accuracy.outlinePixels;
    }
}

double factorOf(size_t figure) { return figure == PoppingEvents ? 1000.0 : 1.0; }

void estimateSums(FieldEstimates& estimates, const std::vector<Shares>& views) {
    Shares total;
    for (const Shares& view : views) addShares(total, view);
    const bool any = std::ranges::any_of(total, [](const Share& share) { return share.part > 0.0; });
    std::vector<Shares> resamples;
    if (any && views.size() > 1)
        resamples = Bootstrap(views.size()).sums(Shares{}, [&](Shares& sum, size_t view) { addShares(sum, views[view]); });
    for (size_t figure = 0; figure < SumCount; ++figure) {
        if (!(total[figure].whole > 0.0)) continue;
        const double factor = factorOf(figure);
        const double value = factor * total[figure].part / total[figure].whole;
        std::vector<double> values;
        for (const Shares& resample : resamples)
            if (resample[figure].whole > 0.0) values.push_back(factor * resample[figure].part / resample[figure].whole);
        // Where one view alone has something to count, resampling the views says nothing.
        const auto counted = std::ranges::count_if(views, [&](const Shares& view) { return view[figure].whole > 0.0; });
        if (value > 0.0 && !values.empty() && counted > 1)
            estimates[figure] = RatioEstimate{value, middle95(values), true};
        else
            estimates[figure] = RatioEstimate{value, {value, value}, false};
    }
}

/// The differences of all views' pixels together.
void estimateHighDifference(FieldEstimates& estimates, std::span<const FrameMeasurement> frames) {
    using Counts = std::array<uint32_t, kDifferences>;
    std::vector<Counts> views;
    for (const FrameMeasurement& frame : frames) {
        views.emplace_back();
        views.back().fill(0);
        if (frame.pictureDifferences.empty())
            views.back()[0] = uint32_t(frame.accuracy->pixels);
        else
            std::ranges::copy(frame.pictureDifferences, views.back().begin());
    }
    const auto add = [&](Counts& sum, size_t view) {
        for (size_t i = 0; i < kDifferences; ++i) sum[i] += views[view][i];
    };
    Counts total{};
    for (size_t view = 0; view < views.size(); ++view) add(total, view);
    const double value = differenceQuantile(total, kHigh);
    const auto differs = [](const Counts& counts) {
        return std::any_of(counts.begin() + 1, counts.end(), [](uint32_t count) { return count > 0; });
    };
    if (!std::ranges::any_of(views, differs) || views.size() < 2) {
        estimates[DifferenceHigh] = RatioEstimate{value, {value, value}, false};
        return;
    }
    std::vector<double> values;
    for (const Counts& counts : Bootstrap(views.size()).sums(Counts{}, add)) values.push_back(differenceQuantile(counts, kHigh));
    estimates[DifferenceHigh] = RatioEstimate{value, middle95(values), true};
}

}  // namespace

void countForFieldFigures(Accuracy& accuracy, const Reference& reference, const ShownPixels& shown,
                          const TriangleIntervals& given, const Scene& scene) {
    countObjects(accuracy, reference, given, scene);
    countOutline(accuracy, reference, shown);
}

std::span<const FieldFigure> fieldFigures() { return kFigures; }

size_t fieldFigurePlace(std::string_view key) {
    return size_t(std::ranges::find(kFigures, key, &FieldFigure::key) - kFigures.begin());
}

FieldEstimates fieldEstimates(std::span<const FrameMeasurement> frames) {
    const auto judged = [](const FrameMeasurement& frame) { return frame.accuracy.has_value(); };
    if (frames.empty() || !std::ranges::all_of(frames, judged)) return {};
    std::vector<Shares> views;
    for (const FrameMeasurement& frame : frames) views.push_back(sharesOf(frame));
    if (frames.size() > 1) {
        for (const PoppingEvent& event : poppingEvents(frames)) {
            Shares& first = views[event.first];
            first[PoppingEvents].part += 1.0;
            first[PoppingPixels].part += double(event.pixels);
            first[PoppingPixels].whole += 1.0;
            first[PoppingFrames].part += double(event.frames);
            first[PoppingFrames].whole += 1.0;
        }
    } else {
        views.front()[PoppingEvents] = views.front()[PoppingRate] = {};
    }
    FieldEstimates estimates(FigureCount);
    estimateSums(estimates, views);
    estimateHighDifference(estimates, frames);
    double most = 0.0;
    for (const FrameMeasurement& frame : frames)
        if (frame.accuracy->pixels > 0) most = std::max(most, errorPixels(frame) / double(frame.accuracy->pixels));
    estimates[PixelErrorsMost] = RatioEstimate{most, {most, most}, false};
    return estimates;
}

Message noLossIn(size_t views) {
    return {boundSaysSomething(views) ? CULLSCOPE_TR("0 (< 3/%1)") : CULLSCOPE_TR("0 of %1"), {std::to_string(views)}};
}

size_t framesWithLoss(std::span<const FrameMeasurement> frames) {
    return size_t(std::ranges::count_if(frames, [](const FrameMeasurement& frame) { return frame.lostPixels > 0; }));
}

std::vector<PoppingEvent> poppingEvents(std::span<const FrameMeasurement> frames) {
    std::vector<PoppingEvent> events;
    std::map<uint32_t, size_t> open;  // by instance, the number of its event under way
    for (size_t i = 0; i < frames.size(); ++i) {
        std::map<uint32_t, size_t> still;
        std::vector<LostObject> lost = frames[i].lostObjects;
        std::ranges::sort(lost, {}, &LostObject::instance);
        for (const LostObject& object : lost) {
            const auto before = open.find(object.instance);
            if (before == open.end()) events.push_back({object.instance, i});
            const size_t number = before == open.end() ? events.size() - 1 : before->second;
            ++events[number].frames;
            events[number].pixels = std::max(events[number].pixels, object.pixels);
            still[object.instance] = number;
        }
        open = std::move(still);
    }
    return events;
}

std::vector<uint32_t> pictureDifferences(std::span<const uint8_t> one, std::span<const uint8_t> other) {
    std::vector<uint32_t> differences(kDifferences);
    for (size_t i = 0; i + 4 <= std::min(one.size(), other.size()); i += 4) {
        int sum = 0;
        for (size_t channel = 0; channel < 3; ++channel) sum += std::abs(int(one[i + channel]) - int(other[i + channel]));
        ++differences[size_t(sum)];
    }
    return differences;
}

double meanDifference(std::span<const uint32_t> differences) {
    double sum = 0.0, pixels = 0.0;
    for (size_t i = 0; i < differences.size(); ++i) {
        sum += double(i) * differences[i];
        pixels += differences[i];
    }
    return pixels > 0.0 ? sum / pixels / double(kDifferences - 1) : 0.0;
}

double differenceQuantile(std::span<const uint32_t> differences, double share) {
    uint64_t pixels = 0, below = 0;
    for (const uint32_t count : differences) pixels += count;
    for (size_t i = 0; i < differences.size(); ++i) {
        below += differences[i];
        if (pixels > 0 && double(below) >= share * double(pixels)) return double(i) / double(kDifferences - 1);
    }
    return 0.0;
}

std::vector<uint32_t> pictureDifferences(Renderer& renderer, const SceneBuffers& buffers, const FrameLog& log,
                                         const Reference& reference, Framebuffer& target) {
    const View view(log.camera, log.size);
    renderer.draw(buffers, view, log, target);
    const std::vector<uint8_t> shown = target.readColour();
    renderer.draw(buffers, view, everything(buffers.scene(), reference.facing), target);
    return pictureDifferences(shown, target.readColour());
}

}  // namespace cullscope
