#include "core/mesh/load.h"

namespace cullscope {
namespace {

void addCount(std::vector<Message>& sentences, std::string_view text, size_t count) {
    if (count > 0) sentences.push_back({std::string(text), {std::to_string(count)}});
}

}  // namespace

bool LoadReport::clean() const { return sentences().empty(); }

std::vector<Message> LoadReport::sentences() const {
    std::vector<Message> all;
    addCount(all, CULLSCOPE_TR("Degenerate faces dropped (fewer than three different corners, or no area): %1."),
             degenerateFaces);
    addCount(all, CULLSCOPE_TR("Duplicate faces dropped: %1."), duplicateFaces);
    addCount(all, CULLSCOPE_TR("Non-manifold edges kept (with more than two triangles): %1."), nonManifoldEdges);
    addCount(
        all,
        CULLSCOPE_TR("Vertices dropped whose coordinates are NaN, infinite or beyond 1e30, with the faces that use them: %1."),
        nonFiniteVertices);
    addCount(all, CULLSCOPE_TR("Faces dropped that name a vertex which does not exist: %1."), outOfRangeFaces);
    addCount(all, CULLSCOPE_TR("Vertices dropped that no face uses: %1."), unreferencedVertices);
    addCount(all,
             CULLSCOPE_TR("Triangles whose sides change by more than a tenth, because their object is too large beside them for "
                          "floats: %1. Remove what lies far away, or make it an object of its own."),
             bentByRounding);
    all.insert(all.end(), remarks.begin(), remarks.end());
    return all;
}

}  // namespace cullscope
