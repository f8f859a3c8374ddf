#include "tests/rules/source_rules.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <set>

#include "tests/rules/text_files.h"

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

std::optional<size_t> levelIn(const std::vector<std::string>& order, std::string_view folder) {
    const auto found = std::find(order.begin(), order.end(), folder);
    if (found == order.end()) return std::nullopt;
    return static_cast<size_t>(found - order.begin());
}

std::optional<size_t> levelOf(std::string_view layer) { return levelIn(layers(), layer); }

/// "core/mesh/load.h" → "core", "mesh", "load.h".
std::vector<std::string> partsOf(const fs::path& path) {
    std::vector<std::string> parts;
    for (const fs::path& part : path) parts.push_back(part.string());
    return parts;
}

/// "mesh" for "core/mesh/load.h"; empty for a file outside core and for one in core itself.
std::string layerOf(const fs::path& path) {
    const std::vector<std::string> parts = partsOf(path);
    return parts.size() > 2 && parts[0] == "core" ? parts[1] : std::string();
}

bool isCullbench(const fs::path& file) { return *file.begin() == "app" && file.string().find("cullbench") != std::string::npos; }

/// The error in a quoted or angle-bracket include by a file of core; empty where there is none.
std::string wrongInCore(const Include& include) {
    const std::vector<std::string> target = partsOf(include.name);
    if (!include.quoted) return target[0] == "core" ? "names a header of the project in angle brackets" : "";
    if (target[0] == "ui" || target[0] == "app" || target[0] == "tests")
        return "core includes " + target[0] + ": " + include.name;
    if (target[0] == "embedded") return "";  // made by the build (packaging/cmake/EmbedText.cmake)
    if (target[0] != "core") return "is not named from the root of the tree: " + include.name;
    const std::string layer = layerOf(include.file);
    const std::string targetLayer = layerOf(include.name);
    if (targetLayer.empty()) return "";
    if (layer.empty()) return "a header of all layers includes one layer's: " + include.name;
    const std::optional<size_t> level = levelOf(layer);
    const std::optional<size_t> targetLevel = levelOf(targetLayer);
    if (!targetLevel) return "names no layer: " + include.name;
    if (level && *targetLevel > *level)
        return "layer " + layer + " includes the higher layer " + targetLayer + ": " + include.name;
    return "";
}

/// "views" for "ui/views/view_pane.h"; empty for a file outside ui and for one in ui itself.
std::string uiFolderOf(const fs::path& path) {
    const std::vector<std::string> parts = partsOf(path);
    return parts.size() > 2 && parts[0] == "ui" ? parts[1] : std::string();
}

std::string wrongInUi(const Include& include) {
    const std::string top = partsOf(include.name)[0];
    if (top == "app" || top == "tests") return "ui includes " + top + ": " + include.name;
    const bool generated = fs::path(include.name).extension() == ".moc" || include.name.starts_with("ui_");
    if (include.quoted && top != "core" && top != "ui" && !generated)
        return "is not named from the root of the tree: " + include.name;
    const std::optional<size_t> level = levelIn(uiFolders(), uiFolderOf(include.file));
    const std::optional<size_t> targetLevel = levelIn(uiFolders(), uiFolderOf(include.name));
    if (level && targetLevel && *targetLevel > *level)
        return "ui/" + uiFolderOf(include.file) + " includes the higher folder " + uiFolderOf(include.name) + ": " + include.name;
    return "";
}

/// "spherical" for "core/visibility/spherical/decision.h"; empty for what belongs to no family.
std::string familyOf(const fs::path& path) {
    const std::vector<std::string> parts = partsOf(path);
    return parts.size() > 3 && parts[0] == "core" && parts[1] == "visibility" ? parts[2] : std::string();
}

/// Whether a file may include the headers of every family: the registry, and experiments, which compare the methods.
bool knowsFamilies(const fs::path& file) {
    return file.generic_string() == "core/visibility/registry.cpp" || layerOf(file) == "experiments";
}

