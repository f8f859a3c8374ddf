#include "tests/rules/source_rules.h"

#include <unistd.h>

#include <fstream>

#include "core/visibility/registry.h"

namespace cullscope::rules::source_rules_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::UnorderedElementsAre;

/// A small tree without violations, in a temporary folder.
class PlantedTree : public testing::Test {
protected:
    PlantedTree() : m_root(fs::temp_directory_path() / ("cullscope rules " + std::to_string(getpid()))) {
        write("core/precompiled.h", "#include <vector>\n");
        write("core/base/error.h", "#include <string>\n");
        write("core/mesh/load.cpp", "#include \"core/base/error.h\"\n#include <OpenMesh/Core/IO/MeshIO.hh>\n");
        write("core/gpu/context.cpp", "#include <epoxy/gl.h>\n#include \"core/mesh/load.h\"\n");
        write("core/mesh/CMakeLists.txt",
              "cullscope_layer(mesh LINKS cullscope::base PRIVATE_LINKS OpenMeshCore)  # not Qt6::Core\n");
        write("core/visibility/registry.cpp", "#include \"core/visibility/frustum/octree.h\"\n");
        write("core/visibility/frustum/octree.h", "namespace cullscope::frustum {\n}\n");
        write("ui/panels/panel.cpp", "#include \"ui/session/session.h\"\n");
        write("ui/window.cpp",
              "#include \"ui/window.h\"\n#include \"core/gpu/context.h\"\n#include <QWidget>\n#include \"window.moc\"\n");
        write("app/cullbench.cpp", "#include \"core/mesh/load.h\"\n");
        write("app/cullscope.cpp", "#include \"ui/window.h\"\n#include <QApplication>\n");
        write("README.md",
              "# Cullscope\n\n![bunny](resources/help/bunny.png), [using](docs/using.md), [app](app/cullscope.cpp)\n");
        write("docs/using.md", "[S](methods/spherical.md#s), [below](#below), [bunny](https://example.org/bunny)\n");
        write("docs/methods/spherical.md", "![bunny](../../resources/help/bunny.png)\n");
        write("resources/help/help.en.md", "[using](../../docs/using.md)\n");
        write("resources/help/bunny.png", "");
    }
    ~PlantedTree() override {
        std::error_code ignored;
        fs::remove_all(m_root, ignored);
    }

    void write(const fs::path& file, const std::string& text) const {
        fs::create_directories((m_root / file).parent_path());
        std::ofstream(m_root / file) << text;
    }
    [[nodiscard]] const fs::path& root() const { return m_root; }

private:
    fs::path m_root;
};

TEST_F(PlantedTree, treeWithoutOffenceIsNotReported) {
    EXPECT_THAT(layeringOffences(root()), IsEmpty());
    EXPECT_THAT(familyOffences(root()), IsEmpty());
    EXPECT_THAT(libraryOffences(root()), IsEmpty());
    EXPECT_THAT(linkOffences(root()), IsEmpty());
    EXPECT_THAT(topLevelOffences(root()), IsEmpty());
    EXPECT_THAT(pageOffences(root()), IsEmpty());
}

TEST_F(PlantedTree, includeOfAHigherLayerIsReported) {
    write("core/mesh/save.cpp", "\n  #  include \"core/scene/scene.h\"\n");
    EXPECT_THAT(layeringOffences(root()),
                ElementsAre(Offence{"core/mesh/save.cpp", 2, "layer mesh includes the higher layer scene: core/scene/scene.h"}));
}

TEST_F(PlantedTree, includeOfUiOrAppInCoreIsReported) {
    write("core/measure/run.cpp", "#include \"ui/session.h\"\n#include \"app/version.h\"\n");
    EXPECT_THAT(layeringOffences(root()), ElementsAre(Offence{"core/measure/run.cpp", 1, "core includes ui: ui/session.h"},
                                                      Offence{"core/measure/run.cpp", 2, "core includes app: app/version.h"}));
}

