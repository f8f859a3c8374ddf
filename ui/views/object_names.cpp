#include "ui/views/object_names.h"

namespace cullscope::ui {

namespace {

constexpr size_t kMostNames = 26;

}  // namespace

std::vector<PlacedName> objectNames(const Session& session, const ViewPicture& shown) {
    const Scene& scene = shown.request.buffers->scene();
    const size_t count = scene.instances().size();
    if (count < 2 || count > kMostNames || shown.request.look.inPlace()) return {};
    if (scene.planes().empty() && !session.question()) return {};
    const View view(shown.request.viewing, shown.request.size);
    std::vector<PlacedName> names;
    for (size_t i = 0; i < count; ++i) {
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(scene.instanceBox(i).centre() - view.eye(), 1.0);
        if (!(clip.w > 0.0) || scene.instances()[i].name.empty()) continue;
        const Vec2 place((clip.x / clip.w * 0.5 + 0.5) * shown.request.size.width,
                         (0.5 - clip.y / clip.w * 0.5) * shown.request.size.height);
        names.push_back({QString::fromStdString(scene.instances()[i].name), {place.x, place.y}});
    }
    return names;
}

}  // namespace cullscope::ui