/// The sources of core, ui and app.
std::vector<fs::path> sourcesOf(const fs::path& root) {
    std::vector<fs::path> files;
    for (const char* folder : {"core", "ui", "app"})
        for (const fs::path& file : filesBelow(root / folder, {".h", ".cpp"})) files.push_back(file);
    return files;
}

/// Lines outside a family that name something in its namespace.
std::vector<Offence> namesOfFamilies(const fs::path& root) {
    std::set<std::string> families;
    for (const fs::path& file : filesBelow(root / "core" / "visibility", {".h", ".cpp"}))
        if (const std::string family = familyOf(fs::relative(file, root)); !family.empty()) families.insert(family);
    static const std::regex kScope(R"(\b(\w+)::)");
    std::vector<Offence> offences;
    for (const fs::path& file : sourcesOf(root)) {
        const fs::path relative = fs::relative(file, root);
        if (knowsFamilies(relative)) continue;
        for (const Line& line : linesOf(file))
            for (const std::string& scope : matches(line.text.substr(0, line.text.find("//")), kScope))
                if (families.contains(scope) && scope != familyOf(relative))
                    offences.push_back({relative, line.number, "names the family " + scope});
    }
    return offences;
}

std::string wrongInApp(const Include& include) {
    if (isCullbench(include.file) && partsOf(include.name)[0] == "ui") return "cullbench includes ui: " + include.name;
    return "";
}

/// The text of a CMake line without its comment.
std::string withoutComment(const std::string& text) { return text.substr(0, text.find('#')); }

/// The errors in a line of a CMakeLists.txt in core or ui.
std::vector<std::string> wrongLinks(const fs::path& file, const std::string& text) {
    static const std::regex kOwnTarget(R"(\bcullscope(?:::|_)(\w+))");
    static const std::regex kQt(R"(\b(Qt6?::\w+))");
    static const std::regex kOpenGl(R"(\b(PkgConfig::epoxy|OpenGL::\w+|EGL::\w+))");
    static const std::regex kOpenMesh(R"(\b(OpenMesh(?:Core|Tools)\w*))");
    const bool inCore = *file.begin() == "core";
    const std::string layer = layerOf(file);
    std::vector<std::string> wrong;
    for (const std::string& target : matches(text, kOwnTarget)) {
        if (inCore && (target == "ui" || target == "app")) wrong.push_back("core links " + target);
        const std::optional<size_t> level = levelOf(layer);
        const std::optional<size_t> targetLevel = levelOf(target);
        if (level && targetLevel && *targetLevel > *level)
            wrong.push_back("layer " + layer + " links the higher layer " + target);
        if (!inCore && target == "app") wrong.push_back("ui links app");
    }
    if (inCore) {
        for (const std::string& library : matches(text, kQt)) wrong.push_back("core links Qt: " + library);
    }
    if (layer != "gpu") {
        for (const std::string& library : matches(text, kOpenGl))
            wrong.push_back("OpenGL is linked outside core/gpu: " + library);
    }
    if (layer != "mesh") {
        for (const std::string& library : matches(text, kOpenMesh))
            wrong.push_back("OpenMesh is linked outside core/mesh: " + library);
    }
    return wrong;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Offence& offence) {
    out << offence.file.generic_string();
    if (offence.line > 0) out << ':' << offence.line;
    return out << ": " << offence.what;
}

const std::vector<std::string>& layers() {
    static const std::vector<std::string> kLayers = {"base",   "geometry", "mesh",       "scene", "frame",   "spatial",
                                                     "raster", "gpu",      "visibility", "image", "measure", "experiments"};
    return kLayers;
}

const std::vector<std::string>& uiFolders() {
    static const std::vector<std::string> kFolders = {"text",    "look",        "jobs",   "models", "session",
                                                      "views",   "screenshots", "plots",  "panels", "statistics",
                                                      "dialogs", "window",      "startup"};
    return kFolders;
}