TEST_F(PlantedTree, includeThatHidesItsLayerIsReported) {
    write("core/mesh/save.cpp", "#include \"../scene/scene.h\"\n#include <core/scene/scene.h>\n");
    EXPECT_EQ(layeringOffences(root()).size(), 2u);
}

TEST_F(PlantedTree, includeOfALayerInACommonHeaderIsReported) {
    write("core/precompiled.h", "#include \"core/mesh/load.h\"\n");
    EXPECT_EQ(layeringOffences(root()).size(), 1u);
}

TEST_F(PlantedTree, folderThatIsNoLayerIsReported) {
    write("core/helpers/text.h", "");
    EXPECT_THAT(layeringOffences(root()),
                ElementsAre(Offence{"core/helpers", 0, "is a folder of core that has no place in its order"}));
}

TEST_F(PlantedTree, includeOfAHigherFolderOfUiIsReported) {
    write("ui/session/session.cpp", "#include \"ui/session/session.h\"\n#include \"ui/views/scene_view.h\"\n");
    EXPECT_THAT(
        layeringOffences(root()),
        ElementsAre(Offence{"ui/session/session.cpp", 2, "ui/session includes the higher folder views: ui/views/scene_view.h"}));
}

TEST_F(PlantedTree, folderOfUiWithoutAPlaceIsReported) {
    write("ui/helpers/text.h", "");
    EXPECT_THAT(layeringOffences(root()),
                ElementsAre(Offence{"ui/helpers", 0, "is a folder of ui that has no place in its order"}));
}

TEST_F(PlantedTree, familyKnownOutsideTheRegistryIsReported) {
    write("core/measure/meter.cpp", "#include \"core/visibility/frustum/octree.h\"\n");
    write("core/visibility/spherical/map.cpp",
          "#include \"core/visibility/frustum/octree.h\"\nnamespace cullscope::spherical {\n");
    write("core/experiments/tables.cpp", "#include \"core/visibility/frustum/octree.h\"\n");
    const Offence meter{"core/measure/meter.cpp", 1, "knows the family frustum: core/visibility/frustum/octree.h"};
    const Offence map{"core/visibility/spherical/map.cpp", 1, "knows the family frustum: core/visibility/frustum/octree.h"};
    EXPECT_THAT(familyOffences(root()), ElementsAre(meter, map));
}

TEST_F(PlantedTree, nameOfAFamilysNamespaceIsReported) {
    write("core/visibility/spherical/map.h", "namespace cullscope::spherical {\nstruct Map {};\n");
    write("core/visibility/spherical/map.cpp", "namespace cullscope::spherical {\nspherical::Map map;\n");
    write("core/image/picture.cpp", "// spherical::Map\nvoid draw(const spherical::Map& map);\n");
    write("ui/panels/panel.cpp", "spherical::Map map;\n");
    write("core/experiments/tables.cpp", "spherical::Map map;\n");
    EXPECT_THAT(familyOffences(root()), ElementsAre(Offence{"core/image/picture.cpp", 2, "names the family spherical"},
                                                    Offence{"ui/panels/panel.cpp", 1, "names the family spherical"}));
}

TEST_F(PlantedTree, idOfAStrategyIsReported) {
    const std::vector<std::string> ids{"all", "frustum"};
    write("core/measure/meter.cpp", "add(\"all\");  // \"frustum\"\n");
    write("ui/panel.cpp", "box->setText(tr(\"all\"));\nchoose(\"frustum\"), choose(\"frustum-octree\");\n");
    write("app/bench.cpp", "if (id.starts_with(\"frustum\")) return;\nsay(\"choose the strategy frustum\");\n");
    write("core/visibility/frustum/octree.cpp", "StrategyInfo info{\"frustum\"};\n");
    write("core/experiments/tables.cpp", "run(\"all\");\n");
    EXPECT_THAT(strategyIdOffences(root(), ids), ElementsAre(Offence{"core/measure/meter.cpp", 1, "names the strategy all"},
                                                             Offence{"ui/panel.cpp", 2, "names the strategy frustum"},
                                                             Offence{"app/bench.cpp", 1, "names the strategy frustum"}));
}

