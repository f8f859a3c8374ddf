#include "tests/app/line_pieces.h"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "tests/app/random_lines.h"

namespace cullbench_random_lines {
namespace {

using Values = std::vector<HostileValue>;

const std::string kLong(300, 'a');
const std::string kEscapes = "\x1b]0;title\x07\x1b[2J";

std::string nested(int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "field:mesh=";
    return text + "sphere:triangles=20";
}

/// All with one set of statuses.
Values each(const std::vector<std::string>& values, const std::set<int>& statuses) {
    Values hostile;
    for (const std::string& value : values) hostile.push_back({value, statuses});
    return hostile;
}

Values joined(Values values, const Values& others) {
    values.insert(values.end(), others.begin(), others.end());
    return values;
}

/// What no option takes as a number, a name or a size.
const std::vector<std::string> kNoValues{"",
                                         " ",
                                         "nan",
                                         kLong,
                                         kEscapes,
                                         "a\nb",
                                         "%s%n%x",
                                         "-",

                                         "\xff\xfe",
                                         "\xc2\x9b"
                                         "31m"};

Values scenes() {
    const std::string in = "../../in/";
    return joined(joined(each({"",
                               " ",
                               "nonsense",
                               "-",
                               kLong,
                               kEscapes,
                               "a\nb",
                               "%s%n",
                               ":triangles=5",
                               "sphere:triangles=",
                               "sphere:triangles=nan",
                               "sphere:triangles=inf",
                               "sphere:triangles=-1",
                               "sphere:triangles=0",
                               "sphere:triangles=1.5",
                               "sphere:triangles=1e308",
                               "sphere:triangles=2e9",
                               "sphere:triangles=0x10",
                               "sphere:trangles=5",
                               "sphere:triangles=80,triangles=80",
                               "sphere:,,",
                               "teapot:triangles=1",
                               "star:seed=-1",
                               "layers:count=0",
                               "layers:triangles=1e9",
                               "plant:pipelines=1e9",
                               "plant:pipelines=nan",
                               "field:n=2001",
                               "field:mesh=nonsense,n=2",
                               "field:mesh=,n=2",
                               "field:mesh=sphere:triangles=20,spacing=nan",
                               "mesh:",
                               "split:mesh=quiz,by=x",
                               "split:mesh=quiz,triangles=5",
                               nested(65),
                               nested(2000)},
                              {2}),
                         each({".",
                               "..",
                               "/",
                               in,
                               in + "absent.obj",
                               in + "empty.obj",
                               in + "garbage.obj",
                               in + "truncated.ply",
                               in + "claims.ply",
                               in + "folder.obj",
                               in + "unreadable.obj",
                               in + "loop.obj",
                               in + "dangling.obj",
                               in + "fifo.obj",
                               in + "tiny.obj",
                               in + "utf16.obj",
                               in + "escapes.ply",
                               in + "packed.gz",
                               in + "good.obj/x.obj",
                               "/dev/null",
                               "/dev/zero",
                               "/dev/full",
                               "none/\x1b[31m.obj",
                               "./" + kLong + ".obj",
                               "field:mesh=../../in/absent.obj,n=2",
                               "split:mesh=../../in/empty.obj",
                               "mesh:../../in/folder.obj,triangles=9"},
                              {3})),
                  each({"sphere:", "field:mesh=sphere:triangles=20,n=1,spacing=0", nested(3) + ",n=1,n=1,n=1"}, {0}));
}

Values strategies() {
    return joined(each(kNoValues, {2}),
                  each({"nonsense", "all,,frustum", ",all", "all,", "frustum:box=cube", "frustum:bux=1", "frustum:box",
                        "frustum:", "frustum:box=", "frustum:box=length,box=length", "all:x=1", "spherical:rows=-1",
                        "spherical:rows=1e9", "spherical:rows=nan", "spherical:rows=45.5", "level=4", "Frustum"},
                       {2}));
}

Values paths() {
    const std::string in = "../../in/";
    return joined(
        joined(each(kNoValues, {2}),
               each({"orbit:", "orbit:0", "orbit:-1", "orbit:nan", "orbit:1e9", "orbit:1.5", "nonsense:3", "case-9", "orbit:1,2"},
                    {2})),
        each({in + "absent.json", in + "empty.json", in + "garbage.json", in + "nan.json", in + "deep.json", in + "folder.obj",
              in + "unreadable.obj", in + "loop.obj", in + "noposes.json", "/dev/null", "./" + kLong},
             {3}));
}

/// Of an option that takes a number above 0 or within limits.
Values numbers() {
    return joined(each(kNoValues, {2}), joined(each({"inf", "-inf", "-1", "0", "1e999", "1x", "0x10", "1,5", "+1"}, {2}),
                                               each({"1e308", "1e-320", "179.5"}, {0, 2})));
}

Values outputs(const std::string& ending) {
    return each({".", "..", "/", "", "../../in", "../../in/folder.obj", "absent/out" + ending, kLong + ending,
                 "../../in/good.obj/out" + ending, "/proc/none" + ending, "none/" + kEscapes + ending},
                {2});
}

const std::map<std::string, Values>& byOption() {
    static const std::map<std::string, Values> kValues{
        {"-s", strategies()},
        {"-p", joined(each(kNoValues, {2}), each({"=", "x", "x=", "=x", "x=1", "A.x=1", "..=", "all.x=1"}, {2}))},
        {"--vary",
         joined(each(kNoValues, {2}), each({"rows", "rows=", "rows=,", "rows=45,45", "rows=-1", "rows=nan", "x=1"}, {2}))},
        {"--path", paths()},
        {"--pose", joined(each(kNoValues, {2}), each({"-1", "1.5", "1e999", "99", "99999999999999999999"}, {2}))},
        {"--repeat", joined(each(kNoValues, {2}), each({"0", "-1", "100001", "1.5", "99999999999999999999"}, {2}))},
        {"--windows", joined(each(kNoValues, {2}), each({"0", "2", "-1", "4.0"}, {2}))},
        {"--upload", joined(each(kNoValues, {2}), each({"VBO", "vbo,vbo"}, {2}))},
        {"--size", joined(each(kNoValues, {2}), each({"0x5", "16385x1", "axb", "16", "x", "16x", "-1x5", "1e2x5", "16x16x16",
                                                      "99999999999x5", "nanxnan", "16 x16"},
                                                     {2}))},
        {"--near", joined(each(kNoValues, {2}), each({"inf", "-1", "0", "1e999", "1x", "0x10"}, {2}))},
        {"--far", joined(each(kNoValues, {2}), each({"inf", "-1", "0", "1e999", "1x", "1e-9"}, {2}))},
        {"--fovx", numbers()},
        {"--eye", joined(each(kNoValues, {2}), each({"1,2", "1,2,nan", "inf,0,0", ",,", "1,2,3,4", "0,0,0", "1e999,0,0"}, {2}))},
        {"--target", joined(each(kNoValues, {2}), each({"1,2", "1,2,nan", "inf,0,0", ",,", "1,2,3,4", "3,1,2"}, {2}))},
        {"--overlay", joined(each(kNoValues, {2}), each({"nonsense", "Verdicts", "verdicts,boxes"}, {2}))},
        {"--step", joined(each(kNoValues, {2}), each({"-1", "1.5", "999999999", "99999999999999999999"}, {2}))},
        {"--background", joined(each(kNoValues, {2}), each({"fff", "#ffffff", "GGGGGG", "ffffff0", "-fffff"}, {2}))},
        {"--hide", joined(each(kNoValues, {2}), each({"x", "-1", "1-", "5-3", "9999", "0,,0", "99999999999999999999"}, {2}))},
        {"--json", joined(outputs(".json"), {{"/dev/full", {2}}})},
        {"--csv", joined(outputs(".csv"), {{"/dev/full", {2}}})},
        {"--models", {{"", {2}}, {"../../in", {0}}, {kLong, {0}}, {kEscapes, {0}}, {"../../in/good.obj", {0}}}}};
    return kValues;
}

}  // namespace

const std::vector<HostileValue>& hostileValues(const std::string& command, const std::string& option, size_t place) {
    static const Values kSceneValues = scenes(), kPathValues = paths();
    static const Values kPictures = joined(outputs(".png"), each({"out.gif", "out", "out.png.", "out.obj"}, {2}));
    static const Values kMeshes = joined(outputs(".obj"), each({"out.xyz", "out", "/dev/full"}, {2}));
    static const Values kPathFiles = joined(outputs(".json"), {{"/dev/full", {2}}});
    static const Values kWords = joined(each(kNoValues, {2}), each({"nonsense", "Quiz", "../../in/good.obj"}, {2}));
    if (option == "-o") return command == "render" ? kPictures : command == "export" ? kMeshes : kPathFiles;
    if (!option.empty()) return byOption().at(option);
    if (command == "list" || command == "reproduce") return kWords;
    return command == "path" && place == 0 ? kPathValues : kSceneValues;
}

bool commandTakes(const std::string& command, const std::string& option) {
    static const std::map<std::string, std::set<std::string>> kTaken{
        {"list", {}},
        {"render", {"-s", "-p", "--near", "--fovx", "--hide", "--path", "--size"}},
        {"measure", {"-s", "-p", "--fovx", "--hide", "--json", "--path", "--size"}},
        {"sweep", {"-s", "-p", "--fovx", "--hide", "--json", "--path", "--size"}},
        {"export", {"--hide"}},
        {"inspect", {"-s", "-p", "--hide", "--json"}},
        {"path", {"--fovx", "--hide"}},
        {"reproduce", {"--json"}}};
    const auto taken = kTaken.find(command);
    return option == "--models" || (taken != kTaken.end() && taken->second.contains(option));
}

void writeInputs(const std::filesystem::path& in) {
    namespace fs = std::filesystem;
    fs::create_directories(in / "folder.obj");
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(in / name, std::ios::binary) << text;
    };
    const std::string mesh = "o a\x1b[31m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    for (const char* name : {"good.obj", "a=b,c=d.obj", "\xEA\xB8\xB0.obj", "esc\x1b]0;t\x07.obj"}) write(name, mesh);
    write("good.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("good.stl",
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
    write("path.json",
          R"({"fovy_deg": 45, "near": 0.05, "far": 100, "poses": [{"eye": [0,0,4], "target": [0,0,0], "up": [0,1,0]}]})");
    write("empty.obj", "");
    write("garbage.obj", std::string("\x7f"
                                     "ELF\0\1\2\3",
                                     8) +
                             kEscapes + std::string(200, '\xfe'));
    write("truncated.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n");
    write("claims.ply",
          "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
          "property float z\nelement face 4000000000\nproperty list uchar int vertex_indices\nend_header\n");
    write("tiny.obj", "o " + kEscapes + "\nv 0 0 0\nv 1e-31 0 0\nv 0 1e-31 0\nf 1 2 3\n");
    write("utf16.obj", std::string("\xff\xfe"
                                   "v\0 \0",
                                   6));
    write("escapes.ply",
          "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nelement " + kEscapes + " 2\n");
    write("packed.gz", "\x1f\x8b\x08");
    write("empty.json", "");
    write("garbage.json", kEscapes);
    write("nan.json", R"({"fovy_deg": NaN, "poses": [{"eye": [0,0,1e999]}]})");
    write("deep.json", std::string(100'000, '['));
    write("noposes.json", R"({"fovy_deg": 45, "near": 0.05, "far": 100, "poses": []})");
    // Reading what has no memory at its beginning fails for every user.
    fs::create_symlink("/proc/self/mem", in / "unreadable.obj");
    fs::create_symlink("loop.obj", in / "loop.obj");
    fs::create_symlink("nowhere", in / "dangling.obj");
    static_cast<void>(mkfifo((in / "fifo.obj").c_str(), 0600));
}

}  // namespace cullbench_random_lines
