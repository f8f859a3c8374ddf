#include "tests/support/changed_files.h"

#include <cstdio>
#include <random>

#include "core/base/error.h"
#include "tests/support/long_mode.h"
#include "tests/support/mesh_files.h"

namespace cullscope::test {

bool everyChangeLoadsOrIsRefused(const std::string& good, const std::string& name,
                                 const std::function<ScenePointer(std::string_view bytes)>& open) {
    const auto fine = [&](std::string_view bytes) {
        try {
            const ScenePointer scene = open(bytes);
            for (size_t i = 0; i < scene->instances().size(); ++i)
                if (!(scene->instanceBox(i).min.x <= scene->instanceBox(i).max.x)) return false;
            return true;
        } catch (const Error& error) {
            return error.kind() == ErrorKind::Input && std::string(error.what()).find(name) != std::string::npos;
        }
    };
    const auto allAreFine = [&] {
        for (size_t length = 1; length < good.size(); length += longMode() ? 1 : 5) {
            if (fine(std::string_view(good).substr(0, length))) continue;
            std::fprintf(stderr, "%s cut off after %zu bytes\n", name.c_str(), length);
            return false;
        }
        std::mt19937 random(20261123);
        for (int round = 0; round < int(howMany(3000, 400)); ++round) {
            std::string bytes = good;
            for (size_t change = 1 + random() % 3; change > 0; --change) {
                const size_t at = random() % bytes.size();
                if (random() % 4 == 0)
                    bytes.erase(at, 1 + random() % 8);
                else if (random() % 3 == 0)
                    bytes[at] = "\xff\x7f\x80\x00"[random() % 4];
                else
                    bytes[at] = char(bytes[at] ^ (1 << random() % 8));
            }
            if (fine(bytes)) continue;
            std::fprintf(stderr, "%s with the changes of round %d\n", name.c_str(), round);
            return false;
        }
        return true;
    };
    constexpr unsigned kSeconds = 120;
    return succeedsInChild(allAreFine, kSeconds);
}

}  // namespace cullscope::test