TEST_F(PlantedTree, idOfAStrategyWithinASentenceOrAnIdentifierIsReported) {
    const std::vector<std::string> ids{"all", "backface", "frustum-octree", "scan-line"};
    write("ui/panel.cpp",
          "#include \"ui/backface.h\"\n"
          "label->setText(tr(\"Speed against\\nbackface [95 %]\"));  // backface\n"
          "label->setText(tr(\"all of them\") + tr(\"back faces\") + tr(\"backfaces\"));\n"
          "painter.scanLine(0);\n");
    write("core/measure/meter.h", "double ratioToBackface = 0.0;\nint backfaced, theBackfaces;  // ratioToBackface\n");
    write("app/bench.cpp", "say(\"scan-line draws\");\nconst Tree frustumOctreeOf(int x);\n");
    write("core/visibility/baseline/backface.cpp", "say(\"backface draws\");\n");
    const auto what = [](const std::string& id) { return "has the strategy " + id + " in a word"; };
    EXPECT_THAT(strategyWordOffences(root(), ids), UnorderedElementsAre(Offence{"ui/panel.cpp", 2, what("backface")},
                                                                        Offence{"core/measure/meter.h", 1, what("backface")},
                                                                        Offence{"app/bench.cpp", 1, what("scan-line")},
                                                                        Offence{"app/bench.cpp", 2, what("frustum-octree")}));
}

TEST_F(PlantedTree, idThatIsAnOrdinaryWordIsReportedWhereALiteralIsNothingButStrategies) {
    const std::vector<std::string> ids{"all", "backface", "frustum", "painter", "recorded", "spherical"};
    const auto what = [](const std::string& id) { return "has the strategy " + id + " in a word"; };
    for (const std::string id : {"all", "frustum", "painter", "recorded", "spherical"}) {
        write("ui/panel.cpp", "choose(\"" + id + "\");\nchoose(tr(\"" + id + "\"));\nchoose(\"" + id + ":box=length\");\nrun(\"" +
                                  id + ",x\");\nrun(\"x:a=1,b=2," + id + "\");\n");
        // Words of sentences, parts of other ids, and examples in comments.
        write("app/bench.cpp", "say(\"the " + id + " of a view\");\nsay(\"" + id + ", and more\");\nchoose(\"" + id +
                                   "-octree\");\nsay(\"\");  // \"" + id + "\"\n");
        std::vector<Offence> expected;
        for (int line = 1; line <= 5; ++line) expected.push_back({"ui/panel.cpp", line, what(id)});
        EXPECT_THAT(strategyWordOffences(root(), ids), testing::ElementsAreArray(expected)) << id;
    }
}

TEST_F(PlantedTree, wordOfAStrategysShowIsReported) {
    write("ui/panel.cpp", "label->setText(tr(\"Has no index map.\"));\n#include \"ui/index map.h\"\n");
    write("app/bench.cpp", "say(\"give --overlay index-map\");\n");
    write("core/visibility/spherical/map.cpp", "show.id = \"index-map\";\n");
    EXPECT_THAT(showWordOffences(root(), {"index-map", "Index map"}),
                UnorderedElementsAre(Offence{"app/bench.cpp", 1, "names what a strategy shows: index-map"},
                                     Offence{"ui/panel.cpp", 1, "names what a strategy shows: Index map"}));
}

TEST_F(PlantedTree, sourceOutsideItsFamilysNamespaceIsReported) {
    write("core/visibility/frustum/boxes.cpp", "namespace cullscope {\n");
    EXPECT_THAT(familyOffences(root()), ElementsAre(Offence{"core/visibility/frustum/boxes.cpp", 0,
                                                            "has not the namespace of its family: cullscope::frustum"}));
}

