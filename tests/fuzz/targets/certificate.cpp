#include "core/experiments/certify/certify.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void certificate(std::string_view input) {
    const std::filesystem::path file = fileOf(input, "state.json");
    certify::Certificate read;
    if (!acceptedFile(file, [&] { read = certify::readCertificate(file); })) return;
    require(read.done.size() == read.blocks && read.shard >= 1 && read.shard <= read.shards, "blocks or shards that are none");
    // What a state says is what a run that goes on with it writes again.
    const std::string text = certify::certificateJson(read);
    require(certify::certificateJson(certify::readCertificate(fileOf(text, "again.json"))) == text,
            "a certificate that is written is read back as another one");
    require(!certify::certificateText(certify::merged({read})).empty(), "a certificate that says nothing");
}

}  // namespace cullscope::fuzz
