#include "core/frame/frame_log.h"

#include <algorithm>

namespace cullscope {
namespace {

/// The numbers that a picture shows, ascending, each once.
std::vector<uint32_t> shownTriangles(const FinishedPicture& picture) {
    std::vector<uint32_t> shown;
    for (const uint32_t item : picture.triangle)
        if (item != 0) shown.push_back(item - 1);
    std::ranges::sort(shown);
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    return shown;
}

}  // namespace

uint64_t FrameLog::consideredTriangles() const {
    struct Counter {
        uint64_t operator()(const DrawList& list) const { return list.triangleCount(); }
        uint64_t operator()(const OwnTrianglesPointer& own) const { return own->triangles.size(); }
        uint64_t operator()(const FinishedPicturePointer& picture) const { return shownTriangles(*picture).size(); }
        uint64_t operator()(const AskedBoxes&) const { return 0; }
    };
    uint64_t count = 0;
    for (const Command& command : commands) count += std::visit(Counter{}, command);
    return count;
}

bool FrameLog::drawsScene() const {
    return std::ranges::all_of(commands, [](const Command& command) {
        const auto* list = std::get_if<DrawList>(&command);
        return std::holds_alternative<AskedBoxes>(command) ||
               (list != nullptr && list->depth == DepthRule::Nearest && list->grain == Grain::Triangle);
    });
}

Grain FrameLog::grain() const {
    const bool byObject = std::ranges::any_of(commands, [](const Command& command) {
        const auto* list = std::get_if<DrawList>(&command);
        return list != nullptr && list->grain == Grain::Object;
    });
    return byObject ? Grain::Object : Grain::Triangle;
}

uint32_t comparedItem(const Scene& scene, Grain grain, uint32_t item) {
    if (grain == Grain::Triangle || item == 0) return item;
    return uint32_t(scene.firstTriangle(scene.instanceOf(item - 1))) + 1;
}

size_t FrameLog::commandsWithin(size_t entries) const {
    size_t before = 0;  // decisions
    for (size_t command = 0; command < commands.size(); ++command) {
        while (before < decisions.size() && decisions[before].commands <= command) ++before;
        if (command + before >= entries) return command;
    }
    return std::min(commands.size(), entries);
}

namespace {

/// What a command holds.
struct BytesOf {
    template <typename Value, typename Allocator>
    [[nodiscard]] static uint64_t of(const std::vector<Value, Allocator>& values) {
        return values.size() * sizeof(Value);
    }
    uint64_t operator()(const DrawList& list) const { return of(list.ranges); }
    uint64_t operator()(const OwnTrianglesPointer& own) const {
        return of(own->positions) + of(own->normals) + of(own->triangles) + of(own->runs);
    }
    uint64_t operator()(const FinishedPicturePointer& picture) const { return of(picture->triangle) + of(picture->depth); }
    uint64_t operator()(const AskedBoxes& asked) const { return of(asked.boxes) + of(asked.hits) + of(asked.ends); }
};

}  // namespace

uint64_t FrameLog::frameBytes() const {
    uint64_t sum = counters.workBytes;
    for (const Command& command : commands) sum += std::visit(BytesOf{}, command);
    return sum;
}

FrameLog FrameLog::upTo(size_t entries) const {
    const size_t all = std::min(entries, this->entries());
    const auto drawn = std::ptrdiff_t(commandsWithin(all)), decided = std::ptrdiff_t(all) - drawn;
    FrameLog part;
    part.camera = camera;
    part.size = size;
    part.facing = facing;
    part.commands.assign(commands.begin(), commands.begin() + drawn);
    part.recorded = recorded;
    part.coarser = coarser;
    part.decisions.assign(decisions.begin(), decisions.begin() + decided);
    part.order = order;
    part.objects = objects;
    part.details.assign(details.begin(), std::ranges::lower_bound(details, size_t(decided), {}, &LoggedDetail::decision));
    part.whole = whole && all == this->entries();
    part.counters = counters;
    part.stages = stages;
    part.cullMilliseconds = cullMilliseconds;
    part.frameBeforeMilliseconds = frameBeforeMilliseconds;
    return part;
}

namespace {

/// Marks the scene triangles that commands drew.
class DrawnMarks {
public:
    explicit DrawnMarks(const Scene& scene) : m_scene(scene), m_drawn(scene.triangleCount(), 0) {}

    void operator()(const DrawList& list) {
        for (const DrawRange& range : list.ranges) {
            const uint32_t mesh = m_scene.instances()[range.instance].mesh;
            const uint64_t first = m_scene.firstTriangle(range.instance);
            if (list.standIn(mesh, range)) {
                std::fill_n(m_drawn.begin() + std::ptrdiff_t(first), m_scene.meshOf(range.instance).triangleCount(), uint8_t{1});
                continue;
            }
            for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
                m_drawn[first + list.triangleAt(mesh, place)] = 1;
        }
    }
    void operator()(const OwnTrianglesPointer& own) {
        for (const uint32_t triangle : own->triangles) m_drawn[triangle] = 1;
    }
    void operator()(const FinishedPicturePointer& picture) {
        for (const uint32_t item : picture->triangle)
            if (item != 0) m_drawn[item - 1] = 1;
    }
    void operator()(const AskedBoxes&) {}

    /// Ranges of consecutive triangles, by instance.
    [[nodiscard]] std::vector<DrawRange> ranges() const {
        std::vector<DrawRange> found;
        for (uint32_t instance = 0; instance < m_scene.instances().size(); ++instance) {
            const uint64_t first = m_scene.firstTriangle(instance), count = m_scene.meshOf(instance).triangleCount();
            for (uint64_t begin = 0, end = 0; begin < count; begin = end + 1) {
                while (begin < count && m_drawn[first + begin] == 0) ++begin;
                for (end = begin; end < count && m_drawn[first + end] != 0;) ++end;
                if (begin < end) found.push_back({instance, uint32_t(3 * begin), uint32_t(3 * (end - begin))});
            }
        }
        return found;
    }

private:
    const Scene& m_scene;
    std::vector<uint8_t> m_drawn;  ///< by scene triangle number
};

}  // namespace

DrawList drawnTriangles(const Scene& scene, const FrameLog& log) {
    const auto isList = [](const Command& command) { return std::holds_alternative<DrawList>(command); };
    const auto draws = [](const Command& command) { return !std::holds_alternative<AskedBoxes>(command); };
    if (std::ranges::count_if(log.commands, draws) == 1 && std::ranges::count_if(log.commands, isList) == 1)
        return std::get<DrawList>(*std::ranges::find_if(log.commands, isList));
    DrawnMarks marks(scene);
    for (const Command& command : log.commands) std::visit(marks, command);
    return {log.facing, marks.ranges(), {}, DepthRule::Nearest};
}

}  // namespace cullscope
