#include "core/experiments/store/judged_frames.h"

#include <array>
#include <utility>

#include "core/experiments/result_fields.h"

namespace cullscope::store {
namespace {

using Count = std::pair<const char*, uint64_t Accuracy::*>;
constexpr std::array<Count, 18> kCounts{{{"covered", &Accuracy::coveredPixels},
                                         {"missed", &Accuracy::missedPixels},
                                         {"extra", &Accuracy::extraPixels},
                                         {"unresolved", &Accuracy::unresolvedPixels},
                                         {"largest_hole", &Accuracy::largestHolePixels},
                                         {"visible_triangles", &Accuracy::visibleTriangles},
                                         {"submitted_triangles", &Accuracy::submittedTriangles},
                                         {"false_culled_triangles", &Accuracy::falselyCulledTriangles},
                                         {"needlessly_drawn_triangles", &Accuracy::needlesslyDrawnTriangles},
                                         {"pixels", &Accuracy::pixels},
                                         {"scene_triangles", &Accuracy::sceneTriangles},
                                         {"scene_objects", &Accuracy::sceneObjects},
                                         {"visible_objects", &Accuracy::visibleObjects},
                                         {"submitted_objects", &Accuracy::submittedObjects},
                                         {"false_culled_objects", &Accuracy::falselyCulledObjects},
                                         {"needlessly_drawn_objects", &Accuracy::needlesslyDrawnObjects},
                                         {"outline", &Accuracy::outlinePixels},
                                         {"differently_covered", &Accuracy::differentlyCovered}}};

}  // namespace

std::string judgedText(const FrameMeasurement& frame) {
    if (!frame.accuracy) return {};
    ResultFields json = ResultFields::object();
    for (const auto& [key, member] : kCounts) json[key] = (*frame.accuracy).*member;
    json["lost"] = frame.lostPixels;
    json["wrongly_nearer"] = frame.wronglyNearerPixels;
    json["toggled"] = frame.toggledPixels;
    json["lost_objects"] = ResultFields::array();
    for (const LostObject& object : frame.lostObjects) json["lost_objects"].push_back({object.instance, object.pixels});
    json["differences"] = frame.pictureDifferences;
    return json.dump();
}

void addJudged(const std::string& text, FrameMeasurement& frame) {
    const ResultFields json = ResultFields::parse(text);
    Accuracy& accuracy = frame.accuracy.emplace();
    for (const auto& [key, member] : kCounts) accuracy.*member = json.at(key).get<uint64_t>();
    frame.lostPixels = json.at("lost").get<uint64_t>();
    frame.wronglyNearerPixels = json.at("wrongly_nearer").get<uint64_t>();
    frame.toggledPixels = json.at("toggled").get<uint64_t>();
    for (const ResultFields& object : json.at("lost_objects"))
        frame.lostObjects.push_back({object.at(0).get<uint32_t>(), object.at(1).get<uint64_t>()});
    frame.pictureDifferences = json.at("differences").get<std::vector<uint32_t>>();
}

}  // namespace cullscope::store
