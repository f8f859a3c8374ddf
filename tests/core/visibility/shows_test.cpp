// What strategies declare: their shows, sweeps and baselines.

#include "core/visibility/show.h"

#include <set>

#include "core/mesh/parametric.h"
#include "core/scene/camera_path.h"
#include "core/visibility/built_strategy.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::shows_test {
namespace {

TEST(Shows, haveWordsAndSayWhyTheyAreAbsent) {
    std::set<std::string> common;
    for (const Show& show : commonShows()) EXPECT_TRUE(common.insert(show.id).second) << show.id;
    for (const RegisteredStrategy& strategy : strategies())
        for (const Show& show : strategy.info.shows) {
            using enum Show::Kind;
            const bool data = show.kind == Listing || show.kind == Bars || show.kind == Tree || show.kind == Planes;
            EXPECT_EQ(show.help.empty(), data) << show.id;
            // Of these a strategy declares its own form, or that it has them.
            EXPECT_EQ(common.contains(show.id), show.kind == Boxes || show.kind == Planes) << show.id;
            // What cullbench draws says why a strategy has it not.
            const bool drawn = show.kind == Overlay || show.kind == DirectionMap;
            EXPECT_EQ(show.absent != nullptr, drawn) << show.id;
            EXPECT_EQ(show.lines.empty(), show.kind != Listing) << show.id;
            EXPECT_FALSE((show.kind == Curve || show.kind == Bars) && show.title.empty()) << show.id;
            if (show.kind != Show::Kind::Overlay) continue;
            for (const std::string& words : {show.title, show.action, show.explanation}) EXPECT_FALSE(words.empty()) << show.id;
        }
}

TEST(Shows, ofEveryStrategyHaveWordsForMenusAndTwoWordsOrNoneForFiles) {
    std::set<std::string> keys;
    for (const Show* show : pictureShows()) {
        SCOPED_TRACE(show->id);
        EXPECT_FALSE(show->title.empty());
        EXPECT_EQ(show->action.empty(), show->explanation.empty());
        EXPECT_EQ(show->field.on.empty(), show->field.off.empty());
        EXPECT_TRUE(keys.insert(show->field.key.empty() ? show->id : show->field.key).second);
        EXPECT_EQ(show->help.empty(), show->with().has_value()) << "the command line has it by its id";
        EXPECT_EQ(show->unusual.key.empty(), !show->with()) << "or by an option";
        // Only one switch has a kind that a picture asks for.
        if (show->kind == Show::Kind::Overlay) continue;
        EXPECT_EQ(std::ranges::count(pictureShows(), show->kind, &Show::kind), 1);
        EXPECT_EQ(&commonShow(show->kind), show);
    }
    std::vector<std::string> named;
    for (const Show* show : namedShows())
        if (!show->help.empty()) named.push_back(show->id);
    EXPECT_EQ(std::vector<std::string>(named.begin(), named.begin() + 6),
              (std::vector<std::string>{"verdicts", "wireframe", "ghost", "back-sides", "boxes", "frustum"}));
    EXPECT_EQ(named.back(), "spherical-model");
}

TEST(Shows, treeIsDeclaredByThoseThatTestBoxesAndNoOtherHasOne) {
    StructureStore structures;
    const ScenePointer scene = sceneOf({sphereMesh(200)});
    for (const RegisteredStrategy& strategy : strategies()) {
        if (strategy.info.glRequirement != GlRequirement::None) continue;
        SCOPED_TRACE(strategy.info.id);
        const BuiltStrategyPointer built =
            buildStrategy(strategy.info.id, ParameterSet(strategy.info.parameters), scene, structures);
        const FrameLog log = built->decide(View(overviewCamera(*scene, 1.0), {64, 64}), *built->begin(), true);
        const bool declared = strategy.info.first(Show::Kind::Tree) != nullptr;
        EXPECT_EQ(strategy.strategy->snapshot(*built->structure(), log).nodes.empty(), !declared);
        EXPECT_EQ(built->snapshot(log).nodes.empty(), !declared);
        EXPECT_EQ(built->whyNotShown(kBoxesShow, {}, log).has_value(), !declared);
        EXPECT_TRUE(declared || strategy.info.first(Show::Kind::Planes) == nullptr) << "what planes rejected are its boxes";
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
            if (strategy.info.show(show->id) != nullptr || show->kind == Show::Kind::Boxes) continue;
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
