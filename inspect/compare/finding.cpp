#include "inspect/compare/finding.h"

#include "gw/escape_controls.h"
#include "gw/names.h"

#include <fmt/format.h>

namespace gw::inspect {
namespace {

struct StageCounter {
    std::uint64_t Counters::*count;
    const char* stage;
};
/// The stages that a wrong count accuses; bytes follow from the others.
constexpr StageCounter stage_counters[] = {
    {&Counters::draws, "the commands themselves"},
    {&Counters::vertices, "the commands themselves"},
    {&Counters::primitives, "primitive assembly"},
    {&Counters::rejected, "clipping"},
    {&Counters::clipped, "clipping"},
    {&Counters::degenerate, "window coordinates"},
    {&Counters::culled, "culling"},
    {&Counters::drawn, "culling"},
    {&Counters::fragments, "rasterization"},
    {&Counters::texels, "texture look-up"},
    {&Counters::alpha_killed, "alpha test"},
    {&Counters::stencil_killed, "stencil test"},
    {&Counters::depth_killed, "depth test"},
    {&Counters::written, "depth test"},
    {&Counters::pixels, "pixel commands"},
    {&Counters::accum_overflows, "accumulation"},
    {&Counters::bytes, "the model of bytes"},
};
static_assert(std::size(stage_counters) * sizeof(std::uint64_t) == sizeof(Counters));

}  // namespace

std::string text(const Finding& f, int height) {
    std::string line;
    if (f.pass) line += fmt::format("pass {} '{}', ", *f.pass, f.pass_name);
    line += f.what;
    if (f.pixel) line += fmt::format(", pixel {} {}", f.pixel->x, height - 1 - f.pixel->y);
    if (!f.expected.empty() || !f.actual.empty())
        line +=
            fmt::format(": expected {}, got {}", f.expected.empty() ? "(not known)" : f.expected,
                        f.actual.empty() ? "nothing" : f.actual);
    if (!f.stage.empty()) line += "; stage: " + f.stage;
    line = escape_controls(line) + "\n";
    for (const std::string& note : f.notes) line += "  " + escape_controls(note) + "\n";
    return line;
}

std::string stage_of(const Counters& expected, const Counters& actual) {
    for (const auto& [count, stage] : stage_counters)
        if (expected.*count != actual.*count) return stage;
    return "";
}

std::string stage_of(Plane plane) {
    switch (plane) {
        case Plane::Color:
        case Plane::Back: return "shading, texture, fog, blending or the colour mask";
        case Plane::Depth: return "depth values or the depth mask";
        case Plane::Stencil: return "stencil operation or its write mask";
        case Plane::Accum: return "accumulation";
    }
    return "";
}

namespace {

/// "7: 256, 8: 0"
std::string text(const std::vector<QueryResult>& queries) {
    std::string out;
    for (const QueryResult& q : queries)
        out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", q.key, q.samples);
    return out.empty() ? "none" : out;
}

}  // namespace

std::optional<Finding> first_difference(const PassReport& expected, const PassReport& actual,
                                        std::size_t pass) {
    Finding f{.pass = pass, .pass_name = expected.name};
    if (expected.name != actual.name) {
        f.what = "name";
        f.expected = expected.name;
        f.actual = actual.name;
        return f;
    }
    for (const Plane plane : planes_in_order) {
        const auto i = std::size_t(plane);
        if (expected.digests[i] == actual.digests[i]) continue;
        f.what = std::string("plane ") + name_of(plane);
        f.stage = stage_of(expected.counters, actual.counters);
        if (f.stage.empty()) f.stage = stage_of(plane);
        return f;
    }
    for (const auto& [name, count] : counter_names())
        if (expected.counters.*count != actual.counters.*count) {
            f.what = std::string("counter ") + name;
            f.expected = std::to_string(expected.counters.*count);
            f.actual = std::to_string(actual.counters.*count);
            f.stage = stage_of(expected.counters, actual.counters);
            return f;
        }
    if (expected.queries != actual.queries) {
        f.what = "queries";
        f.expected = text(expected.queries);
        f.actual = text(actual.queries);
        return f;
    }
    return {};
}

}  // namespace gw::inspect
