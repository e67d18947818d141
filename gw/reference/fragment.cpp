// [GL11] 4.1: from a fragment to the planes.
#include "gw/reference/fragment.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/tables.h"

namespace gw::reference {
namespace {

/// [GL11] 4.1.4: bits outside the write mask keep their value.
void update_stencil(const StencilFace& face, StencilOp op, std::uint32_t max,
                    std::uint8_t& stored) {
    const std::uint32_t result =
        stencil_result(op, stored, static_cast<std::uint32_t>(face.ref), max);
    stored = static_cast<std::uint8_t>((stored & ~face.write_mask) | (result & face.write_mask));
}

bool stencil_passes(const StencilFace& face, std::uint8_t stored) {
    return compare(face.func, static_cast<std::uint32_t>(face.ref) & face.mask, stored & face.mask);
}

/// The stencil and the depth test, up to the first that fails.
Fate sample_fate(const Resolved& r, Planes& planes, std::size_t i, const Fragment& f) {
    const StencilFace& face = f.front ? r.front : r.back;
    std::uint8_t& stencil = planes.stencil[i];
    if (!stencil_passes(face, stencil)) {
        update_stencil(face, face.fail, r.stencil_max, stencil);
        return Fate::StencilTest;
    }
    if (!compare(r.state.depth.func, f.depth, planes.depth[i])) {
        update_stencil(face, face.zfail, r.stencil_max, stencil);
        return Fate::DepthTest;
    }
    update_stencil(face, face.zpass, r.stencil_max, stencil);
    return Fate::Written;
}

/// The fragment's colour and the stored one: by a logical operation, blended, or the former alone.
Rgba joined_color(const Resolved& r, const Rgba& color, const Rgba& stored) {
    const State& s = r.state;
    if (s.logic_op.enable) return logic_result(s.logic_op.op, color, stored, r.bits);
    return s.blend.enable ? blend(s.blend, {color, stored, r.blend_color}, r.bits) : color;
}

void write(const Resolved& r, Planes& planes, std::size_t i, const Fragment& f) {
    if (r.state.depth.mask) planes.depth[i] = f.depth;
    for_draw_buffer(r.state, planes, [&](std::vector<Rgba>& color) {
        write_color(r.written_bits, joined_color(r, f.color, color[i]), color[i]);
    });
}

void count_sample(const FragmentTarget& target, Fate fate) {
    Counters& c = *target.counters;
    switch (fate) {
        case Fate::AlphaTest: c.alpha_killed += 1; return;
        case Fate::StencilTest: c.stencil_killed += 1; break;
        case Fate::DepthTest:
            c.depth_killed += 1;
            c.bytes += target.bytes.after_stencil;
            break;
        case Fate::Written:
            c.written += 1;
            c.bytes += target.bytes.after_stencil + target.bytes.written;
            break;
    }
    c.bytes += target.bytes.after_alpha;
}

/// One sample of a fragment, which passes the alpha test or not.
void process_sample(const Resolved& r, const FragmentTarget& target, const Fragment& f,
                    Planes& planes, bool passes_alpha) {
    const std::size_t i = planes.index(f.x, f.y);
    const PixelValues before = target.observer ? values_at(planes, i) : PixelValues{};
    const Fate fate = passes_alpha ? sample_fate(r, planes, i, f) : Fate::AlphaTest;
    if (fate == Fate::Written) write(r, planes, i, f);
    count_sample(target, fate);
    if (target.observer) target.observer->fragment(f, fate, before, values_at(planes, i));
}

}  // namespace

void write_color(const Rgba& bits, const Rgba& color, Rgba& stored) {
    for (std::size_t c = 0; c < 4; ++c) stored[c] = with_written_bits(stored[c], color[c], bits[c]);
}

void process_fragment(const Resolved& state, const FragmentTarget& target,
                      const Fragment& fragment) {
    Covered all{all_samples(state.samples), {}};
    all.depth.fill(fragment.depth);
    process_fragment(state, target, fragment, all);
}

void process_fragment(const Resolved& state, const FragmentTarget& target, const Fragment& given,
                      const Covered& covered) {
    target.counters->fragments += 1;
    const SampleMask mask = covered.mask & kept_samples(state, given.color[3]);
    Fragment fragment = given;
    if (state.state.multisample.alpha_to_one)
        fragment.color[3] = static_cast<std::uint16_t>(max_of_bits(state.bits));
    const bool passes = compare(state.state.alpha.func, fragment.color[3], state.alpha_ref);
    for (std::size_t k = 0; k < target.samples.size(); ++k) {
        if (!(mask >> k & 1)) continue;
        fragment.depth = covered.depth[k];
        fragment.sample = int(k);
        process_sample(state, target, fragment, target.samples[k], passes);
    }
}

}  // namespace gw::reference
