#include "core/scene/gallery/gallery.h"

#include <algorithm>

#include "core/scene/gallery/gallery_parts.h"

namespace cullscope {
namespace {

struct GalleryScene {
    const char* id;
    const char* description;  ///< English, marked for translation
    gallery::Parts (*parts)();
};

// A line for each.
// clang-format off
constexpr GalleryScene kScenes[] = {
    {"gallery/case-1-sphere", CULLSCOPE_TR("a sphere beside a corner of the view that no single plane of it tells apart"), gallery::sphereBesideTheCorner},
    {"gallery/case-2-box", CULLSCOPE_TR("a box beside the view that no single plane of it tells apart"), gallery::boxBesideTheCorner},
    {"gallery/case-3-flat-box", CULLSCOPE_TR("a flat box above a plane"), gallery::flatBoxAboveAPlane},
    {"gallery/case-4-far-plane", CULLSCOPE_TR("a sphere that a plane cuts, ten million from the origin"), gallery::sphereAtAFarPlane},
    {"gallery/case-5-broken-file", CULLSCOPE_TR("what is left of a file with broken faces: one triangle"), gallery::whatIsLeftOfABrokenFile},
    {"gallery/case-6-seam", CULLSCOPE_TR("a triangle over the seam of a map of directions"), gallery::triangleOverTheSeam},
    {"gallery/case-7-pole", CULLSCOPE_TR("a triangle around the pole of a map of directions"), gallery::triangleOverThePole},
    {"gallery/case-8-azimuths", CULLSCOPE_TR("triangles at azimuths of 90 and 225 degrees"), gallery::azimuthsOfOtherQuadrants},
    {"gallery/case-9-rounded-azimuth", CULLSCOPE_TR("a triangle with a corner whose azimuth rounds to a whole turn"), gallery::azimuthThatRoundsToATurn},
    {"gallery/case-10-small-zenith", CULLSCOPE_TR("a triangle with a corner a hundred-millionth of a degree from the pole"), gallery::smallZenithAngle},
    {"gallery/case-11-centre", CULLSCOPE_TR("a corner and a centroid exactly at the centre of the bounding sphere"), gallery::cornersAtTheCentre},
    {"gallery/case-12-latitudes", CULLSCOPE_TR("a sphere from three radii, at latitudes from the equator to the pole"), gallery::latitudes},
    {"gallery/case-13-pole", CULLSCOPE_TR("a sphere from above and below its poles"), gallery::pole},
    {"gallery/case-14-corner-rays", CULLSCOPE_TR("a sphere half in view that all four corner rays miss"), gallery::missedByCornerRays},
    {"gallery/case-15-ball", CULLSCOPE_TR("a ball of half the radius of its bounding sphere: rays enter far from where they hit"), gallery::ballInItsSphere},
    {"gallery/case-16-torus", CULLSCOPE_TR("a torus tilted by 60 degrees, from afar"), gallery::torus},
    {"gallery/case-16-bowl", CULLSCOPE_TR("a thick bowl seen into its opening"), gallery::bowl},
    {"gallery/case-17-inside", CULLSCOPE_TR("a star-shaped body from inside and from its very centre"), gallery::insideAStar},
    {"gallery/case-18-depths", CULLSCOPE_TR("two squares a hundredth apart at distance 1000, near 0.01 and far a million"), gallery::twoDepths},
    {"gallery/case-20-tiny", CULLSCOPE_TR("a body of size 1e-18"), gallery::tiny},
    {"gallery/case-20-huge", CULLSCOPE_TR("a body of size 1e18"), gallery::huge},
    {"gallery/case-20-mixed", CULLSCOPE_TR("bodies of sizes 1e-18 and 1e18 in one scene"), gallery::mixedSizes},
    {"gallery/case-21-origin", CULLSCOPE_TR("four bodies at the origin, as those of case 21 that are moved"), gallery::atTheOrigin},
    {"gallery/case-21-transforms", CULLSCOPE_TR("four bodies moved by ten million through their transforms"), gallery::movedByTransforms},
    {"gallery/case-21-coordinates", CULLSCOPE_TR("four bodies moved by ten million through their coordinates"), gallery::movedByCoordinates},
    {"gallery/case-22-boxes", CULLSCOPE_TR("a box around the eye, and one that reaches beyond the far plane on all sides"), gallery::boxAroundTheEye},
    {"gallery/case-23-narrow", CULLSCOPE_TR("a body in a field of view of a hundredth of a degree"), gallery::narrowField},
    {"gallery/case-23-wide", CULLSCOPE_TR("a body in a field of view of 179 degrees"), gallery::wideField},
    {"gallery/case-24-turning", CULLSCOPE_TR("walls with bodies behind them, from an eye that turns by 180 degrees a second"), gallery::turningBehindWalls},
    {"gallery/case-25-names", CULLSCOPE_TR("four hundred boxes, each of which has a name in selection mode"), gallery::boxesToBeNamed},
    {"gallery/case-26-proxy", CULLSCOPE_TR("an object whose box holds the eye and the far plane"), gallery::boxAroundTheView},
    {"gallery/case-27-cycle", CULLSCOPE_TR("three bars that overlap each other in a cycle"), gallery::barsInACycle},
    {"gallery/case-28-pixels", CULLSCOPE_TR("a triangle and its complement whose edges pass through pixel centres of an 8x8 picture"), gallery::pixelRule},
    {"gallery/case-29-parts", CULLSCOPE_TR("200 by 200 abutting parts just below the threshold of small features"), gallery::smallAbuttingParts},
    {"gallery/case-30-mirrored", CULLSCOPE_TR("a mirrored body and a flattened one"), gallery::mirrored},
    {"gallery/case-31-coplanar", CULLSCOPE_TR("ten thousand triangles in one plane"), gallery::coplanar},
    {"gallery/case-31-edges", CULLSCOPE_TR("triangles that share their edges with many others"), gallery::sharedEdges},
    {"gallery/case-31-slivers", CULLSCOPE_TR("slivers a billion times as long as wide, among random triangles"), gallery::slivers},
    {"gallery/case-31-random", CULLSCOPE_TR("ten thousand random triangles that fill a cube"), gallery::randomTriangles},
    {"gallery/case-32-rounding", CULLSCOPE_TR("two squares one rounding of a float apart"), gallery::oneRoundingApart},
    {"gallery/case-33-near", CULLSCOPE_TR("triangles through the near plane with every corner outside the view"), gallery::acrossTheNearPlane},
    {"gallery/case-34-nothing", CULLSCOPE_TR("an empty object and triangles without area beside a square"), gallery::nothingBesideSomething},
    {"gallery/case-35-inside-out", CULLSCOPE_TR("a closed mesh of two boxes that cross, one of which is inside out"), gallery::partlyInsideOut},
};
// clang-format on

const GalleryScene& sceneOf(std::string_view id) { return *std::ranges::find(kScenes, id, &GalleryScene::id); }

OpenedScene openGallery(GeneratorRequest& request) {
    return {galleryScene(request.info.id), request.specification, std::nullopt};
}

SceneEstimate estimateGallery(GeneratorRequest& /*request*/) { return {}; }

}  // namespace

ScenePointer galleryScene(std::string_view id) {
    gallery::Parts parts = sceneOf(id).parts();
    SceneRemarks remarks;
    remarks.up = UpAxis::Y;
    if (!parts.cameras.empty()) remarks.camera = parts.cameras.front();
    remarks.cameras = std::move(parts.cameras);
    return std::make_shared<const Scene>(std::string(id), std::move(parts.meshes), std::move(parts.instances), nullptr,
                                         std::move(remarks));
}

const std::vector<Generator>& galleryGenerators() {
    static const std::vector<Generator> kGenerators = [] {
        std::vector<Generator> generators;
        for (const GalleryScene& scene : kScenes)
            generators.push_back({{scene.id, scene.description, {}}, openGallery, estimateGallery});
        return generators;
    }();
    return kGenerators;
}

const std::vector<GeneratorInfo>& galleryInfos() {
    static const std::vector<GeneratorInfo> kInfos = [] {
        std::vector<GeneratorInfo> infos;
        for (const Generator& generator : galleryGenerators()) infos.push_back(generator.info);
        return infos;
    }();
    return kInfos;
}

}  // namespace cullscope
