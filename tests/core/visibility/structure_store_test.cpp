#include "core/visibility/structure_store.h"

#include <future>
#include <semaphore>

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "core/visibility/built_strategy.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::structure_store_test {
namespace {

using namespace std::chrono_literals;

ParameterSet losslessWith(const char* key = nullptr, const char* value = nullptr) {
    ParameterSet parameters(findStrategy("spherical-lossless").info.parameters);
    if (key != nullptr) parameters.setFromText(key, value);
    return parameters;
}

TEST(StructureStore, eightOfOneStrategyShareOneStructure) {
    const ScenePointer scene = sceneOf({starMesh(7, 3'000)});
    StructureStore store;
    std::vector<BuiltStrategyPointer> views;
    for (int i = 0; i < 8; ++i) views.push_back(buildStrategy("spherical-lossless", losslessWith(), scene, store));
    EXPECT_EQ(store.built(), 1u);
    for (const BuiltStrategyPointer& view : views) EXPECT_EQ(view->structure(), views.front()->structure());
}

TEST(StructureStore, countsTheBytesOfStructuresThatHaveUsersEachOnce) {
    const ScenePointer scene = sceneOf({starMesh(7, 3'000)});
    StructureStore store;
    EXPECT_EQ(store.bytes(), 0u);
    BuiltStrategyPointer one = buildStrategy("spherical-lossless", losslessWith(), scene, store);
    const BuiltStrategyPointer same = buildStrategy("spherical-lossless", losslessWith("cones", "off"), scene, store);
    const uint64_t ofOne = one->report().bytes;
    EXPECT_GT(ofOne, 10'000u);
    EXPECT_EQ(store.bytes(), ofOne) << "of both together";
    BuiltStrategyPointer other = buildStrategy("spherical-lossless", losslessWith("level", "3"), scene, store);
    EXPECT_EQ(store.bytes(), ofOne + other->report().bytes);
    other.reset();
    EXPECT_EQ(store.bytes(), ofOne);
}

TEST(StructureStore, parameterOfCullingBuildsNothingAndOneOfBuildingOneMore) {
    const ScenePointer scene = sceneOf({starMesh(7, 3'000)});
    StructureStore store;
    const BuiltStrategyPointer first = buildStrategy("spherical-lossless", losslessWith(), scene, store);
    for (const auto& [key, value] : {std::pair("cones", "off"), {"horizon", "off"}, {"facing", "two-sided"}}) {
        const BuiltStrategyPointer other = buildStrategy("spherical-lossless", losslessWith(key, value), scene, store);
        EXPECT_EQ(other->structure(), first->structure()) << key;
        EXPECT_NE(other->parameters(), first->parameters()) << key;
        EXPECT_EQ(store.built(), 1u) << key;
    }
    size_t built = 1;
    for (const auto& [key, value] : {std::pair("level", "4"), {"layout", "latitude-longitude"}}) {
        const BuiltStrategyPointer other = buildStrategy("spherical-lossless", losslessWith(key, value), scene, store);
        EXPECT_NE(other->structure(), first->structure()) << key;
        EXPECT_EQ(store.built(), ++built) << key;
    }
}

TEST(StructureStore, otherSceneAndOtherStrategyHaveTheirOwn) {
    const ScenePointer one = sceneOf({starMesh(7, 300)}), other = sceneOf({starMesh(7, 300)});
    StructureStore store;
    const auto built = [&](const char* id, const ScenePointer& scene) {
        return buildStrategy(id, ParameterSet(findStrategy(id).info.parameters), scene, store);
    };
    const BuiltStrategyPointer all = built("all", one), backface = built("backface", one), elsewhere = built("all", other);
    EXPECT_EQ(store.built(), 3u);
    EXPECT_EQ(elsewhere->scenePointer(), other);
    EXPECT_NE(all->structure(), backface->structure());
}

TEST(StructureStore, structureIsFreedWhenItsLastUserLeaves) {
    const ScenePointer scene = sceneOf({starMesh(7, 3'000)});
    StructureStore store;
    BuiltStrategyPointer one = buildStrategy("spherical-lossless", losslessWith(), scene, store), other = one;
    const std::weak_ptr<const Structure> structure = one->structure();
    one = nullptr;
    EXPECT_FALSE(structure.expired());
    other = buildStrategy("spherical-lossless", losslessWith("cones", "off"), scene, store);
    EXPECT_FALSE(structure.expired()) << "its user changed, and uses it still";
    other = nullptr;
    EXPECT_TRUE(structure.expired());
    EXPECT_EQ(scene.use_count(), 1) << "the store keeps no scene";
    other = buildStrategy("spherical-lossless", losslessWith(), scene, store);
    EXPECT_EQ(store.built(), 2u);
}

/// Another value of a parameter than its default.
ParameterValue otherValue(const ParameterDeclaration& declaration) {
    switch (declaration.type) {
        case ParameterType::Boolean:
            return !std::get<bool>(declaration.defaultValue);
        case ParameterType::Integer: {
            const auto value = std::get<int64_t>(declaration.defaultValue);
            return double(value) < declaration.maximum ? value + 1 : value - 1;
        }
        case ParameterType::Real: {
            const auto value = std::get<double>(declaration.defaultValue);
            return 0.5 * (value + (value > declaration.minimum ? declaration.minimum : declaration.maximum));
        }
        case ParameterType::File:
            return std::string("sets.json");
        case ParameterType::Choice:
            break;
    }
    const auto& choices = declaration.choices;
    return choices[0].id == std::get<std::string>(declaration.defaultValue) ? choices[1].id : choices[0].id;
}

TEST(StructureStore, aProofThatIsStoppedPromisesLessAndIsNotKept) {
    const ScenePointer scene = sceneOf({starMesh(7, 300)});
    StructureStore store;
    const auto promise = [&](const Progress& progress) {
        return buildStrategy("backface", ParameterSet(findStrategy("backface").info.parameters), scene, store, progress)
            ->promise();
    };
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(promise({nullptr, stop.get_token()}), Promise::Approximate);
    EXPECT_EQ(promise({}), Promise::Conservative);
}

TEST(StructureStore, buildTextChangesWithTheParametersOfBuildingAlone) {
    size_t culling = 0, building = 0;
    for (const RegisteredStrategy& registered : strategies())
        for (const ParameterDeclaration& declaration : registered.info.parameters) {
            const ParameterSet before(registered.info.parameters);
            ParameterSet after = before;
            after.set(declaration.key, otherValue(declaration));
            ASSERT_NE(after, before) << registered.info.id << " " << declaration.key;
            const bool same = after.buildText() == before.buildText();
            EXPECT_EQ(same, declaration.use == ParameterUse::Culling) << registered.info.id << " " << declaration.key;
            ++(same ? culling : building);
        }
    EXPECT_GT(culling, 10u);
    EXPECT_GT(building, 3u);
}

/// A strategy whose build waits until it may go on.
class Waiting final : public StrategyWith<Structure> {
public:
    mutable std::counting_semaphore<> begun{0}, mayGoOn{0};
    mutable std::atomic<int> builds{0};
    std::atomic<bool> fails{false};

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        ++builds;
        begun.release();
        if (!mayGoOn.try_acquire_for(30s)) throw std::runtime_error("the test did not let it go on");
        if (fails) throwInterrupted();
    }
    void decide(FrameContext& /*frame*/, const Structure& /*structure*/, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {}
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
};

class WaitingStore : public testing::Test {
protected:
    std::future<StructurePointer> ask(const Progress& progress = {}) { return ask(m_scene, progress); }
    std::future<StructurePointer> ask(const ScenePointer& scene, const Progress& progress = {}) {
        return std::async(std::launch::async,
                          [this, scene, progress] { return m_store.get(m_registered, ParameterSet(), scene, progress); });
    }
    [[nodiscard]] bool begins() const { return m_strategy->begun.try_acquire_for(30s); }

    std::shared_ptr<Waiting> m_strategy = std::make_shared<Waiting>();
    RegisteredStrategy m_registered{{"waiting", "", "", "", {}}, m_strategy};
    ScenePointer m_scene = sceneOf({squareMesh(1, 0)});
    StructureStore m_store;
};

TEST_F(WaitingStore, twoThreadsThatAskAtOnceGetTheSame) {
    std::future<StructurePointer> one = ask();
    ASSERT_TRUE(begins());
    std::future<StructurePointer> other = ask();
    EXPECT_EQ(other.wait_for(200ms), std::future_status::timeout) << "it waits for the first";
    m_strategy->mayGoOn.release();
    const StructurePointer built = one.get();
    EXPECT_EQ(other.get(), built);
    EXPECT_EQ(m_strategy->builds, 1);
    EXPECT_EQ(m_store.built(), 1u);
}

TEST_F(WaitingStore, anotherStrategyOfTheSameIdBuildsItsOwn) {
    const auto other = std::make_shared<Waiting>();
    m_strategy->mayGoOn.release();
    other->mayGoOn.release();
    const StructurePointer one = m_store.get(m_registered, ParameterSet(), m_scene);
    const StructurePointer two = m_store.get({{"waiting", "", "", "", {}}, other}, ParameterSet(), m_scene);
    EXPECT_NE(one, two);
    EXPECT_EQ(other->builds, 1);
    EXPECT_EQ(m_store.built(), 2u);
}

TEST_F(WaitingStore, stopWhileAnotherThreadBuildsInterruptsTheOneThatWaits) {
    std::future<StructurePointer> builder = ask();
    ASSERT_TRUE(begins());
    std::stop_source source;
    Progress progress;
    progress.stop = source.get_token();
    std::future<StructurePointer> waiting = ask(progress);
    EXPECT_EQ(waiting.wait_for(100ms), std::future_status::timeout);
    source.request_stop();
    try {
        (void)waiting.get();
        ADD_FAILURE() << "it was not interrupted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
    }
    m_strategy->mayGoOn.release();
    EXPECT_NE(builder.get(), nullptr) << "the other one is built";
    EXPECT_EQ(m_store.built(), 1u);
}

TEST_F(WaitingStore, interruptedBuildIsBegunAnewByTheOneThatWaits) {
    m_strategy->fails = true;
    std::future<StructurePointer> interrupted = ask();
    ASSERT_TRUE(begins());
    std::future<StructurePointer> other = ask();
    m_strategy->mayGoOn.release();
    EXPECT_THROW((void)interrupted.get(), Error);
    ASSERT_TRUE(begins());
    m_strategy->fails = false;
    m_strategy->mayGoOn.release();
    EXPECT_NE(other.get(), nullptr);
    EXPECT_EQ(m_strategy->builds, 2);
    EXPECT_EQ(m_store.built(), 1u);
}

TEST_F(WaitingStore, differentStructuresAreBuiltAtTheSameTime) {
    std::future<StructurePointer> one = ask(), other = ask(sceneOf({squareMesh(2, 0)}));
    EXPECT_TRUE(begins());
    EXPECT_TRUE(begins()) << "the second waits for the first";
    m_strategy->mayGoOn.release(2);
    EXPECT_NE(one.get(), other.get());
    EXPECT_EQ(m_store.built(), 2u);
}

}  // namespace
}  // namespace cullscope::test::structure_store_test