TEST_F(PlantedTree, includeOfAppInUiIsReported) {
    write("ui/panel.cpp", "#include \"app/arguments.h\"\n");
    EXPECT_THAT(layeringOffences(root()), ElementsAre(Offence{"ui/panel.cpp", 1, "ui includes app: app/arguments.h"}));
}

TEST_F(PlantedTree, includeOfUiOrQtInCullbenchIsReported) {
    write("app/cullbench_render.cpp", "#include \"ui/session.h\"\n#include <QImage>\n");
    EXPECT_THAT(layeringOffences(root()),
                ElementsAre(Offence{"app/cullbench_render.cpp", 1, "cullbench includes ui: ui/session.h"}));
    EXPECT_THAT(libraryOffences(root()), ElementsAre(Offence{"app/cullbench_render.cpp", 2, "uses Qt: QImage"}));
}

TEST_F(PlantedTree, includeOfQtInCoreIsReported) {
    for (const char* header : {"QString", "QtCore/QString", "QtGlobal", "qstring.h"}) {
        write("core/base/text.cpp", std::string("#include <") + header + ">\n");
        EXPECT_THAT(libraryOffences(root()), ElementsAre(Offence{"core/base/text.cpp", 1, std::string("uses Qt: ") + header}));
    }
}

TEST_F(PlantedTree, includeOfOpenGlOutsideItsLayerIsReported) {
    for (const char* header : {"epoxy/gl.h", "GL/gl.h", "EGL/egl.h", "QOpenGLFunctions_4_5_Core", "QOpenGLFramebufferObject"}) {
        write("ui/view.cpp", std::string("#include <") + header + ">\n");
        EXPECT_THAT(libraryOffences(root()),
                    ElementsAre(Offence{"ui/view.cpp", 1, std::string("uses OpenGL outside core/gpu: ") + header}));
    }
    write("ui/view.cpp", "#include <QOpenGLWidget>\n#include <QOpenGLContext>\n");
    EXPECT_THAT(libraryOffences(root()), IsEmpty());
}

TEST_F(PlantedTree, includeOfOpenMeshOutsideItsLayerIsReported) {
    write("core/scene/scene.cpp", "#include <OpenMesh/Core/Mesh/Traits.hh>\n");
    EXPECT_THAT(libraryOffences(root()),
                ElementsAre(Offence{"core/scene/scene.cpp", 1, "uses OpenMesh outside core/mesh: OpenMesh/Core/Mesh/Traits.hh"}));
}

TEST_F(PlantedTree, includeOfWhatTimesAFrameOutsideTheMeterIsReported) {
    const std::string header = "core/measure/render_frame.h";
    write("core/measure/timed_rounds.cpp", "#include \"" + header + "\"\n");
    EXPECT_THAT(meteringOffences(root()), IsEmpty());
    for (const char* file : {"core/experiments/table.cpp", "ui/session/meter.cpp", "tests/benchmark/race.cpp"})
        write(file, "#include \"" + header + "\"\n");
    const std::string what = "times frames outside core/measure: " + header;
    EXPECT_THAT(meteringOffences(root()),
                UnorderedElementsAre(Offence{"core/experiments/table.cpp", 1, what}, Offence{"ui/session/meter.cpp", 1, what},
                                     Offence{"tests/benchmark/race.cpp", 1, what}));
}