std::vector<Include> includesBelow(const fs::path& root, const std::vector<std::string>& folders) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> includes;
    for (const std::string& folder : folders) {
        for (const fs::path& file : filesBelow(root / folder, {".h", ".cpp"})) {
            for (const Line& line : linesOf(file)) {
                std::smatch match;
                if (!std::regex_search(line.text, match, kInclude)) continue;
                includes.push_back({fs::relative(file, root), line.number, match[2], match[1] == "\""});
            }
        }
    }
    return includes;
}

std::vector<Offence> layeringOffences(const fs::path& root) {
    std::vector<Offence> offences;
    for (const Include& include : includesBelow(root, {"core", "ui", "app"})) {
        const std::string top = include.file.begin()->string();
        const std::string what = top == "core" ? wrongInCore(include) : top == "ui" ? wrongInUi(include) : wrongInApp(include);
        if (!what.empty()) offences.push_back({include.file, include.line, what});
    }
    for (const auto& [top, order] : {std::pair("core", &layers()), std::pair("ui", &uiFolders())}) {
        for (const fs::directory_entry& entry : fs::directory_iterator(root / top)) {
            const std::string name = entry.path().filename().string();
            if (entry.is_directory() && !levelIn(*order, name))
                offences.push_back(
                    {fs::path(top) / name, 0, std::string("is a folder of ") + top + " that has no place in its order"});
        }
    }
    return offences;
}

std::vector<Offence> familyOffences(const fs::path& root) {
    std::vector<Offence> offences;
    for (const Include& include : includesBelow(root, {"core", "ui", "app"})) {
        const std::string family = familyOf(include.name);
        if (family.empty() || family == familyOf(include.file) || knowsFamilies(include.file)) continue;
        offences.push_back({include.file, include.line, "knows the family " + family + ": " + include.name});
    }
    for (const Offence& offence : namesOfFamilies(root)) offences.push_back(offence);
    for (const fs::path& file : filesBelow(root / "core" / "visibility", {".h", ".cpp"})) {
        const fs::path relative = fs::relative(file, root);
        const std::string family = familyOf(relative);
        if (family.empty()) continue;
        const std::vector<Line> lines = linesOf(file);
        const bool opens = std::any_of(lines.begin(), lines.end(),
                                       [&](const Line& line) { return line.text == "namespace cullscope::" + family + " {"; });
        if (!opens) offences.push_back({relative, 0, "has not the namespace of its family: cullscope::" + family});
    }
    return offences;
}

