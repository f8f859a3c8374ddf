#include <fmt/format.h>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/json.h"
#include "core/experiments/experiment_list.h"
#include "core/scene/gallery/gallery.h"
#include "core/scene/gltf/gltf_scene.h"
#include "core/scene/ifc/ifc_scene.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/quake/quake_scene.h"
#include "core/scene/rvm/rvm_scene.h"

namespace cullscope::cullbench {
namespace {

struct ListOptions {
    std::string what;
    bool json = false;
};

const char* typeName(ParameterType type) {
    switch (type) {
        case ParameterType::Boolean:
            return "boolean";
        case ParameterType::Integer:
            return "integer";
        case ParameterType::Real:
            return "real";
        case ParameterType::File:
            return "file";
        case ParameterType::Choice:
            break;
    }
    return "choice";
}

const char* glRequirementId(GlRequirement glRequirement) {
    switch (glRequirement) {
        case GlRequirement::None:
            return "nothing";
        case GlRequirement::Context:
            return "opengl";
        case GlRequirement::CompatibilityProfile:
            break;
    }
    return "compatibility-profile";
}

Json parameterJson(const ParameterDeclaration& parameter) {
    Json json{{"key", parameter.key}, {"type", typeName(parameter.type)}};
    std::visit([&](const auto& value) { json["default"] = value; }, parameter.defaultValue);
    if (parameter.type == ParameterType::Integer || parameter.type == ParameterType::Real) {
        json["minimum"] = parameter.minimum;
        json["maximum"] = parameter.maximum;
        json["unit"] = parameter.unit;
    }
    if (parameter.type == ParameterType::Choice)
        for (const auto& choice : parameter.choices)
            json["choices"].push_back({{"id", choice.id}, {"description", choice.description}});
    json["description"] = parameter.description;
    return json;
}

Json strategiesJson() {
    Json list = Json::array();
    for (const RegisteredStrategy& strategy : strategies()) {
        Json parameters = Json::array();
        for (const ParameterDeclaration& parameter : strategy.info.parameters) parameters.push_back(parameterJson(parameter));
        list.push_back({{"id", strategy.info.id},
                        {"name", strategy.info.name},
                        {"description", strategy.info.description},
                        {"source", strategy.info.source},
                        {"asks", glRequirementId(strategy.info.glRequirement)},
                        {"parameters", parameters}});
    }
    return list;
}

/// The generators, and behind them the gallery.
std::vector<GeneratorInfo> listedScenes() {
    std::vector<GeneratorInfo> infos = sceneGenerators();
    infos.insert(infos.end(), galleryInfos().begin(), galleryInfos().end());
    return infos;
}

Json scenesJson() {
    Json list = Json::array();
    for (const GeneratorInfo& generator : listedScenes()) {
        Json parameters = Json::array();
        for (const GeneratorParameter& parameter : generator.parameters)
            parameters.push_back(
                {{"key", parameter.key}, {"default", parameter.defaultValue}, {"description", parameter.description}});
        list.push_back({{"id", generator.id}, {"description", generator.description}, {"parameters", parameters}});
    }
    return list;
}

Json experimentsJson() {
    Json list = Json::array();
    for (const Experiment& experiment : knownExperiments())
        list.push_back({{"id", experiment.id}, {"title", experiment.title}, {"source", experiment.source}});
    return list;
}

void printStrategies() {
    say("Strategies (-s ID, -p key=value)\n");
    for (const RegisteredStrategy& strategy : strategies()) {
        say("  {:<12} {}\n", strategy.info.id, strategy.info.description);
        if (strategy.info.glRequirement == GlRequirement::Context) say("    needs OpenGL to decide\n");
        if (strategy.info.glRequirement == GlRequirement::CompatibilityProfile)
            say("    needs OpenGL's compatibility profile to decide\n");
        for (const ParameterDeclaration& parameter : strategy.info.parameters) {
            std::string range;
            for (const auto& choice : parameter.choices) range += (range.empty() ? "" : " | ") + choice.id;
            if (parameter.type == ParameterType::Boolean) range = "true | false";
            if (parameter.type == ParameterType::File) range = "file";
            if (range.empty()) range = fmt::format("{} … {} {}", parameter.minimum, parameter.maximum, parameter.unit);
            say("    {} = {} (default {}): {}\n", parameter.key, range, toText(parameter.defaultValue), parameter.description);
        }
    }
}

void printScenes() {
    say("Scenes: a mesh file (");
    for (const std::string& extension : readableMeshExtensions())
        say("{}{}", &extension == &readableMeshExtensions().front() ? "" : ", ", extension);
    say("), polygons (.{}), a plant (.{}), a level (.{}), glTF (.{}, .{}), a building (.{}), each also compressed (.gz, .xz), or "
        "a "
        "generator\n",
        kPolygonExtension, kRvmExtension, kQuakeExtension, kGltfExtensions[0], kGltfExtensions[1], kIfcExtension);
    for (const GeneratorInfo& generator : listedScenes()) {
        say("  {:<12} {}\n", generator.id, generator.description);
        for (const GeneratorParameter& parameter : generator.parameters)
            say("    {} (default {}): {}\n", parameter.key, parameter.defaultValue.empty() ? "none" : parameter.defaultValue,
                parameter.description);
    }
    say("Camera paths (--path): a JSON file or\n");
    for (const BuiltInPath& path : builtInPaths()) say("  {:<12} {}\n", path.id, path.description);
}

void printExperiments() {
    say("Experiments (cullbench reproduce ID)\n");
    for (const Experiment& experiment : knownExperiments())
        say("  {:<12} {}. {}\n", experiment.id, experiment.title, experiment.source);
}

void run(const ListOptions& options) {
    const bool everything = options.what.empty();
    if (options.json) {
        Json json;
        if (everything || options.what == "scenes") json["scenes"] = scenesJson();
        if (everything || options.what == "strategies") json["strategies"] = strategiesJson();
        if (everything || options.what == "experiments") json["experiments"] = experimentsJson();
        printText(stdout, json.dump(1) + "\n");
        return;
    }
    if (everything || options.what == "strategies") printStrategies();
    if (everything || options.what == "scenes") printScenes();
    if (everything || options.what == "experiments") printExperiments();
}

}  // namespace

void addListCommand(CLI::App& app, Context& /*context*/) {
    CLI::App* command = app.add_subcommand("list", "What there is: scenes, strategies with their parameters, experiments");
    auto options = std::make_shared<ListOptions>();
    command->add_option("what", options->what, "scenes, strategies or experiments")
        ->check(CLI::IsMember({"scenes", "strategies", "experiments"}));
    command->add_flag("--json", options->json, "as JSON");
    command->callback([options] { run(*options); });
}

}  // namespace cullscope::cullbench