TEST_F(PlantedTree, linksToHigherLayersAndForeignLibrariesAreReported) {
    write("core/mesh/CMakeLists.txt",
          "cullscope_layer(mesh\n  LINKS cullscope::scene cullscope::ui\n  PRIVATE_LINKS Qt6::Core PkgConfig::epoxy)\n");
    write("core/scene/CMakeLists.txt", "cullscope_layer(scene LINKS cullscope_mesh OpenMeshTools)\n");
    write("ui/CMakeLists.txt", "target_link_libraries(cullscope_ui PRIVATE Qt6::Widgets cullscope::measure cullscope::app)\n");
    const std::vector<Offence> offences = linkOffences(root());
    EXPECT_THAT(offences,
                ElementsAre(Offence{"core/mesh/CMakeLists.txt", 2, "layer mesh links the higher layer scene"},
                            Offence{"core/mesh/CMakeLists.txt", 2, "core links ui"},
                            Offence{"core/mesh/CMakeLists.txt", 3, "core links Qt: Qt6::Core"},
                            Offence{"core/mesh/CMakeLists.txt", 3, "OpenGL is linked outside core/gpu: PkgConfig::epoxy"},
                            Offence{"core/scene/CMakeLists.txt", 1, "OpenMesh is linked outside core/mesh: OpenMeshTools"},
                            Offence{"ui/CMakeLists.txt", 1, "ui links app"}));
}

TEST_F(PlantedTree, strayFileAtTheTopIsReported) {
    write("notes.txt", "");
    write("build-clang/x", "");
    write(".gitignore", "");
    EXPECT_THAT(topLevelOffences(root()), ElementsAre(Offence{"notes.txt", 0, "has no place at the top of the tree"}));
}

TEST_F(PlantedTree, lineOfAPageThatIsTooLong) {
    std::string degrees;
    for (int i = 0; i < 120; ++i) degrees += "°";
    write("docs/using.md", degrees + "\n" + degrees + "°\n```\n" + std::string(121, '-') + "\n```\n");
    EXPECT_THAT(pageOffences(root()), ElementsAre(Offence{"docs/using.md", 2, "has 121 characters"},
                                                  Offence{"docs/using.md", 4, "has 121 characters"}));
    write("docs/using.md", "<https://example.org/" + std::string(200, 'a') + ">\n");
    EXPECT_THAT(pageOffences(root()), IsEmpty());
}

TEST_F(PlantedTree, readmeThatIsTooLong) {
    write("README.md", std::string(90, '\n'));
    EXPECT_THAT(pageOffences(root()), IsEmpty());
    write("README.md", std::string(91, '\n'));
    EXPECT_THAT(pageOffences(root()), ElementsAre(Offence{"README.md", 0, "has 91 lines"}));
}

TEST_F(PlantedTree, sourceThatIsTooLong) {
    write("core/mesh/load.cpp", std::string(350, '\n'));
    EXPECT_THAT(longSourceOffences(root()), IsEmpty());
    write("core/mesh/load.cpp", std::string(351, '\n'));
    EXPECT_THAT(longSourceOffences(root()), ElementsAre(Offence{"core/mesh/load.cpp", 0, "has 351 lines"}));
}

TEST_F(PlantedTree, linkThatLeadsToNothing) {
    write("README.md", "\n![castle](resources/help/castle.png)\n");
    write("docs/using.md", "[S](spherical.md#s), `[code](code.md)`\n```\n[code](code.md)\n```\n");
    write("resources/help/help.en.md", "[S](../../docs/spherical.md)\n");
    EXPECT_THAT(pageOffences(root()),
                ElementsAre(Offence{"README.md", 2, "links to nothing: resources/help/castle.png"},
                            Offence{"docs/using.md", 1, "links to nothing: spherical.md"},
                            Offence{"resources/help/help.en.md", 1, "links to nothing: ../../docs/spherical.md"}));
}

TEST_F(PlantedTree, linkThatLeavesTheHelpWindow) {
    write("docs/using.md", "[app](../app/cullscope.cpp)\n");
    EXPECT_THAT(pageOffences(root()),
                ElementsAre(Offence{"docs/using.md", 1, "links to what the help window has not: ../app/cullscope.cpp"}));
}

