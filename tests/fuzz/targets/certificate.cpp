#include "core/experiments/certify/certify.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void certificate(std::string_view input) {
    const std::filesystem::path file = fileOf(input, "state.json");
    std::vector<certify::Certificate> all;
    if (!acceptedFile(file, [&] { all = certify::readCertificates(file); })) return;
    require(!all.empty(), "a file of no certificate");
    for (const certify::Certificate& read : all) {
        require(read.done.size() == read.blocks && read.shard >= 1 && read.shard <= read.shards,
                "blocks or shards that are none");
        require(!certify::certificateText(certify::merged({read}).front()).empty(), "a certificate that says nothing");
    }
    // What a state says is what a run that goes on with it writes again.
    const std::string text = certify::certificatesJson(all);
    require(certify::certificatesJson(certify::readCertificates(fileOf(text, "again.json"))) == text,
            "certificates that are written are read back as others");
}

}  // namespace cullscope::fuzz
