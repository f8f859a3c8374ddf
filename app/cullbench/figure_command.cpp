#include <algorithm>
#include <filesystem>

#include "app/cullbench/commands.h"
#include "app/cullbench/language.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/han_hong_figure_data.h"
#include "core/experiments/han_hong_figures.h"
#include "core/experiments/han_hong_rows.h"
#include "core/gpu/context.h"
#include "core/image/drawing_svg.h"
#include "core/image/picture_metadata.h"

namespace cullscope::cullbench {
namespace {

struct FigureOptions {
    int number = 0;
    SceneChoice scene;
    std::vector<std::string> parameters;
    std::string output, json, csv;
    std::string language = "en";
    int width = han_hong::kFigurePixels;
    int64_t pose = 0;
    std::optional<int> onlyCase;
    std::optional<int64_t> step;
};

bool isSvg(const std::string& path) { return std::filesystem::path(path).extension() == ".svg"; }

void checkFiles(const FigureOptions& options) {
    if (options.output.empty() && options.json.empty() && options.csv.empty())
        throwUsage(CULLSCOPE_TR("Nothing would be written: name a picture with -o, or a file with --json or --csv."));
    if (!options.output.empty() && !isSvg(options.output)) requirePictureFormat(options.output);
    if (std::ranges::count(std::array{options.output, options.json, options.csv}, std::string("-")) > 1)
        throwUsage(CULLSCOPE_TR("Only one of the files can go to standard output: name the others."));
    checkOutputPlaces({options.output, options.json, options.csv});
}

void run(const FigureOptions& options, const Context& context) {
    checkFiles(options);
    const std::vector<StrategyRequest> strategies = strategiesOf({han_hong::figureStrategy(options.number)}, options.parameters);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const HeadlessContext gl;
    const double scale = options.width / han_hong::kFigureWidth;
    // Letters are needed where the picture is no SVG; where none are installed, an SVG is laid out without them.
    std::optional<Letters> letters;
    if (!options.output.empty() && !isSvg(options.output)) letters.emplace(scale * kPlotLetters);
    PageLook look;
    look.style = letters ? pageStyle(*letters, scale) : svgStyle();
    look.say = [catalogue = Catalogue(options.language)](const Words& words) { return catalogue.say(words); };
    han_hong::FigureRequest request = han_hong::figureRequest(options.number, opened.scene);
    request.strategy = strategies.front();
    request.pose = size_t(options.pose);
    request.onlyCase = options.onlyCase;
    if (options.step) request.step = size_t(*options.step);
    request.scale = scale;
    han_hong::Figure figure = han_hong::figure(request, look, terminalProgress(context));
    clearProgress();
    figure.data.scene = options.scene.specification;
    figure.data.gl = gl.info();
    if (!options.output.empty() && letters) {
        Picture picture = pagePicture(figure.page, *letters);
        picture.metadata = programMetadata(gl.info().renderer);
        picture.metadata.emplace_back("cullscope:figure", figure.data.source);
        picture.metadata.emplace_back("cullscope:scene", options.scene.specification);
        writePicture(options.output, picture);
    } else if (!options.output.empty()) {
        writeText(options.output, pageSvg(figure.page));
    }
    if (!options.json.empty()) writeText(options.json, tablesJson({figure.data}));
    if (!options.csv.empty()) writeText(options.csv, rowsCsv(figure.data));
    std::FILE* words = options.output == "-" || options.json == "-" || options.csv == "-" ? stderr : stdout;
    say(words, "{}: {}; {} on {}\n", figure.data.source, han_hong::figureTitle(options.number), gl.info().renderer,
        gl.platform());
    for (const std::string& sentence : han_hong::figureSentences(figure.data)) say(words, "{}\n", sentence);
}

}  // namespace

void addFigureCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("figure", "Draws a figure of Han & Hong 2008, with ticks, axes and a legend");
    auto options = std::make_shared<FigureOptions>();
    options->scene.specification = han_hong::kBunny;
    command->add_option("FIGURE", options->number, "1 to 8")->required()->check(CLI::Range(1, han_hong::kFigures));
    command->add_option("SCENE", options->scene.specification, "a scene of yours in place of the paper's bunny")
        ->capture_default_str();
    command
        ->add_option("-p,--parameter", options->parameters,
                     std::string("parameter of ") + han_hong::kShownStrategy + ": key=value")
        ->allow_extra_args(false);
    command->add_option("-o,--output", options->output, "picture: .png, .jpg, .tif or .svg; - is standard output (PNG)");
    command->add_option("--json", options->json,
                        "rays and hits, region, boxes and S of the figure, of Figure 2 the map's cells; - is standard output");
    command->add_option("--csv", options->csv, "the same as CSV; - is standard output");
    command->add_option("--width", options->width, "width of the picture in pixels; letters and lines grow with it")
        ->check(CLI::Range(480, 8192))
        ->capture_default_str();
    command->add_option("--language", options->language, "of the picture's words: en, ko or zh_CN")
        ->check(CLI::IsMember({"en", "ko", "zh_CN"}))
        ->capture_default_str();
    command->add_option("--case", options->onlyCase, "of Figures 1, 3 and 4: the case that is shown")->check(CLI::Range(1, 3));
    command->add_option("--pose", options->pose, "which of the twelve views of a case, from 0")->check(countFromZero());
    command->add_option("--step", options->step, "of Figure 1: after so many of the frame's decisions")->check(countFromZero());
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
