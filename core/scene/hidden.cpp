#include "core/scene/hidden.h"

#include <algorithm>
#include <charconv>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// The text as a whole number; none where it is not one. A number that is too large becomes one above the number of objects of
/// any scene.
std::optional<size_t> wholeNumber(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() ? number : std::numeric_limits<size_t>::max();
}

void mark(std::string_view piece, std::string_view text, std::vector<bool>& hidden) {
    const size_t dash = piece.find('-');
    const std::optional<size_t> first = wholeNumber(piece.substr(0, dash));
    const std::optional<size_t> last = dash == std::string_view::npos ? first : wholeNumber(piece.substr(dash + 1));
    if (!first || !last || *last < *first)
        throwUsage(
            CULLSCOPE_TR("\"%1\" in \"%2\" is neither an object's number nor a range. Hidden objects are written as in 3,7-9."),
            {std::string(piece), std::string(text)});
    if (*last >= hidden.size())
        throwUsage(CULLSCOPE_TR("There is no object %1 to hide: the scene has %2 objects, counted from 0."),
                   {std::string(dash == std::string_view::npos ? piece : piece.substr(dash + 1)), std::to_string(hidden.size())});
    std::fill(hidden.begin() + std::ptrdiff_t(*first), hidden.begin() + std::ptrdiff_t(*last) + 1, true);
}

}  // namespace

ScenePointer withoutInstances(const ScenePointer& scene, const std::vector<bool>& hidden) {
    if (std::find(hidden.begin(), hidden.end(), true) == hidden.end()) return scene;
    std::vector<Instance> shown;
    std::vector<uint32_t> numbers;
    for (uint32_t i = 0; i < scene->instances().size(); ++i) {
        if (i < hidden.size() && hidden[i]) continue;
        shown.push_back(scene->instances()[i]);
        numbers.push_back(i);
    }
    SceneRemarks remarks = scene->remarks();
    if (remarks.visibility) remarks.visibility = std::make_shared<const RegionSets>(remarks.visibility->ofObjects(numbers));
    return std::make_shared<const Scene>(scene->name(), scene->meshes(), std::move(shown), nullptr, std::move(remarks));
}

std::vector<bool> hiddenFromText(std::string_view text, size_t objects) {
    std::vector<bool> hidden(objects, false);
    for (size_t start = 0; start < text.size();) {
        const size_t comma = std::min(text.find(',', start), text.size());
        mark(text.substr(start, comma - start), text, hidden);
        start = comma + 1;
        if (start == text.size()) mark("", text, hidden);  // a comma at the end
    }
    return hidden;
}

std::string hiddenToText(const std::vector<bool>& hidden) {
    std::string text;
    for (auto begin = hidden.begin(); (begin = std::find(begin, hidden.end(), true)) != hidden.end();) {
        const auto end = std::find(begin, hidden.end(), false);
        text += (text.empty() ? "" : ",") + std::to_string(begin - hidden.begin());
        if (end - begin > 1) text += "-" + std::to_string(end - hidden.begin() - 1);
        begin = end;
    }
    return text;
}

}  // namespace cullscope
