// Turns counts of fragments and pixels into a pass's counters: bytes and texels are linear in them.
#include "gw/fast/tile/tile_run.h"
#include "gw/stages/accumulation.h"
#include "gw/stages/tables.h"

#include <bit>

namespace gw::fast {
namespace {

Counters fragment_counters(const OpCounts& n, const FragmentBytes& bytes) {
    Counters c;
    c.fragments = n.fragments;
    c.alpha_killed = n.alpha_killed;
    c.stencil_killed = n.stencil_killed;
    c.depth_killed = n.depth_killed;
    c.written = n.written;
    c.bytes = (n.stencil_killed + n.depth_killed + n.written) * bytes.after_alpha +
              (n.depth_killed + n.written) * bytes.after_stencil + n.written * bytes.written;
    return c;
}

Counters pixel_counters(const OpCounts& n, std::uint64_t bytes) {
    Counters c;
    c.pixels = n.pixels;
    c.accum_overflows = n.accum_overflows;
    c.bytes = n.pixels * bytes;
    return c;
}

struct Count {
    const OpCounts& n;
    const Profile& profile;

    static std::uint64_t samples(const auto& op) { return std::uint64_t(op.state.samples); }

    Counters operator()(const DrawOp& op) const {
        Counters c = fragment_counters(n, op.bytes);
        c.texels = n.fragments * std::uint64_t(op.look_ups);
        return c;
    }
    Counters operator()(const SpansOp& op) const { return fragment_counters(n, op.bytes); }
    Counters operator()(const PixelsOp& op) const {
        Counters c = fragment_counters(n, op.bytes);
        c += pixel_counters(n, samples(op) * plane_bytes(op.write->plane, profile));
        return c;
    }
    Counters operator()(const DrawPixelsOp& op) const {
        Counters c = fragment_counters(n, op.bytes);
        c += pixel_counters(n, samples(op) * plane_bytes(Plane::Stencil, profile));
        c.texels = n.fragments * std::uint64_t(op.placed->look_ups());
        return c;
    }
    Counters operator()(const ClearOp& op) const {
        Counters c;
        const std::uint64_t planes = std::uint64_t(std::popcount(op.planes));
        if (planes == 0) return c;
        c.pixels = n.pixels;
        for (const Plane plane : every_plane)
            if (op.planes & mask_of(plane))
                c.bytes += samples(op) * (n.pixels / planes) *
                           written_bytes(plane, op.state.state, profile);
        return c;
    }
    Counters operator()(const AccumulateOp& op) const {
        return pixel_counters(n, accumulate_bytes(op.accumulate->op, op.state.state, profile));
    }
    Counters operator()(const ReadOp& op) const {
        return pixel_counters(n, plane_bytes(op.read->plane, profile));
    }
};

}  // namespace

Counters counters_of(const TileOp& op, const OpCounts& counts, const Profile& profile) {
    return std::visit(Count{counts, profile}, op.op);
}

}  // namespace gw::fast
