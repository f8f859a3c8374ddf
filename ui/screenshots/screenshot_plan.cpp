#include "ui/screenshots/screenshot_plan.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/gpu/colour.h"
#include "core/visibility/registry.h"
#include "ui/look/appearance.h"
#include "ui/models/metrics_words.h"
#include "ui/screenshots/screenshot_layout.h"
#include "ui/screenshots/screenshot_words.h"
#include "ui/session/session_state.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"
#include "ui/views/scene_view.h"

namespace cullscope::ui {

namespace {

DrawStyle styleOf(const Session& session, ScreenshotOptions::Background background) {
    DrawStyle style = session.drawStyle();
    if (background == ScreenshotOptions::Background::Transparent) style.backgroundAlpha = 0.0f;
    if (background != ScreenshotOptions::Background::White && background != ScreenshotOptions::Background::Black) return style;
    const bool white = background == ScreenshotOptions::Background::White;
    // A surface colour that contrasts with one background may not contrast with the other: take that of the matching palette.
    if (isLight(style.background) != white) style.surface = pictureStyle(Appearance::palette(!white)).surface;
    style.background = Vec3f(white ? 1.0f : 0.0f);
    return style;
}

std::vector<int> viewsOf(const Session& session, bool grid) {
    return grid ? session.shownViews() : std::vector<int>{session.activeView()};
}

/// Scales overlays to a picture of another size. The vertical extent stays the same, the horizontal one may grow or shrink.
PictureExtras scaled(PictureExtras extras, const Viewport& shown, const Viewport& size, double unit) {
    const double scale = double(size.height) / shown.height;
    const QPointF middle(shown.width / 2.0, shown.height / 2.0), newMiddle(size.width / 2.0, size.height / 2.0);
    const auto place = [&](const QPointF& point) { return (point - middle) * scale + newMiddle; };
    // Keep the loupe on a marked loss, not the one that follows the pointer.
    if (!extras.markedLoss) extras.loupe.reset();
    if (extras.loupe) extras.loupe = place(*extras.loupe);
    if (extras.markedLoss) extras.markedLoss = QRectF(place(extras.markedLoss->topLeft()), extras.markedLoss->size() * scale);
    for (PlacedName& name : extras.names) name.place = place(name.place);
    extras.unit = unit;
    return extras;
}

/// The picture size of the culling camera. If it is the shared camera and its view is in the screenshot, the size of that view's
/// picture; else its size on the screen at the scale of this picture.
Viewport cullingSize(const Session& session, int view, const ViewRequest& shown, const std::vector<ScreenshotPlan::Part>& parts,
                     const Viewport& size) {
    const int culling = session.culledBy(view);
    if (session.setup(culling).role == Role::Linked) {
        if (culling == view) return size;
        for (const ScreenshotPlan::Part& part : parts)
            if (part.view == culling) return {part.picture.width(), part.picture.height()};
    }
    const double scale = double(size.height) / shown.size.height;
    const auto length = [&](int pixels) { return std::clamp(int(std::lround(pixels * scale)), 1, kMostPixels); };
    return {length(shown.cullingSize.width), length(shown.cullingSize.height)};
}

PictureSubject subjectOf(const Session& session, int view, const ViewRequest& request) {
    PictureSubject subject = pictureSubject(session, view, request);
    subject.scene = withAbsoluteFiles(subject.scene);
    const ViewMetrics& figures = session.figures(view);
    if (figures.state != ViewMetrics::State::Ready) return subject;
    subject.missedPixels = figures.accuracy.missedPixels;
    subject.figuresSize = figures.size;
    if (figures.speedup) subject.ratioToSameSides = {figures.speedup->ratio, figures.speedup->ci95, figures.baseline};
    return subject;
}

/// A view as on the screen, without unwanted overlays.
ScreenshotPlan::Part shownPart(const Session& session, int view, bool overlays) {
    const std::optional<ViewRequest> shown = session.viewRequest(view);
    if (!shown)
        throwUsage(QT_TRANSLATE_NOOP("core", "There is no picture to save yet: open a scene and wait until it is drawn."));
    ScreenshotPlan::Part part;
    part.view = view;
    part.overlays = overlays;
    part.request = *shown;
    if (overlays) return part;
    part.request.look.leaveOutOverlays();
    part.request.wipe = Wipe::Mode::None;
    return part;
}

/// Whether the truth may be computed: the screen shows it already, or the scene is small enough.
bool mayMeasure(const ViewRequest& shown) {
    // What a part of a frame or an open question shows has no truth.
    if (shown.upTo || shown.unanswered) return false;
    return shown.states || shown.buffers->scene().triangleCount() <= kOptionalAnalysisLimit;
}

/// Changes a part from its size on the screen to the size of its rectangle.
void enlarge(ScreenshotPlan::Part& part, const ScreenshotPlan& plan, const Session& session, const ExtrasOf& extras) {
    const ViewRequest shown = part.request;
    const Viewport size{part.picture.width(), part.picture.height()};
    const double unit = size.height <= shown.size.height ? 1.0 : std::max(1.0, size.height / kUnitHeight);
    part.request.size = size;
    part.request.cullingSize = cullingSize(session, part.view, shown, plan.parts, size);
    part.request.style = plan.style;
    part.request.style.unit = float(unit);
    part.wanted.reach = int(std::lround(2.0 * unit));
    if (!(part.request.cullingSize == shown.cullingSize)) part.request.states = nullptr;
    if (!(part.request.size == shown.size)) part.request.lost = nullptr;
    part.wanted.truth = shown.look.has(Show::Kind::Verdicts) && mayMeasure(shown) && !part.request.states;
    part.extras = scaled(extras(part.view), shown.size, size, unit);
    part.subject = subjectOf(session, part.view, part.request);
    const ViewMetrics& figures = session.figures(part.view);
    part.words =
        QStringLiteral("%1  %2 · %3").arg(viewLetter(part.view), shownStrategy(session, part.view), metricsLine(figures));
    if (figures.state == ViewMetrics::State::Ready && figuresSizes(session, session.shownViews()).size() > 1)
        part.words += QStringLiteral(" · ") + pixelText(figures.size);
}

void addPlanes(std::vector<LegendEntry>& legend, const Vec3f& background) {
    const auto colours = planePalette(background);
    for (size_t plane = 0; plane < colours.size(); ++plane)
        legend.push_back({std::nullopt, QColor::fromRgbF(colours[plane].x, colours[plane].y, colours[plane].z),
                          QCoreApplication::translate("Screenshot", "box rejected by the %1", "name of a plane")
                              .arg(translated(planeName(FrustumPlane(plane)))),
                          QRect()});
}

std::vector<LegendEntry> legendOfParts(const std::vector<ScreenshotPlan::Part>& parts, const DrawStyle& style) {
    bool planes = false, marks = false, snapped = false;
    std::set<TriangleState> states;
    std::vector<ShowMeaning> meanings;
    for (const ScreenshotPlan::Part& part : parts) {
        states.merge(legendOf(part.request.look));
        for (const ShowMeaning& meaning : meaningsOf(part.request.look, part.request.strategy->info()))
            if (std::ranges::find(meanings, meaning) == meanings.end()) meanings.push_back(meaning);
        planes = planes || part.request.look.has(Show::Kind::Planes);
        snapped = snapped || part.request.lost != nullptr;
        marks = marks || part.request.wipe == Wipe::Mode::Loss || part.request.wipe == Wipe::Mode::Difference;
    }
    std::vector<LegendEntry> legend;
    const auto palette = verdictPalette(style.background);
    for (const TriangleState state : states) legend.push_back({state, QColor(), translated(triangleStateName(state)), QRect()});
    for (const ShowMeaning& meaning : meanings) {
        const Vec3f colour = meaning.colour(style.background);
        legend.push_back({std::nullopt, QColor::fromRgbF(colour.x, colour.y, colour.z), translated(meaning.words), QRect()});
    }
    if (planes) addPlanes(legend, style.background);
    if (marks) {
        const Vec3f lost = palette[size_t(TriangleState::WronglyCulled)].colour;
        legend.push_back({std::nullopt, QColor::fromRgbF(lost.x, lost.y, lost.z),
                          QCoreApplication::translate("Screenshot", "farther away than beside it, or missing (pixels)"),
                          QRect()});
        if (snapped)
            legend.push_back({std::nullopt, snappedPixelColour(),
                              QCoreApplication::translate("Screenshot", "within snapping, not lost (pixels)"), QRect()});
        legend.push_back({std::nullopt, addedPixelColour(),
                          QCoreApplication::translate("Screenshot", "nearer than beside it (pixels)"), QRect()});
    }
    return legend;
}

/// The view whose counts the legend states: that of the parts that are coloured by verdict; none if they show the verdicts of
/// different views, or if there are none.
std::optional<int> countedView(const Session& session, const std::vector<ScreenshotPlan::Part>& parts) {
    std::optional<int> found;
    for (const ScreenshotPlan::Part& part : parts) {
        // What a part of a frame or an open question shows is not what was measured.
        if (!part.request.look.has(Show::Kind::Verdicts) || part.request.upTo || part.request.unanswered) continue;
        if (found && session.culledBy(*found) != session.culledBy(part.view)) return std::nullopt;
        if (!found) found = part.view;
    }
    return found;
}

/// A picture of another size decides anew which triangles it colours how. Its legend has the view's counts all the same, as its
/// caption has the view's figures: all of one size, which both state.
void addCounts(ScreenshotPlan& plan, const Session& session) {
    const std::optional<int> view = countedView(session, plan.parts);
    if (!view || plan.legend.empty()) return;
    const ViewMetrics& figures = session.figures(*view);
    if (figures.state != ViewMetrics::State::Ready || !figures.states) return;
    plan.counts = figures.states->counts;
    plan.legend.insert(plan.legend.begin(), {std::nullopt, Qt::transparent, legendHeading(figures.size), QRect()});
}

PictureMetadata metadataOf(Session& session, const ScreenshotOptions& options, const Viewport& size) {
    PictureMetadata metadata = programMetadata(session.gpu() ? session.gpu()->info().renderer : std::string());
    metadata.emplace_back("cullscope:screenshot", optionsText(options));
    metadata.emplace_back("cullscope:picture_size", sizeText(size));
    return metadata;
}

}  // namespace

ScreenshotPlan planScreenshot(Session& session, const ScreenshotOptions& options, const ExtrasOf& extras, bool keepsDepth) {
    ScreenshotPlan plan;
    plan.style = styleOf(session, options.background);
    if (options.caption) plan.caption = options.captionText.isEmpty() ? madeCaption(session, options.grid) : options.captionText;
    for (const int view : viewsOf(session, options.grid)) plan.parts.push_back(shownPart(session, view, options.overlays));
    if (options.legend) plan.legend = legendOfParts(plan.parts, plan.style);
    addCounts(plan, session);
    layOut(plan, options, session.scene()->triangleCount());
    for (ScreenshotPlan::Part& part : plan.parts) enlarge(part, plan, session, extras);
    // A model in spherical coordinates has neither depths nor triangle numbers of a camera.
    if (keepsDepth && !options.grid) plan.parts.front().wanted.items = !plan.parts.front().request.look.inPlace();
    plan.metadata = metadataOf(session, options, plan.size);
    return plan;
}

}  // namespace cullscope::ui
