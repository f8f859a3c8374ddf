#include "core/visibility/occlusion/hiz_groups.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "core/visibility/object_nodes.h"

namespace cullscope::occlusion {
namespace {

/// Of fewer objects a group is not asked about: its objects are.
constexpr uint32_t kLeastObjects = 8;

}  // namespace

void ShownGroups::beginFrame() {
    ++m_frame;
    std::erase_if(m_until, [&](const auto& noted) { return noted.second <= m_frame; });
}

std::vector<uint32_t> leavesOfObjects(const InstanceOctree& octree, size_t objects) {
    std::vector<uint32_t> leaves(objects, kNoLeaf);
    for (uint32_t number = 0; number < octree.nodes().size(); ++number) {
        const InstanceOctree::Node& node = octree.nodes()[number];
        if (!node.leaf()) continue;
        for (const uint32_t instance : octree.instancesOf(node)) leaves[instance] = number;
    }
    return leaves;
}

std::vector<float> largestOfNodes(const InstanceOctree& octree, const Scene& scene) {
    std::vector<float> largest(octree.nodes().size(), 0.0F);
    // Children come after their parent.
    for (size_t number = octree.nodes().size(); number-- > 0;) {
        const InstanceOctree::Node& node = octree.nodes()[number];
        if (node.leaf())
            for (const uint32_t instance : octree.instancesOf(node)) {
                const Box3& box = scene.instanceBox(instance);
                largest[number] = std::max(largest[number], float(glm::dot(box.max - box.min, box.max - box.min)));
            }
        if (node.parent >= 0) largest[size_t(node.parent)] = std::max(largest[size_t(node.parent)], largest[number]);
    }
    return largest;
}

std::unordered_set<uint32_t> nodesAround(const std::vector<uint64_t>& objects, const std::vector<uint32_t>& leaves,
                                         const InstanceOctree& octree) {
    std::unordered_set<uint32_t> nodes;
    for (const uint64_t object : objects)
        for (auto node = int64_t(leaves[object]); node >= 0 && nodes.insert(uint32_t(node)).second;)
            node = octree.nodes()[size_t(node)].parent;
    return nodes;
}

HizGroups::HizGroups(const InstanceOctree& octree, const std::vector<float>& largest, FrameContext& frame,
                     const HizGroupOptions& options, std::unordered_set<uint32_t> open, ShownGroups& shown)
    : m_octree(octree), m_largest(largest), m_frame(frame), m_options(options), m_open(std::move(open)), m_shown(shown) {
    m_shown.beginFrame();
}

std::vector<KeptObject> HizGroups::begin() {
    std::vector<KeptObject> kept = walk({{}}, Waits::Asked);
    const std::vector<KeptObject> large = largest();
    kept.insert(kept.end(), large.begin(), large.end());
    return kept;
}

std::vector<KeptObject> HizGroups::largest() {
    struct Waiting {
        double size = 0.0;  ///< squared: how large an object in it may look, its diagonal by its distance
        NodeEntry entry;

        bool operator<(const Waiting& other) const {
            return size != other.size ? size < other.size : entry.node > other.entry.node;
        }
    };
    const Vec3 eye = m_frame.view().eye();
    std::priority_queue<Waiting> queue;
    const auto takeWaiting = [&] {
        for (const NodeEntry& entry : std::exchange(m_waiting, {})) {
            const Box3& box = m_octree.nodes()[entry.node].box;
            const Vec3 beyond = glm::max(glm::max(box.min - eye, eye - box.max), Vec3(0.0));
            // Around the eye it looks as large as can be, unless it has no size.
            const double distance = std::max(glm::dot(beyond, beyond), std::numeric_limits<double>::min());
            queue.push({double(m_largest[entry.node]) / distance, entry});
        }
    };
    takeWaiting();
    std::vector<KeptObject> kept;
    while (!queue.empty() && kept.size() < m_options.large) {
        const NodeEntry entry = queue.top().entry;
        queue.pop();
        std::vector<NodeEntry> parts;
        addParts(parts, entry);
        const std::vector<KeptObject> objects = walk(std::move(parts), Waits::Nodes);
        kept.insert(kept.end(), objects.begin(), objects.end());
        takeWaiting();
    }
    std::vector<NodeEntry> left;
    for (; !queue.empty(); queue.pop()) left.push_back(queue.top().entry);
    if (left.empty()) return kept;
    // Of the groups that are left some are too small to be asked about, or rest after they showed.
    const std::vector<KeptObject> others = walk(std::move(left), Waits::Asked);
    kept.insert(kept.end(), others.begin(), others.end());
    return kept;
}

std::vector<KeptObject> HizGroups::ask(SecondPass& pass) {
    std::vector<KeptObject> kept;
    while (!m_waiting.empty()) {
        const std::vector<NodeEntry> asked = std::exchange(m_waiting, {});
        DrawnParts groups(m_frame.view());
        for (const NodeEntry& group : asked) {
            groups.add(group.node, Subject::ofNode(group.node), {});
            groups.addBox(grownBox(m_octree.nodes()[group.node].box, m_frame.view()));
        }
        const std::optional<std::vector<uint32_t>> shown = pass.shown(groups);
        std::vector<NodeEntry> further;
        for (uint32_t i = 0; i < asked.size(); ++i) {
            if (!shown) {
                further.push_back(asked[i]);
            } else if (std::ranges::binary_search(*shown, i)) {
                m_shown.note(asked[i].node);
                addParts(further, asked[i]);
            } else {
                leaveOut(asked[i].node);
            }
        }
        if (further.empty()) continue;
        const std::vector<KeptObject> more = walk(std::move(further), shown ? Waits::Asked : Waits::None);
        kept.insert(kept.end(), more.begin(), more.end());
    }
    return kept;
}

std::vector<KeptObject> HizGroups::walk(std::vector<NodeEntry> from, Waits waits) {
    if (m_octree.nodes().empty()) return {};
    OctreeWalkOptions options{
        .refine = true, .memory = m_options.planes, .lines = m_options.lines.walk, .visited = {}, .from = std::move(from)};
    // A group within the frustum is not kept as a whole: what is hidden is found object by object.
    options.visited = [&](uint32_t node, uint32_t planes) {
        const bool wait = waits == Waits::Asked ? isAsked(node) : waits == Waits::Nodes && !m_octree.nodes()[node].leaf();
        if (wait) m_waiting.push_back({node, planes});
        return !wait;
    };
    return keptObjects(m_octree, m_frame, &m_counters.walked, options);
}

bool HizGroups::isAsked(uint32_t node) const {
    const InstanceOctree::Node& group = m_octree.nodes()[node];
    return group.count >= kLeastObjects && !m_open.contains(node) && !m_shown.contains(node) &&
           canBeAskedAbout(grownBox(group.box, m_frame.view()), m_frame.view());
}

void HizGroups::leaveOut(uint32_t node) {
    const InstanceOctree::Node& group = m_octree.nodes()[node];
    ++m_counters.hiddenGroups;
    m_frame.counters().culledTriangles[size_t(Cause::Hidden)] += group.triangles;
    if (!m_frame.recording()) return;
    const auto end = ending(Subject::ofNode(node), Decision::Outcome::Culled, Cause::Hidden);
    m_frame.say(atLine(m_options.lines.hidden, end), m_octree.instancesOf(group));
}

void HizGroups::addParts(std::vector<NodeEntry>& entries, const NodeEntry& group) const {
    const InstanceOctree::Node& node = m_octree.nodes()[group.node];
    // The walk begins at a leaf again, which waits no more.
    if (node.leaf()) return entries.push_back(group);
    for (uint32_t part = 0; part < node.childCount; ++part) entries.push_back({node.firstChild + part, group.planes});
}

}  // namespace cullscope::occlusion
