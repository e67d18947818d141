#include "inspect/manifest/merge_runs.h"

#include "inspect/recording/content.h"

#include <fmt/format.h>

#include <map>

namespace gw::inspect {
namespace {

struct PassRuns {
    ManifestPass first;
    std::array<std::vector<std::uint8_t>, 4> digests;  ///< of all runs, as bytes
    int count = 0;
};

void add_bytes(std::vector<std::uint8_t>& bytes, const Digest& digest) {
    for (const std::uint64_t half : {digest.high, digest.low})
        for (int shift = 56; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(half >> shift));
}

void add(PassRuns& runs, const ManifestPass& pass) {
    if (runs.count++ == 0)
        runs.first = pass;
    else
        runs.first.report.counters += pass.report.counters;
    for (std::size_t i = 0; i < 4; ++i) add_bytes(runs.digests[i], pass.report.digests[i]);
}

ManifestPass merged(const PassRuns& runs) {
    ManifestPass pass = runs.first;
    if (runs.count == 1) return pass;
    pass.report.name += fmt::format(", {} runs", runs.count);
    for (std::size_t i = 0; i < 4; ++i) pass.report.digests[i] = digest_of_bytes(runs.digests[i]);
    return pass;
}

}  // namespace

Manifest merge_runs(const Manifest& manifest) {
    std::map<std::string, std::size_t> places;
    std::vector<PassRuns> all;
    for (const ManifestPass& pass : manifest.passes) {
        const auto [place, is_new] = places.try_emplace(pass.report.name, all.size());
        if (is_new) all.emplace_back();
        add(all[place->second], pass);
    }
    Manifest result = manifest;
    result.passes.clear();
    for (const PassRuns& runs : all) result.passes.push_back(merged(runs));
    return result;
}

}  // namespace gw::inspect
