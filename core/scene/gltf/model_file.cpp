#include "core/scene/gltf/model_file.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/error.h"
#include "core/base/terminal_text.h"
#include "core/mesh/byte_source.h"
#include "core/scene/gltf/tiny_gltf.h"

namespace cullscope::gltf {
namespace {

namespace fs = std::filesystem;

/// The files that a model names.
class Folder {
public:
    Folder(const fs::path& model, std::string name, const RequireMemory& requireMemory, uint64_t memoryLimit,
           const Progress& progress)
        : m_folder(model.parent_path().empty() ? fs::path(".") : model.parent_path()),
          m_name(std::move(name)),
          m_requireMemory(requireMemory),
          m_memoryLimit(memoryLimit),
          m_progress(progress) {}

    /// Throws where the file is not in the folder or below, symbolic links followed.
    [[nodiscard]] fs::path placeOf(const std::string& uri) const {
        const fs::path relative = fs::u8path(uri);
        const bool leaves = relative.is_absolute() || uri.find_first_of(":\\") != std::string::npos ||
                            std::ranges::find(relative, fs::path("..")) != relative.end();
        std::error_code error;
        const fs::path inside = fs::canonical(m_folder, error);
        const fs::path place = leaves || error ? fs::path() : fs::weakly_canonical(inside / relative, error);
        const bool below = std::mismatch(inside.begin(), inside.end(), place.begin(), place.end()).first == inside.end();
        if (leaves || error || !below)
            throwInput(
                CULLSCOPE_TR("%1 takes a buffer from \"%2\", which is not in its own folder or below. Put the buffers beside "
                             "it, or export it as one file (.glb)."),
                {m_name, terminalLine(uri)});
        return m_folder / relative;
    }

    [[nodiscard]] std::vector<unsigned char> contentOf(const std::string& uri) {
        const fs::path place = placeOf(uri);
        std::error_code ignored;
        if (!fs::exists(place, ignored))
            throwInput(
                CULLSCOPE_TR("%1 takes a buffer from \"%2\", which does not exist. Put the buffers beside it, or export it as "
                             "one file (.glb)."),
                {m_name, terminalLine(uri)});
        ByteSource source(place, m_progress, false, m_memoryLimit);
        m_bytes += source.size();
        m_requireMemory(2 * m_bytes);
        const std::string content = source.rest();
        return {content.begin(), content.end()};
    }

private:
    fs::path m_folder;
    std::string m_name;
    const RequireMemory& m_requireMemory;
    uint64_t m_memoryLimit;
    const Progress& m_progress;
    uint64_t m_bytes = 0;
};

Folder& folderOf(void* user) { return *static_cast<Folder*>(user); }

tinygltf::FsCallbacks callbacksFor(Folder& folder) {
    tinygltf::FsCallbacks callbacks{};
    // tinygltf looks for a file in several places, which are the same one here; that it is missing is said when it is read.
    callbacks.FileExists = [](const std::string& uri, void* user) {
        (void)folderOf(user).placeOf(uri);
        return true;
    };
    callbacks.ExpandFilePath = [](const std::string& uri, void*) { return uri; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* content, std::string*, const std::string& uri, void* user) {
        *content = folderOf(user).contentOf(uri);
        return true;
    };
    callbacks.user_data = &folder;
    return callbacks;
}

/// What the library says, as one line without a full stop.
std::string oneLine(std::string text) {
    constexpr size_t kMost = 300;
    text = terminalLine(text.substr(0, std::min(text.find('\n'), kMost)));
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text;
}

/// Extensions that a file may require: they change nothing of its surfaces, or are read.
bool isKnown(const std::string& extension) {
    constexpr std::array<std::string_view, 3> kRead{"KHR_draco_mesh_compression", "KHR_mesh_quantization",
                                                    "EXT_mesh_gpu_instancing"};
    constexpr std::array<std::string_view, 7> kOfLooks{"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
                                                       "KHR_lights_",    "EXT_lights_",  "KHR_xmp"};
    return std::ranges::find(kRead, extension) != kRead.end() ||
           std::ranges::any_of(kOfLooks, [&](std::string_view begin) { return extension.starts_with(begin); });
}

}  // namespace

ModelFile readModel(std::string content, const fs::path& path, const RequireMemory& requireMemory, uint64_t memoryLimit,
                    const Progress& progress) {
    const std::string name = path.string();
    const Container container = containerOf(content, name);
    if (content.size() > std::numeric_limits<uint32_t>::max())
        throwInput(CULLSCOPE_TR("%1 has more than 4 GB. Split the file, or put its buffers into files beside it."), {name});
    const auto firstByte = size_t(container.json.data() - content.data());
    prepareJson(content.data() + firstByte, container.json.size(), firstByte, container.binary.size(), name, requireMemory);

    Folder folder(path, name, requireMemory, memoryLimit, progress);
    tinygltf::TinyGLTF reader;
    reader.SetFsCallbacks(callbacksFor(folder));
    auto model = std::make_shared<tinygltf::Model>();
    std::string error, warning;
    bool read = false;
    try {
        const auto length = unsigned(content.size());
        read = container.isBinary ? reader.LoadBinaryFromMemory(model.get(), &error, &warning,
                                                                reinterpret_cast<const unsigned char*>(content.data()), length)
                                  : reader.LoadASCIIFromString(model.get(), &error, &warning, content.data(), length, "");
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {
        error = failure.what();
    }
    // The extensions come first: without one of them nothing else may be in its place.
    for (const std::string& extension : model->extensionsRequired)
        if (!isKnown(extension))
            throwInput(CULLSCOPE_TR("%1 requires the extension \"%2\", which is not read. Export the file without it."),
                       {name, terminalLine(extension)});
    if (!read) throwInput(CULLSCOPE_TR("%1 cannot be read as glTF 2.0: %2. Export the file again."), {name, oneLine(error)});
    ModelFile file{nullptr, 0};
    for (const tinygltf::Buffer& buffer : model->buffers) file.bytes += buffer.data.size();
    file.model = std::move(model);
    return file;
}

}  // namespace cullscope::gltf
