#include "core/experiments/store/comparison.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void result_store(std::string_view input) {
    const std::filesystem::path file = fileOf(input, "results");
    // What SQLite left beside the input before.
    for (const char* left : {"results-wal", "results-shm", "results-journal"}) std::filesystem::remove(scratchFolder() / left);
    std::vector<store::Stored> all;
    // Usage: what SQLite takes for a file that may not be written.
    const bool taken = accepted({ErrorKind::Input, ErrorKind::Usage}, [&] {
        const store::ResultStore opened(file, store::Database::Access::Existing);
        for (const store::Listed& each : opened.list()) all.push_back(opened.read(each.number));
        (void)opened.reports();
    });
    if (!taken || all.empty()) return;
    (void)store::storedJson(all);
    (void)store::storedCsv(all);
    (void)accepted({ErrorKind::Usage}, [&] { (void)store::compared(all.front(), all.back()); });
}

}  // namespace cullscope::fuzz
