#include "core/scene/ifc/ifc_scene.h"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/base/filter_program.h"
#include "core/base/memory_limit.h"
#include "core/base/terminal_text.h"
#include "core/mesh/file_format.h"
#include "core/scene/gltf/gltf_scene.h"

namespace cullscope {
namespace ifc {
namespace {

/// Of ifc/converter/ifc_to_gltf.cpp.
constexpr const char* kConverter = "ifc_to_gltf";
constexpr int kTooLittleMemory = 2;

/// The STEP text of a file. It begins and ends with these words; a file without the second was cut off, of which Assimp shows
/// what there is. Before the first one Assimp reads nothing, no byte-order mark either.
std::string_view wholeText(std::string_view content, const std::string& name) {
    constexpr std::string_view kBegin = "ISO-10303-21;", kEnd = "END-ISO-10303-21;", kSpace = " \t\r\n\xef\xbb\xbf";
    const size_t begin = content.find_first_not_of(kSpace);
    if (begin == std::string_view::npos || content.substr(begin, kBegin.size()) != kBegin)
        throwInput(CULLSCOPE_TR("%1 is no IFC file of the kind that is read: it does not begin with \"%2\". Export it as IFC 2x3 "
                                "(.ifc, not .ifcXML or .ifcZIP)."),
                   {name, std::string(kBegin)});
    if (content.rfind(kEnd) == std::string_view::npos)
        throwInput(CULLSCOPE_TR("%1 breaks off: \"%2\" is missing at its end. Copy or export it again."),
                   {name, std::string(kEnd)});
    return content.substr(begin);
}

/// Assimp takes every schema of IFC for 2x3, of which the others differ in the arguments of the same words.
void requireSchema(std::string_view content, const std::string& name) {
    constexpr std::string_view kSchema = "IFC2X3";
    const size_t begin = content.find('\'', std::min(content.find("FILE_SCHEMA"), content.size()));
    if (begin == std::string_view::npos || content.substr(begin + 1, kSchema.size()) == kSchema) return;
    constexpr size_t kLongest = 32;
    const std::string_view rest = content.substr(begin + 1, kLongest);
    throwInput(CULLSCOPE_TR("%1 has the schema %2; only IFC 2x3 is read. Export the building so, or convert it to glTF."),
               {name, terminalLine(rest.substr(0, rest.find('\'')))});
}

/// The name of a unit of length that is defined by another one, such as the foot; empty: there is none. Assimp converts units of
/// the SI alone.
std::string unconvertedLength(std::string_view content) {
    constexpr std::string_view kUnit = "IFCCONVERSIONBASEDUNIT(";
    for (size_t at = content.find(kUnit); at != std::string_view::npos; at = content.find(kUnit, at + 1)) {
        const std::string_view line = content.substr(at, content.find(';', at) - at);
        if (line.find(".LENGTHUNIT.") == std::string_view::npos) continue;
        const size_t name = line.find('\'');
        if (name == std::string_view::npos) return "?";
        return terminalLine(line.substr(name + 1, line.find('\'', name + 1) - name - 1));
    }
    return {};
}

/// What the converter wrote to standard error.
struct Notes {
    std::string error;  ///< why the file cannot be read; empty: it can
    std::string unit;   ///< unconvertedLength
    size_t lines = 0;   ///< shapes that have no surface
    std::set<std::string> uncutOpenings;
    std::set<std::string> unknownKinds;
    size_t unknown = 0;
    std::string otherWarning;  ///< the first
    size_t otherWarnings = 0;
};

/// The word of a line after another one.
std::string wordAfter(const std::string& line, std::string_view before) {
    const size_t begin = line.find(before);
    if (begin == std::string::npos) return {};
    return line.substr(begin + before.size(), line.find(' ', begin + before.size()) - begin - before.size());
}

Notes notesOf(const std::string& errors) {
    Notes notes;
    std::istringstream text(errors);
    for (std::string line; std::getline(text, line);) {
        constexpr std::string_view kError = "error ", kLines = "lines ";
        if (line.starts_with(kError)) {
            notes.error = terminalLine(line.substr(kError.size()));
        } else if (line.starts_with(kLines)) {
            notes.lines = size_t(std::atoll(line.c_str() + kLines.size()));
        } else if (line.find("failed to resolve all openings") != std::string::npos) {
            // Told of slabs, too, of which an opening is cut through both ends.
            if (line.find("sides_with_openings 0 ") == std::string::npos) notes.uncutOpenings.insert(wordAfter(line, "ID "));
        } else if (line.find("skipping unknown") != std::string::npos) {
            ++notes.unknown;
            notes.unknownKinds.insert(terminalLine(wordAfter(line, "type is ")));
        } else if (line.find("is not parallel with face") == std::string::npos &&  // tried before another way of cutting
                   line.find("failed to determine primary site") == std::string::npos && !line.empty()) {
            // The importer's time and thread stand before its own words.
            const size_t words = line.find("IFC: ");
            if (notes.otherWarnings++ == 0)
                notes.otherWarning = terminalLine(line.substr(words == std::string::npos ? 0 : words));
        }
    }
    return notes;
}

std::string joined(const std::set<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

void remark(LoadReport& report, const Notes& notes) {
    const auto add = [&](std::string_view sentence, std::vector<std::string> values) {
        report.remarks.push_back({std::string(sentence), std::move(values)});
    };
    if (!notes.unit.empty())
        add(CULLSCOPE_TR("Lengths in %1 are taken for metres: only units of the SI are converted."), {notes.unit});
    if (notes.unknown > 0)
        add(CULLSCOPE_TR("Shapes left out of kinds that are not read: %1 (%2)."),
            {std::to_string(notes.unknown), joined(notes.unknownKinds)});
    if (notes.lines > 0)
        add(CULLSCOPE_TR("Points and lines left out, which have no surface: %1 primitives."), {std::to_string(notes.lines)});
    if (!notes.uncutOpenings.empty())
        add(CULLSCOPE_TR("Elements whose openings are not all cut, because of their shape: %1 (the first is #%2)."),
            {std::to_string(notes.uncutOpenings.size()), *notes.uncutOpenings.begin()});
    if (notes.otherWarnings > 0)
        add(CULLSCOPE_TR("Other warnings of the reader: %1 (the first: %2)."),
            {std::to_string(notes.otherWarnings), notes.otherWarning});
}

}  // namespace
}  // namespace ifc

bool isIfcFile(const std::filesystem::path& path) { return extensionOf(path) == kIfcExtension; }

FileScene readIfcFile(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    constexpr double kRead = 0.2, kConverted = 0.6;
    const std::string name = path.string();
    ifc::Notes notes;
    std::string model;
    {
        const std::string content = contentOf(path, options, progress.part(0.0, kRead));
        const std::string_view text = ifc::wholeText(content, name);
        ifc::requireSchema(text, name);
        progress.tell(kRead, CULLSCOPE_TR("Converting"));
        const uint64_t memory = options.memoryLimitBytes > 0 ? options.memoryLimitBytes : memoryToPlanWith();
        Filtered made = runFilter(ownLibraryFile(ifc::kConverter), std::array{std::to_string(memory)}, text, progress);
        notes = ifc::notesOf(made.errors);
        notes.unit = ifc::unconvertedLength(text);
        if (made.status == ifc::kTooLittleMemory)
            throwInput(CULLSCOPE_TR("%1 needs more memory than this machine gives. Simplify the mesh or split the file."),
                       {name});
        if (made.status != 0 && notes.error.empty())
            throwInput(CULLSCOPE_TR("%1 cannot be read: it makes the reader of IFC files (Assimp) crash. Export it again, or "
                                    "convert it to glTF."),
                       {name});
        if (made.status != 0)
            throwInput(
                CULLSCOPE_TR("%1 cannot be read as IFC: %2. IFC 2x3 is read; export the building so, or convert it to glTF."),
                {name, notes.error});
        model = std::move(made.output);
    }
    FileScene scene = readGltf(std::move(model), path, options, progress.part(kConverted, 1.0));
    ifc::remark(scene.report, notes);
    return scene;
}

}  // namespace cullscope
