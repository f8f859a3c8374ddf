#include "core/scene/scene_source.h"

#include <cmath>
#include <fstream>

#include "core/scene/camera_path.h"
#include "tests/support/packed_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/rvm_bytes.h"

namespace cullscope::scene_source_test {
namespace {

/// A temporary folder of the test, removed at its end.
class TemporaryFolder {
public:
    TemporaryFolder() : m_path(std::filesystem::path(testing::TempDir()) / name()) {
        std::filesystem::create_directories(m_path);
    }
    ~TemporaryFolder() { std::filesystem::remove_all(m_path); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Writes a tetrahedron about (10, 20, 30) with edges of 2 along the axes.
    [[nodiscard]] std::string tetrahedron(const std::string& file) const {
        std::ofstream(m_path / file) << "v 10 20 30\nv 12 20 30\nv 10 22 30\nv 10 20 32\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
        return (m_path / file).string();
    }
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    static std::string name() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        return std::string("cullscope-") + test->test_suite_name() + "-" + test->name();
    }
    std::filesystem::path m_path;
};

TEST(PackedScene, polygonsAndPlantsAreReadAsTheirContentIs) {
    const TemporaryFolder folder;
    const auto opened = [&](const std::string& name, const std::string& bytes) {
        std::ofstream(folder.path() / name, std::ios::binary) << bytes;
        return openScene((folder.path() / name).string());
    };
    const std::string polygons = "polygon A 0 0 0 1 0 0 0 1 0\nplane P1 1 0 0 -2\n", plant = test::rvmSample();
    for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"a.polygons", polygons}, {"a.rvm", plant}}) {
        const ScenePointer plain = opened(name, bytes).scene;
        for (const auto& [packing, packed] :
             {std::pair<std::string, std::string>{".gz", test::gzipped(bytes)}, {".xz", test::xzPacked(bytes)}}) {
            const OpenedScene read = opened(name + packing, packed);
            EXPECT_EQ(read.scene->name(), name + packing);
            EXPECT_EQ(read.scene->sha256(), plain->sha256());
            EXPECT_EQ(read.scene->planes().size(), plain->planes().size());
            EXPECT_EQ(read.scene->instances().front().name, plain->instances().front().name);
        }
    }
}

TEST(SceneEstimate, ofEveryGeneratorIsNearWhatItMakes) {
    for (const char* specification :
         {"teapot:triangles=8000", "sphere:triangles=5120", "torus:triangles=20000", "bowl:triangles=20000",
          "knot:triangles=20000", "star:triangles=5120", "layers:count=12,triangles=2000", "plant:pipelines=40",
          "plant:pipelines=200", "field:mesh=sphere:triangles=1280,n=7",
          "split:mesh=torus:triangles=20000,by=clusters,triangles=500", "mesh:torus:triangles=20000,triangles=4000"}) {
        SCOPED_TRACE(specification);
        const auto estimate = estimateScene(specification);
        ASSERT_TRUE(estimate && estimate->triangles);
        const ScenePointer made = openScene(specification).scene;
        EXPECT_NEAR(*estimate->triangles / double(made->triangleCount()), 1.0, 0.3);
        // Clusters are of the size asked for at most.
        EXPECT_GE(double(made->instances().size()) / estimate->objects, 0.7);
        EXPECT_LE(double(made->instances().size()) / estimate->objects, 2.5);
        EXPECT_FALSE(estimate->large());
    }
}

TEST(SceneEstimate, asksAboutLargeScenesAndReadsNoMesh) {
    EXPECT_TRUE(estimateScene("sphere:triangles=1e7")->large());
    EXPECT_TRUE(estimateScene("field:mesh=sphere:triangles=1e5,n=100")->large()) << "copies are drawn, each of them";
    EXPECT_TRUE(estimateScene("plant:pipelines=5000")->large());
    EXPECT_FALSE(estimateScene("sphere")->large());
    const auto unread = estimateScene("field:mesh=/no/such/file.obj,n=10");
    ASSERT_TRUE(unread);
    EXPECT_FALSE(unread->triangles);
    EXPECT_EQ(unread->objects, 100.0);
    EXPECT_FALSE(estimateScene("/no/such/file.obj"));
    for (const GeneratorInfo& generator : sceneGenerators()) EXPECT_TRUE(estimateScene(generator.id)) << generator.id;
    EXPECT_NE(test::refusalOf([] { (void)estimateScene("sphere:triangles=many"); }, ErrorKind::Usage).find("triangles"),
              std::string::npos);
}

