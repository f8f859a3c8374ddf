#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/gpu/context.h"
#include "core/measure/accuracy.h"
#include "core/scene/drawn_sets.h"

namespace cullscope::suite {

/// What is judged: the scene, the poses, and what another program says that it draws at each.
struct JudgeRequest {
    ScenePointer scene;
    CameraPath path;
    DrawnSets drawn;
    Viewport size;
    Facing facing = Facing::TwoSided;  ///< the faces that the program draws of what it names
};

/// An object by its number, and the pixels that it has in the true picture.
struct SeenObject {
    uint32_t instance = 0;
    uint64_t pixels = 0;
};

/// One pose beside the truth.
struct JudgedPose {
    Accuracy accuracy;
    uint64_t visibleObjects = 0;
    std::vector<SeenObject> missing;  ///< visible objects of which a visible triangle is not drawn, most lost pixels first
    uint64_t drawnObjects = 0;        ///< of which anything is drawn
    uint64_t inVain = 0;              ///< of these, those of which nothing is visible
    uint64_t inVainInView = 0;        ///< of these, those whose bounds do not lie outside the view
    uint64_t leftOut = 0;             ///< objects with triangles of which nothing is drawn
    uint64_t leftOutInView = 0;       ///< of these, those whose bounds do not lie outside the view
};

/// What a set of drawn objects or triangles is, by what it leaves out.
enum class CullingKind {
    None,       ///< nothing is left out
    Frustum,    ///< only what lies outside the view
    Occlusion,  ///< also what lies in the view and is not seen, and nothing that is seen
    Lossy,      ///< something that is seen is missing
    Unseen      ///< unknown: no pixel shows anything of the scene
};

struct Judgement {
    std::vector<JudgedPose> poses;
    bool byObjects = true;

    [[nodiscard]] Accuracy total() const;  ///< summed over the poses; the largest hole of any
    [[nodiscard]] CullingKind kind() const;
    /// Nothing that is seen is missing; so, too, where nothing is seen.
    [[nodiscard]] bool right() const { return kind() != CullingKind::Lossy; }
    /// The pose with the most missed pixels; none where none are missed.
    [[nodiscard]] std::optional<size_t> worstPose() const;
};

/// Judges every pose. Needs a current context. Throws Error(Input) where the path and the sets have other numbers of poses,
/// Error(Interrupted) on a stop request.
[[nodiscard]] Judgement judgeDrawn(const JudgeRequest& request, Renderer& renderer, const Progress& progress = {});

/// What a set is called, one English sentence marked for translation.
[[nodiscard]] Message kindSentence(const Judgement& judgement);

[[nodiscard]] std::string judgementText(const Judgement& judgement, const JudgeRequest& request);
[[nodiscard]] std::string judgementJson(const Judgement& judgement, const JudgeRequest& request, const GlInfo& gl);

}  // namespace cullscope::suite
