// Writes which objects OpenSceneGraph draws of a scene at each pose of a camera path, to be judged by cullbench judge.
//   openscenegraph_drawn SCENE.obj PATH.json WIDTH HEIGHT none|frustum|frustum+small > DRAWN.json
// frustum+small: with its small-feature culling at 14 pixels. Draws into a pbuffer (needs DISPLAY), one thread. An object is what
// the file calls one ("o NAME"); it counts as drawn where OpenSceneGraph calls its draw function in the frame.
// tests/benchmark/judge_openscenegraph compiles and runs it. It is no part of the build, which does not need OpenSceneGraph.
#include <osg/Geometry>
#include <osg/GraphicsContext>
#include <osg/Version>
#include <osgDB/ReadFile>
#include <osgUtil/Optimizer>
#include <osgViewer/Viewer>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace {

/// Notes the object's name whenever it is drawn.
struct NoteWhatIsDrawn : osg::Drawable::DrawCallback {
    NoteWhatIsDrawn(std::set<std::string>& names, std::string own) : drawn(names), name(std::move(own)) {}
    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override {
        drawn.insert(name);
        drawable->drawImplementation(info);
    }
    std::set<std::string>& drawn;
    std::string name;
};

struct NoteEveryObject : osg::NodeVisitor {
    explicit NoteEveryObject(std::set<std::string>& names) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), drawn(names) {}
    void apply(osg::Geometry& geometry) override {
        // A display list would be compiled in the first frame, and not call the function again.
        geometry.setUseDisplayList(false);
        geometry.setUseVertexBufferObjects(true);
        // The OBJ reader names the group around what it read, and not the geometry itself.
        const std::string& own = geometry.getName();
        geometry.setDrawCallback(new NoteWhatIsDrawn(drawn, own.empty() && geometry.getNumParents() > 0 ? geometry.getParent(0)->getName() : own));
        ++objects;
    }
    std::set<std::string>& drawn;
    size_t objects = 0;
};

osg::Vec3d vec(const nlohmann::json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }

}  // namespace

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fprintf(stderr, "usage: openscenegraph_drawn SCENE.obj PATH.json WIDTH HEIGHT none|frustum|frustum+small\n");
        return 2;
    }
    const std::string mode = argv[5];
    const int width = std::stoi(argv[3]), height = std::stoi(argv[4]);
    osg::ref_ptr<osgDB::Options> asInTheFile = new osgDB::Options("noRotation");
    osg::ref_ptr<osg::Node> scene = osgDB::readRefNodeFile(argv[1], asInTheFile);
    if (!scene) return 3;
    std::set<std::string> drawn;
    NoteEveryObject note(drawn);
    scene->accept(note);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(scene);
    osgUtil::Optimizer().optimize(root, osgUtil::Optimizer::SPATIALIZE_GROUPS);

    nlohmann::json path;
    std::ifstream(argv[2]) >> path;
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->readDISPLAY();
    traits->width = width;
    traits->height = height;
    traits->pbuffer = true;
    traits->doubleBuffer = false;
    osg::ref_ptr<osg::GraphicsContext> context = osg::GraphicsContext::createGraphicsContext(traits);
    if (!context) return 4;
    osg::Camera* camera = viewer.getCamera();
    camera->setGraphicsContext(context);
    camera->setViewport(0, 0, width, height);
    camera->setDrawBuffer(GL_FRONT);
    camera->setReadBuffer(GL_FRONT);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionMatrixAsPerspective(path["fovy_deg"], double(width) / height, path["near"], path["far"]);
    camera->setCullingMode(mode == "none"      ? osg::CullSettings::NO_CULLING
                           : mode == "frustum" ? osg::CullSettings::VIEW_FRUSTUM_CULLING
                                               : osg::CullSettings::VIEW_FRUSTUM_CULLING | osg::CullSettings::SMALL_FEATURE_CULLING);
    camera->setSmallFeatureCullingPixelSize(14);
    viewer.setSceneData(root);
    viewer.realize();

    nlohmann::ordered_json result{{"program", "OpenSceneGraph " + std::string(osgGetVersion())},
                                  {"mode", mode},
                                  {"fovy_deg", path["fovy_deg"]},
                                  {"near", path["near"]},
                                  {"far", path["far"]},
                                  {"poses", nlohmann::ordered_json::array()}};
    for (const auto& pose : path["poses"]) {
        camera->setViewMatrixAsLookAt(vec(pose["eye"]), vec(pose["target"]), vec(pose["up"]));
        viewer.frame();
        drawn.clear();
        viewer.frame();
        result["poses"].push_back({{"eye", pose["eye"]}, {"target", pose["target"]}, {"up", pose["up"]}, {"objects", drawn}});
    }
    std::fprintf(stderr, "%zu objects read\n", note.objects);
    std::printf("%s\n", result.dump().c_str());
}