std::string refusal(std::string_view specification, ErrorKind kind = ErrorKind::Usage) {
    return test::refusalOf([&] { (void)openScene(specification); }, kind);
}

TEST(SceneSource, badSpecificationIsRefused) {
    using testing::HasSubstr;
    EXPECT_THAT(refusal(""), HasSubstr("No scene"));
    EXPECT_THAT(refusal("spere"), HasSubstr("\"spere\" is neither a file nor a generator. Generators: bunny, teapot, sphere"));
    EXPECT_THAT(refusal("sphere:triangle=100"), HasSubstr("no parameter \"triangle\". It has: triangles"));
    EXPECT_THAT(refusal("sphere:seed=1"), HasSubstr("no parameter \"seed\""));
    EXPECT_THAT(refusal("sphere:100"), HasSubstr("\"100\" is not of the form key=value"));
    for (const char* number : {"many", "-5", "0", "1e99", "nan", "1e3x", "0x10"})
        EXPECT_THAT(refusal(std::string("sphere:triangles=") + number), HasSubstr("triangles")) << number;
    EXPECT_THAT(refusal("torus:triangles=3"), HasSubstr("18"));
    EXPECT_THAT(refusal("star:seed=-1"), HasSubstr("seed=-1"));
    EXPECT_THAT(refusal("mesh:"), HasSubstr("mesh:FILE"));
    EXPECT_THAT(refusal("field:mesh=x.obj,n=0"), HasSubstr("n=0"));
    EXPECT_THAT(refusal("field:mesh=x.obj,count=3"), HasSubstr("no parameter \"count\". It has: mesh, n, spacing"));
    EXPECT_THAT(refusal("/no/such/file.obj", ErrorKind::Input), HasSubstr("/no/such/file.obj"));
    EXPECT_THAT(refusal("field:mesh=/no/such/file.obj", ErrorKind::Input), HasSubstr("/no/such/file.obj"));
}

TEST(SceneSource, upIsGuessedOfAFileThatDoesNotSayIt) {
    const auto ofSize = [](double x, double y, double z) {
        Box3 box;
        box.add(Vec3(1.0, 2.0, 3.0));
        box.add(Vec3(1.0 + x, 2.0 + y, 3.0 + z));
        return guessedUpAxis(box);
    };
    EXPECT_EQ(ofSize(10, 8, 4), UpAxis::Z) << "flat along z";
    EXPECT_EQ(ofSize(10, 8, 4.1), UpAxis::Y);
    EXPECT_EQ(ofSize(10, 3, 4), UpAxis::Y) << "flat along y";
    EXPECT_EQ(ofSize(10, 8, 0), UpAxis::Y) << "a drawing";
    EXPECT_EQ(guessedUpAxis(Box3{}), UpAxis::Y);

    const TemporaryFolder folder;
    const std::string file = (folder.path() / "flat.obj").string();
    std::ofstream(file) << "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    for (const std::string& specification : {file, "split:mesh=" + file, "mesh:" + file + ",triangles=6"}) {
        const ScenePointer scene = openScene(specification).scene;
        EXPECT_FALSE(scene->remarks().up) << specification;
        EXPECT_EQ(scene->upAxis(), UpAxis::Z) << specification;
        EXPECT_EQ(overviewCamera(*scene, 1.5).up, Vec3(0, 0, 1)) << specification;
        EXPECT_EQ(cameraPath("orbit:1", *scene).poses[0].up, Vec3(0, 1, 0)) << "a path depends on no guess";
    }
    EXPECT_EQ(openScene(folder.tetrahedron("cubic.obj")).scene->upAxis(), UpAxis::Y);
}

TEST(SceneSource, generatorGivesAboutTheTrianglesAskedFor) {
    for (const char* generator : {"sphere", "torus", "knot", "star", "teapot"}) {
        const OpenedScene opened = openScene(std::string(generator) + ":triangles=2e4");
        EXPECT_NEAR(double(opened.scene->triangleCount()), 2e4, 3e3) << generator;
        EXPECT_EQ(opened.scene->instances().size(), 1u);
        EXPECT_EQ(opened.specification, std::string(generator) + ":triangles=2e4");
        EXPECT_FALSE(opened.report.has_value());
    }
    EXPECT_NE(openScene("star:seed=1,triangles=2000").scene->sha256(), openScene("star:triangles=2000,seed=2").scene->sha256());
    EXPECT_EQ(openScene("star:seed=2,triangles=2000").scene->sha256(), openScene("star:triangles=2000,seed=2").scene->sha256());
}

