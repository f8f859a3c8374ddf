#include "ui/session/view_sizes.h"

#include <QCoreApplication>
#include <algorithm>

namespace cullscope::ui {

namespace {

constexpr uint64_t kMegapixel = 1'000'000;

uint64_t areaOf(const std::optional<Viewport>& size) { return size ? uint64_t(size->width) * uint64_t(size->height) : 0; }

}  // namespace

uint64_t pixelsAskedFor(const std::vector<ViewSetup>& views) {
    uint64_t pixels = 0;
    for (const ViewSetup& view : views) pixels += std::max(areaOf(view.size), areaOf(view.cullingSize));
    return pixels;
}

std::optional<Message> tooManyPixels(const std::vector<ViewSetup>& views, uint64_t most) {
    const uint64_t pixels = pixelsAskedFor(views);
    if (pixels <= most) return std::nullopt;
    return Message{QT_TRANSLATE_NOOP("core",
                                     "The views' pictures would have %1 million pixels together, and at most %2 million are "
                                     "possible: choose smaller sizes."),
                   {std::to_string((pixels + kMegapixel - 1) / kMegapixel), std::to_string(most / kMegapixel)}};
}

}  // namespace cullscope::ui
