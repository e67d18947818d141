#include "tests/fuzz/check/explain.h"

#include "gw/reference/make.h"
#include "tests/fuzz/check/describe.h"
#include "tests/fuzz/check/diversity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gw::fuzz {
namespace {

const char* name_of(Fate fate) {
    switch (fate) {
        case Fate::AlphaTest: return "killed by the alpha test";
        case Fate::StencilTest: return "killed by the stencil test";
        case Fate::DepthTest: return "killed by the depth test";
        case Fate::Written: return "written";
    }
    return "";
}

std::string text_of(const PixelValues& v) {
    return fmt::format("depth {} stencil {} colour {} back {} accum {}", v.depth, v.stencil,
                       fmt::join(v.color, " "), fmt::join(v.back, " "), fmt::join(v.accum, " "));
}

class PixelObserver final : public Observer {
public:
    explicit PixelObserver(const ivec2& pixel) : pixel_(pixel) {}

    void begin_command(std::size_t) override {
        lines.clear();
        fragments = written = 0;
    }
    void fragment(const Fragment& f, Fate fate, const PixelValues& before,
                  const PixelValues& after) override {
        if (f.x != pixel_.x || f.y != pixel_.y) return;
        fragments += 1;
        written += fate == Fate::Written ? 1 : 0;
        lines += fmt::format(
            "  primitive {} ({}): depth {} colour {}: {}\n    before {}\n    after  {}\n",
            f.primitive, f.front ? "front" : "back", f.depth, fmt::join(f.color, " "),
            name_of(fate), text_of(before), text_of(after));
    }
    void pixel(int x, int y, const PixelValues& before, const PixelValues& after) override {
        if (x != pixel_.x || y != pixel_.y) return;
        lines += fmt::format("  pixel command\n    before {}\n    after  {}\n", text_of(before),
                             text_of(after));
    }

    std::string lines;
    int fragments = 0, written = 0;

private:
    ivec2 pixel_;
};

/// The stage that decides the plane's value, given the reference machine's events.
std::string stage_of(const PixelObserver& seen, const Command& command, const Difference& d) {
    const bool draws = std::holds_alternative<Draw>(command);
    if (seen.lines.empty())
        return "coverage, clipping or culling: machine a makes no fragment here";
    if (seen.fragments == 0) return "pixel command";
    if (seen.written == 0) return "coverage or a test: machine a kills every fragment here";
    switch (*d.plane) {
        case Plane::Depth:
            return draws ? "depth: its plane, offset, test or mask" : "depth test or mask";
        case Plane::Stencil: return "stencil operation or mask";
        case Plane::Color:
        case Plane::Back:
            return draws ? "shading (colour, texture, fog), blending or colour mask"
                         : "blending or colour mask";
        case Plane::Accum: return "accumulation";
    }
    return "";
}

}  // namespace

std::string explain_pixel(const Case& c, std::size_t command, const Difference& d) {
    PixelObserver observer(d.pixel);
    const auto machine = reference::make(c.profile, c.width, c.height, &observer);
    for (std::size_t i = 0; i <= command; ++i) machine->execute(part_of(c.list, i, 1));
    return fmt::format("stage: {}\n{}", stage_of(observer, c.list.commands[command], d),
                       observer.lines);
}

std::string report(const Suite& suite, std::uint64_t index, const Case& c, const Failure& f,
                   std::string_view a, std::string_view b) {
    const Difference& d = f.difference;
    std::string out =
        fmt::format("DIFFERENCE in list {} of suite {}, executed {}, after command {}\n", index,
                    suite.name, name_of(f.split), f.command);
    out += fmt::format("  {}\n", describe(c.list.commands[f.command]));
    out += fmt::format("{}{}: {} {}, {} {}\n", d.what,
                       d.plane ? fmt::format(", pixel {} {}", d.pixel.x, d.pixel.y) : "", a, d.a, b,
                       d.b);
    if (d.plane) out += explain_pixel(c, f.command, d);
    out += fmt::format(
        "repeat: build/release/bin/gw-fuzz --suite {} --range {} {} --machine-a {} --machine-b {}\n",
        suite.name, index, index + 1, a, b);
    return out;
}

std::string disagreement(const Suite& suite, std::uint64_t low, std::uint64_t high) {
    const MachineMaker a = machine_named("reference"), b = machine_named("fast");
    Diversity reached;
    for (std::uint64_t i = low; i < high; ++i) {
        const Case c = make_case(suite, i);
        const auto failure = run_case(c, a, b, [&](Machine& machine) { reached.add(c, machine); });
        if (failure) return report(suite, i, c, *failure, "reference", "fast");
    }
    return missing(reached, suite);
}

}  // namespace gw::fuzz