TEST(SceneSource, listedDefaultIsTheOneUsed) {
    for (const GeneratorInfo& info : sceneGenerators()) {
        EXPECT_FALSE(info.description.empty()) << info.id;
        if (info.id == "bunny" || info.id == "field" || info.id == "mesh" || info.id == "split") continue;
        std::string spelledOut = info.id + ":";
        for (const GeneratorParameter& parameter : info.parameters)
            if (!parameter.defaultValue.empty())
                spelledOut += (spelledOut.back() == ':' ? "" : ",") + parameter.key + "=" + parameter.defaultValue;
        EXPECT_EQ(openScene(info.id).scene->triangleCount(), openScene(spelledOut).scene->triangleCount()) << spelledOut;
    }
}

TEST(SceneSource, fileWithOddCharactersOrTheNameOfAGeneratorIsFound) {
    const TemporaryFolder folder;
    for (const char* name : {"a,b.obj", "n,5,x.obj", "with space.obj", "n=3.obj"}) {
        const std::string file = folder.tetrahedron(name);
        EXPECT_EQ(openScene(file).scene->triangleCount(), 4u) << name;
        EXPECT_EQ(openScene("field:mesh=" + file + ",n=2").scene->instances().size(), 4u) << name;
        EXPECT_EQ(openScene("mesh:" + file + ",triangles=4").scene->triangleCount(), 4u) << name;
    }
    const std::string sphere = folder.tetrahedron("sphere.obj");
    EXPECT_EQ(openScene(sphere).scene->triangleCount(), 4u);
}

TEST(SceneSource, fieldStandsInItsGrid) {
    const TemporaryFolder folder;
    const std::string file = folder.tetrahedron("tetrahedron.obj");
    const ScenePointer scene = openScene("field:mesh=" + file + ",n=3,spacing=2.5").scene;
    ASSERT_EQ(scene->instances().size(), 9u);
    EXPECT_EQ(scene->meshes().size(), 1u) << "the copies share their mesh";
    EXPECT_EQ(scene->triangleCount(), 36u);
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            const size_t number = 3 * i + j;
            const Vec3 place((double(i) - 1) * 2.5, 0, (double(j) - 1) * 2.5);
            Box3 box;
            double farthest = 0.0;
            for (size_t v = 0; v < 4; ++v) {
                const Vec3 world(scene->instances()[number].worldFromMesh * Vec4(scene->meshOf(number).position(v), 1.0));
                box.add(world);
                farthest = std::max(farthest, glm::distance(world, place));
            }
            EXPECT_NEAR(glm::distance(box.centre(), place), 0.0, 1e-6) << "the centre of its box";
            EXPECT_NEAR(farthest, 1.0, 1e-6) << "its farthest vertex";
        }
}

TEST(SceneSource, fieldOfOneIsInTheMiddle) {
    const TemporaryFolder folder;
    const ScenePointer scene = openScene("field:mesh=" + folder.tetrahedron("one.obj") + ",n=1").scene;
    EXPECT_NEAR(glm::length(scene->bounds().centre()), 0.0, 1e-6);
}

TEST(SceneSource, fieldOfAPointStaysFiniteOrIsRefused) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "empty.obj").string();
    std::ofstream(file) << "v 1 2 3\n";
    try {
        const ScenePointer scene = openScene("field:mesh=" + file + ",n=2").scene;
        for (const Instance& instance : scene->instances()) EXPECT_TRUE(std::isfinite(instance.worldFromMesh[0][0]));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Input) << error.what();
    }
}

TEST(SceneSource, bunnyIsLookedForInTheGivenFoldersFirst) {
    const TemporaryFolder folder;
    const std::string file = folder.tetrahedron("bunny.obj");
    SceneSourceOptions options;
    options.modelFolders = {folder.path()};
    EXPECT_EQ(findBunny(options), std::filesystem::path(file)) << "the given folders come first";
    EXPECT_EQ(defaultSceneSpecification(options), "bunny");
    EXPECT_EQ(openScene("bunny", options).scene->triangleCount(), 4u);
    EXPECT_EQ(openScene("field:n=2", options).scene->instances().size(), 4u);
    EXPECT_TRUE(openScene("bunny", options).report.has_value());
}

TEST(SceneSource, stopIsAnswered) {
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    const TemporaryFolder folder;
    try {
        (void)openScene(folder.tetrahedron("some.obj"), {}, progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
    }
}

}  // namespace
}  // namespace cullscope::scene_source_test
