// A view's look in session files, which older and newer versions read.

#include <gtest/gtest.h>

#include "core/visibility/registry.h"
#include "ui/session/session_json.h"

namespace cullscope::ui::session_look_test {
namespace {

using Json = nlohmann::ordered_json;

/// What a file has before and behind the overlays that strategies declare.
std::string written(const ViewLook& look) {
    ViewSetup setup;
    setup.look = look;
    Json json = jsonOf(setup)["look"];
    for (const Show* show : declaredShows(Show::Kind::Overlay)) {
        EXPECT_EQ(json.at(show->id), look.shows(show->id));
        json.erase(show->id);
    }
    return json.dump();
}

TEST(SessionLook, isWrittenAsAlways) {
    EXPECT_EQ(
        written({}),
        R"({"colouring":"shaded","culled_too":true,"wireframe":false,"ghost":false,"back_sides":false,"frustum":false,"boxes":false,)"
        R"("box_colouring":"verdict","spherical_model":false})");
    ViewLook look{"verdicts", "frustum", "boxes", "planes", "bands", "spherical-model"};
    look.show("culled_too", false);
    EXPECT_EQ(
        written(look),
        R"({"colouring":"verdicts","culled_too":false,"wireframe":false,"ghost":false,"back_sides":false,"frustum":true,"boxes":true,)"
        R"("box_colouring":"plane","spherical_model":true})");
}

TEST(SessionLook, declaredOverlaysStandBeforeTheModel) {
    const Json look = jsonOf(ViewSetup())["look"];
    std::vector<std::string> keys;
    for (const auto& [key, value] : look.items()) keys.push_back(key);
    EXPECT_EQ(keys.back(), "spherical_model");
    EXPECT_EQ(keys.at(8), "bands");
    EXPECT_EQ(keys.at(9), "sizes");
}

}  // namespace
}  // namespace cullscope::ui::session_look_test
