// What strategies declare: their shows, sweeps and baselines.

#include "core/visibility/show.h"

#include <set>

#include "core/mesh/parametric.h"
#include "core/visibility/built_strategy.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::shows_test {
namespace {

TEST(Shows, haveWordsAndSayWhyTheyAreAbsent) {
    const std::set<std::string> common{kVerdictsOverlay, kBoxesOverlay, kFrustumOverlay, kSphericalModelOverlay};
    for (const RegisteredStrategy& strategy : strategies())
        for (const Show& show : strategy.info.shows) {
            EXPECT_EQ(show.help.empty(), show.kind == Show::Kind::Listing || show.kind == Show::Kind::Bars) << show.id;
            EXPECT_EQ(common.contains(show.id), show.kind == Show::Kind::Boxes) << show.id;
            // What cullbench draws says why a strategy has it not.
            using enum Show::Kind;
            const bool drawn = show.kind == Overlay || show.kind == DirectionMap;
            EXPECT_EQ(show.absent != nullptr, drawn) << show.id;
            EXPECT_EQ(show.lines.empty(), show.kind != Listing) << show.id;
            EXPECT_FALSE((show.kind == Curve || show.kind == Bars) && show.title.empty()) << show.id;
            if (show.kind != Show::Kind::Overlay) continue;
            for (const std::string& words : {show.title, show.action, show.explanation}) EXPECT_FALSE(words.empty()) << show.id;
        }
}

TEST(Shows, areListedOnceWithAllColourings) {
    std::set<std::string> ids;
    for (const Show* show : declaredShows()) {
        EXPECT_TRUE(ids.insert(show->id).second) << show->id;
        for (const RegisteredStrategy& strategy : strategies())
            if (const Show* own = strategy.info.show(show->id)) {
                EXPECT_EQ(own->kind, show->kind);
                EXPECT_LE(own->colourings.size(), show->colourings.size());
            }
    }
    EXPECT_EQ(strategiesShowing("bands"), "spherical, spherical-horizon");
    EXPECT_EQ(strategiesShowing("index-map", "level"), "spherical-lossless");
}

TEST(Shows, strategyWithoutAShowSaysWhoHasIt) {
    StructureStore structures;
    const ScenePointer scene = sceneOf({sphereMesh(200)});
    for (const RegisteredStrategy& strategy : strategies()) {
        const auto built = buildStrategy(strategy.info.id, ParameterSet(strategy.info.parameters), scene, structures);
        for (const Show* show : declaredShows()) {
            if (strategy.info.show(show->id) != nullptr) continue;
            const std::optional<Message> why = built->whyNotShown(show->id, {}, FrameLog{});
            ASSERT_EQ(why.has_value(), show->absent != nullptr) << show->id;
            if (!why) continue;
            for (const std::string& words : {commandLineOption(show->id), strategy.info.id, strategiesShowing(show->id)})
                EXPECT_NE(why->english().find(words), std::string::npos) << why->english();
        }
        EXPECT_FALSE(built->whyNotShown("unknown", {}, FrameLog{}));
    }
}

TEST(Shows, sweepsAreOfDeclaredParameters) {
    for (const RegisteredStrategy& strategy : strategies())
        for (const DeclaredSweep& sweep : strategy.info.sweeps) {
            ParameterSet parameters(strategy.info.parameters);
            for (const std::string& value : sweep.values) EXPECT_NO_THROW(parameters.setFromText(sweep.key, value)) << sweep.key;
        }
}

TEST(Baselines, areListedFromTheWeakestToTheStrongest) {
    std::vector<std::string> ids;
    for (const StrategyInfo* info : baselines()) ids.push_back(info->id);
    EXPECT_EQ(ids, (std::vector<std::string>{"all", "backface"}));
}

}  // namespace
}  // namespace cullscope::test::shows_test