std::vector<Offence> strategyIdOffences(const fs::path& root, const std::vector<std::string>& ids) {
    static const std::regex kLiteral(R"re((tr\(|translate\()?"([^"\\]*)")re");
    // Words of other things: a keyword of OBJ files, the extension of levels, and pieces into which a generator splits a mesh.
    static const std::set<std::pair<std::string, std::string>> kOthers{{"mesh", "bsp"}, {"scene", "bsp"}, {"scene", "clusters"}};
    std::vector<Offence> offences;
    for (const fs::path& file : sourcesOf(root)) {
        const fs::path relative = fs::relative(file, root);
        if (knowsFamilies(relative) || layerOf(relative) == "visibility") continue;
        for (const Line& line : linesOf(file)) {
            const std::string code = line.text.substr(0, line.text.find("//"));
            for (std::sregex_iterator match(code.begin(), code.end(), kLiteral), end; match != end; ++match)
                if (!(*match)[1].matched && std::find(ids.begin(), ids.end(), (*match)[2]) != ids.end() &&
                    !kOthers.contains({layerOf(relative), (*match)[2].str()}))
                    offences.push_back({relative, line.number, "names the strategy " + (*match)[2].str()});
        }
    }
    return offences;
}

std::vector<Offence> showWordOffences(const fs::path& root, const std::vector<std::string>& words) {
    static const std::regex kLiteral(R"re("(([^"\\]|\\.)*)")re");
    const auto lower = [](std::string text) {
        std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
        return text;
    };
    std::vector<Offence> offences;
    for (const fs::path& file : sourcesOf(root)) {
        const fs::path relative = fs::relative(file, root);
        if (const fs::path top = *relative.begin(); (top != "app" && top != "ui") || knowsFamilies(relative)) continue;
        for (const Line& line : linesOf(file)) {
            if (line.text.starts_with("#include")) continue;
            for (std::sregex_iterator match(line.text.begin(), line.text.end(), kLiteral), end; match != end; ++match)
                for (const std::string& word : words)
                    if (lower((*match)[1].str()).find(lower(word)) != std::string::npos)
                        offences.push_back({relative, line.number, "names what a strategy shows: " + word});
        }
    }
    return offences;
}

std::vector<Offence> meteringOffences(const fs::path& root) {
    std::vector<Offence> offences;
    for (const Include& include : includesBelow(root, {"core", "ui", "app", "tests/benchmark"}))
        if (include.name == "core/measure/render_frame.h" && layerOf(include.file) != "measure")
            offences.push_back({include.file, include.line, "times frames outside core/measure: " + include.name});
    return offences;
}

std::vector<Offence> libraryOffences(const fs::path& root) {
    static const std::regex kQt(R"(^(Qt[A-Z]\w*(/.*)?|Q[A-Z]\w*|q[a-z0-9]+\.h)$)");
    static const std::regex kOpenGl(
        R"(^((epoxy|GL|GLES\d?|EGL|KHR)/.*|(QtOpenGL/)?QOpenGL(ExtraFunctions|Functions.*|Buffer|Texture|Shader.*|Framebuffer.*|VertexArray.*))$)");
    static const std::regex kOpenMesh(R"(^OpenMesh/)");
    std::vector<Offence> offences;
    for (const Include& include : includesBelow(root, {"core", "ui", "app"})) {
        const auto report = [&](const std::string& what) {
            offences.push_back({include.file, include.line, what + include.name});
        };
        const bool withoutQt = *include.file.begin() == "core" || isCullbench(include.file);
        const std::string layer = layerOf(include.file);
        if (withoutQt && std::regex_search(include.name, kQt)) report("uses Qt: ");
        if (layer != "gpu" && std::regex_search(include.name, kOpenGl)) report("uses OpenGL outside core/gpu: ");
        if (layer != "mesh" && std::regex_search(include.name, kOpenMesh)) report("uses OpenMesh outside core/mesh: ");
    }
    return offences;
}

std::vector<Offence> linkOffences(const fs::path& root) {
    std::vector<Offence> offences;
    for (const char* folder : {"core", "ui"}) {
        for (const fs::path& file : filesBelow(root / folder, {"CMakeLists.txt", ".cmake"})) {
            const fs::path relative = fs::relative(file, root);
            for (const Line& line : linesOf(file)) {
                for (const std::string& what : wrongLinks(relative, withoutComment(line.text)))
                    offences.push_back({relative, line.number, what});
            }
        }
    }
    return offences;
}

std::vector<Offence> topLevelOffences(const fs::path& root) {
    static const std::set<std::string> kPlaces = {"CMakeLists.txt",
                                                  "CMakePresets.json",
                                                  "README.md",
                                                  "LICENSE",
                                                  "CHANGELOG.md",
                                                  "CONTRIBUTING.md",
                                                  "app",
                                                  "core",
                                                  "docs",
                                                  "ui",
                                                  "resources",
                                                  "tests",
                                                  "packaging"};
    std::vector<Offence> offences;
    for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (kPlaces.contains(name) || name.starts_with(".")) continue;
        // Files that a build or an editor leaves there do not belong to the project.
        if (name.starts_with("build") || name == "compile_commands.json" || name == "CMakeUserPresets.json") continue;
        offences.push_back({name, 0, "has no place at the top of the tree"});
    }
    return offences;
}

}  // namespace cullscope::rules
