#include "gw/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

namespace gw {

const char* name_of(const Command& command) {
    static constexpr const char* names[] = {
        "BeginPass",  "Clear",       "SetState",    "Draw", "WriteSpans", "WritePixels",
        "Accumulate", "Copy",        "CopyTexture", "Read", "DrawPixels", "SwapBuffers",
        "Query",      "MakeSurface", "UseSurface",  "Blit"};
    static_assert(std::size(names) == std::variant_size_v<Command>);
    return names[command.index()];
}

const char* name_of(Plane plane) {
    switch (plane) {
        case Plane::Color: return "color";
        case Plane::Depth: return "depth";
        case Plane::Stencil: return "stencil";
        case Plane::Accum: return "accum";
        case Plane::Back: return "back";
    }
    return "";
}

std::string value_at(const Planes& p, Plane plane, int x, int y) {
    const std::size_t i = p.index(x, y);
    switch (plane) {
        case Plane::Color: return fmt::format("{}", fmt::join(p.color[i], " "));
        case Plane::Depth: return std::to_string(p.depth[i]);
        case Plane::Stencil: return std::to_string(p.stencil[i]);
        case Plane::Accum: return fmt::format("{}", fmt::join(p.accum[i], " "));
        case Plane::Back: return fmt::format("{}", fmt::join(p.back[i], " "));
    }
    return "";
}

std::span<const CounterName> counter_names() {
    static constexpr CounterName names[] = {
        {"draws", &Counters::draws},
        {"vertices", &Counters::vertices},
        {"primitives", &Counters::primitives},
        {"rejected", &Counters::rejected},
        {"clipped", &Counters::clipped},
        {"degenerate", &Counters::degenerate},
        {"culled", &Counters::culled},
        {"drawn", &Counters::drawn},
        {"fragments", &Counters::fragments},
        {"alpha_killed", &Counters::alpha_killed},
        {"stencil_killed", &Counters::stencil_killed},
        {"depth_killed", &Counters::depth_killed},
        {"written", &Counters::written},
        {"texels", &Counters::texels},
        {"pixels", &Counters::pixels},
        {"accum_overflows", &Counters::accum_overflows},
        {"bytes", &Counters::bytes},
    };
    static_assert(sizeof(names) / sizeof(CounterName) * sizeof(std::uint64_t) == sizeof(Counters));
    return names;
}

}  // namespace gw