TEST_F(PlantedTree, codeOfAPageThatIsNotItsFile) {
    write("core/visibility/near/near.h", "#pragma once\n\nint near();\n");
    const std::string code = "```cpp\n// core/visibility/near/near.h\n#pragma once\n\nint near();\n";
    write("docs/using.md", "Text.\n\n" + code + "```\n\n```cpp\n// a sketch\nint far();\n```\n");
    EXPECT_THAT(pageOffences(root()), IsEmpty());
    write("docs/using.md", code + "int far();\n```\n");
    EXPECT_THAT(pageOffences(root()),
                ElementsAre(Offence{"docs/using.md", 6, "differs from core/visibility/near/near.h at its line 4"}));
    write("docs/using.md", "```cpp\n// core/visibility/near/near.h\n#pragma once\n\nint  near();\n```\n");
    EXPECT_THAT(pageOffences(root()),
                ElementsAre(Offence{"docs/using.md", 5, "differs from core/visibility/near/near.h at its line 3"}));
    write("docs/using.md", "```cpp\n// core/visibility/near/near.h\n#pragma once\n```\n");
    EXPECT_THAT(pageOffences(root()),
                ElementsAre(Offence{"docs/using.md", 3, "differs from core/visibility/near/near.h at its line 2"}));
    write("docs/using.md", "```cpp\n// core/visibility/far/far.h\n#pragma once\n```\n");
    EXPECT_THAT(pageOffences(root()),
                ElementsAre(Offence{"docs/using.md", 2, "shows a file that is not there: core/visibility/far/far.h"}));
}

/// The project's own tree.
const fs::path& project() {
    static const fs::path kProject = CULLSCOPE_SOURCE_DIR;
    return kProject;
}

TEST(SourceRules, includesAreFoundAtAll) { EXPECT_GT(includesBelow(project(), {"core", "ui", "app", "tests"}).size(), 100u); }
TEST(SourceRules, dependenciesPointUpTheList) { EXPECT_THAT(layeringOffences(project()), IsEmpty()); }
TEST(SourceRules, familiesAreKnownWhereTheyMayBe) { EXPECT_THAT(familyOffences(project()), IsEmpty()); }
TEST(SourceRules, strategiesAreListedByTheRegistryAlone) {
    std::vector<std::string> ids;
    for (const RegisteredStrategy& strategy : strategies()) ids.push_back(strategy.info.id);
    EXPECT_THAT(strategyIdOffences(project(), ids), IsEmpty());
    EXPECT_THAT(strategyWordOffences(project(), ids), IsEmpty());
}
TEST(SourceRules, whatStrategiesShowIsNamedWhereItIsDeclared) {
    std::vector<std::string> words;
    for (const Show& show : commonShows())
        if (show.id.find('-') != std::string::npos) words.push_back(show.id);
    for (const Show* show : declaredShows()) {
        if (!show->title.empty()) words.push_back(show->title);
        // An id of one word, as "boxes" and "distance", is a word of other things, too.
        if (show->id.find('-') != std::string::npos) words.push_back(show->id);
    }
    EXPECT_THAT(words, IsSupersetOf({"index-map", "index map", "Contour bands", "spherical-model"}));
    EXPECT_THAT(showWordOffences(project(), words), IsEmpty());
}
TEST(SourceRules, framesAreTimedByTheOneMeter) { EXPECT_THAT(meteringOffences(project()), IsEmpty()); }
TEST(SourceRules, librariesStayInTheirLayers) { EXPECT_THAT(libraryOffences(project()), IsEmpty()); }
TEST(SourceRules, targetsLinkUpTheList) { EXPECT_THAT(linkOffences(project()), IsEmpty()); }
TEST(SourceRules, topLevelIsAsDesigned) { EXPECT_THAT(topLevelOffences(project()), IsEmpty()); }
TEST(SourceRules, sourcesAreSplitBySubject) { EXPECT_THAT(longSourceOffences(project()), IsEmpty()); }
TEST(SourceRules, pagesAreShortAndTheirLinksLeadSomewhere) { EXPECT_THAT(pageOffences(project()), IsEmpty()); }

}  // namespace
}  // namespace cullscope::rules::source_rules_test
