#include "gw/counters.h"

namespace gw {

Counters& Counters::operator+=(const Counters& other) {
    draws += other.draws;
    vertices += other.vertices;
    primitives += other.primitives;
    rejected += other.rejected;
    clipped += other.clipped;
    degenerate += other.degenerate;
    culled += other.culled;
    drawn += other.drawn;
    fragments += other.fragments;
    alpha_killed += other.alpha_killed;
    stencil_killed += other.stencil_killed;
    depth_killed += other.depth_killed;
    written += other.written;
    texels += other.texels;
    pixels += other.pixels;
    accum_overflows += other.accum_overflows;
    bytes += other.bytes;
    return *this;
}

std::optional<std::uint64_t> query_result(std::span<const PassReport> passes, std::uint32_t key) {
    for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass)
        for (auto query = pass->queries.rbegin(); query != pass->queries.rend(); ++query)
            if (query->key == key) return query->samples;
    return {};
}

}  // namespace gw
