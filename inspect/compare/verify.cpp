#include "inspect/compare/verify.h"

#include "inspect/manifest/json_of.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/text/call_text.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gw::inspect {
namespace {

std::optional<Finding> head_difference(const Manifest& expected, const Manifest& actual) {
    const auto differs = [](const char* what, const auto& a, const auto& b) {
        return Finding{.what = what, .expected = a, .actual = b};
    };
    if (expected.profile != actual.profile)
        return differs("profile", json_of(expected.profile).dump(), json_of(actual.profile).dump());
    const auto size = [](const Manifest& m) { return fmt::format("{}x{}", m.width, m.height); };
    if (size(expected) != size(actual)) return differs("window", size(expected), size(actual));
    return {};
}

/// Of two lists of fields, the first that is not in both with the same value.
std::optional<Finding> state_difference(const std::vector<Field>& expected,
                                        const std::vector<Field>& actual) {
    const auto value_in = [](const std::vector<Field>& list, const std::string& name) {
        const auto found =
            std::find_if(list.begin(), list.end(), [&](const Field& f) { return f.name == name; });
        return found == list.end() ? std::string("as the pass before") : found->value;
    };
    for (const auto* list : {&expected, &actual})
        for (const Field& field : *list) {
            const std::string a = value_in(expected, field.name), b = value_in(actual, field.name);
            if (a != b) return Finding{.what = "state " + field.name, .expected = a, .actual = b};
        }
    return {};
}

/// Of passes with the same planes. Older manifests do not know what was shown.
std::optional<Finding> shown_difference(const ManifestPass& expected, const ManifestPass& actual,
                                        std::size_t i) {
    if (!expected.shown || expected.shown == actual.shown) return {};
    return Finding{.what = "the shown picture",
                   .pass = i,
                   .pass_name = expected.report.name,
                   .expected = to_string(*expected.shown),
                   .actual = actual.shown ? to_string(*actual.shown) : "colours",
                   .notes = {"the planes agree: the colour maps differ"}};
}

/// Of two passes at place `i`.
std::optional<Finding> pass_difference(const ManifestPass& expected, const ManifestPass& actual,
                                       std::size_t i) {
    std::optional<Finding> finding = first_difference(expected.report, actual.report, i);
    if (!finding) finding = shown_difference(expected, actual, i);
    std::optional<Finding> cause = state_difference(expected.state, actual.state);
    if (!cause && expected.set != actual.set)
        cause = Finding{.what = "parameter set", .expected = expected.set, .actual = actual.set};
    if (cause) {
        cause->pass = i;
        cause->pass_name = expected.report.name;
    }
    if (!finding) return cause;
    if (cause)
        finding->notes.push_back(
            fmt::format("{}: expected {}, got {}", cause->what, cause->expected, cause->actual));
    return finding;
}

std::string list_of(const std::vector<ManifestPass>& passes, std::size_t first, std::size_t end) {
    constexpr std::size_t most = 5;
    std::string names;
    for (std::size_t i = first; i < std::min(end, first + most); ++i)
        names += fmt::format("{}{} '{}'", i > first ? ", " : "", i, passes[i].report.name);
    return end - first > most ? names + fmt::format(" and {} more", end - first - most) : names;
}

/// The passes that one side lacks, if the names before and after them are the same.
void note_missing_passes(Finding& finding, const std::vector<ManifestPass>& expected,
                         const std::vector<ManifestPass>& actual) {
    const std::size_t shorter = std::min(expected.size(), actual.size());
    const auto name = [](const auto& passes, std::size_t i) { return passes[i].report.name; };
    std::size_t before = 0, after = 0;
    while (before < shorter && name(expected, before) == name(actual, before)) ++before;
    while (after < shorter - before &&
           name(expected, expected.size() - 1 - after) == name(actual, actual.size() - 1 - after))
        ++after;
    const std::string missing = list_of(expected, before, expected.size() - after),
                      added = list_of(actual, before, actual.size() - after);
    if (!missing.empty()) finding.notes.push_back("missing: pass " + missing);
    if (!added.empty()) finding.notes.push_back("not expected: pass " + added);
}

Planes played(const Recording& recording, const MachineMaker& make, std::size_t pass) {
    const auto machine = make(recording);
    Player(recording, *machine).play_to(pass_ranges(recording).at(pass).end);
    return machine->planes();
}

bool is_as_said(const Planes& planes, const ManifestPass& pass) {
    return std::all_of(planes_in_order.begin(), planes_in_order.end(), [&](Plane plane) {
        return digest(planes, plane) == pass.report.digests[std::size_t(plane)];
    });
}

/// Names the first pixel of the finding's plane, and both values if they are known.
void find_pixel(Finding& finding, const std::optional<Planes>& expected, const Planes& actual,
                const ColorMap* map) {
    if (!expected) {
        finding.notes.push_back(
            "the pixel is unknown: no file of values beside the manifest fits it");
        return;
    }
    for (const Plane plane : planes_in_order) {
        const auto pixel = first_difference(*expected, actual, plane);
        if (!pixel) continue;
        finding.what = std::string("plane ") + name_of(plane);
        finding.pixel = pixel;
        finding.expected = shown_value(*expected, plane, pixel->x, pixel->y, map);
        finding.actual = shown_value(actual, plane, pixel->x, pixel->y, map);
        finding.notes.push_back(plural(wrong_pixels(*expected, actual, plane).size(),
                                       "pixel of this plane differs",
                                       "pixels of this plane differ"));
        return;
    }
}

bool changes(const PixelEvent& e, Plane plane) {
    switch (plane) {
        case Plane::Color: return e.before.color != e.after.color;
        case Plane::Back: return e.before.back != e.after.back;
        case Plane::Depth: return e.before.depth != e.after.depth;
        case Plane::Stencil: return e.before.stencil != e.after.stencil;
        case Plane::Accum: return e.before.accum != e.after.accum;
    }
    return false;
}

/// Names the call that last changed the finding's plane at its pixel, in its pass. An exchange of
/// buffers only moves what was drawn to the other one.
void find_call(Finding& finding, const Recording& recording) {
    if (!finding.pixel || CallNames(recording).empty()) return;
    Plane plane = *std::ranges::find_if(planes_in_order, [&](Plane p) {
        return finding.what == std::string("plane ") + name_of(p);
    });
    const auto events = pixel_history(recording, finding.pixel->x, finding.pixel->y);
    for (auto e = events.rbegin(); e != events.rend(); ++e) {
        if (e->pass != *finding.pass) continue;
        if (std::string_view(e->command_name) == "SwapBuffers") {
            if (plane == Plane::Color || plane == Plane::Back)
                plane = plane == Plane::Color ? Plane::Back : Plane::Color;
        } else if (changes(*e, plane)) {
            if (!e->call.empty()) finding.notes.push_back("last written by " + e->call);
            return;
        }
    }
}

}  // namespace

std::optional<Finding> first_difference(const Manifest& expected, const Manifest& actual) {
    if (auto finding = head_difference(expected, actual)) return finding;
    for (std::size_t i = 0; i < std::min(expected.passes.size(), actual.passes.size()); ++i)
        if (auto finding = pass_difference(expected.passes[i], actual.passes[i], i)) {
            if (finding->what == "name")
                note_missing_passes(*finding, expected.passes, actual.passes);
            return finding;
        }
    if (expected.passes.size() == actual.passes.size()) return {};
    Finding finding{.what = "number of passes",
                    .expected = std::to_string(expected.passes.size()),
                    .actual = std::to_string(actual.passes.size())};
    note_missing_passes(finding, expected.passes, actual.passes);
    return finding;
}

Verification verify(const Recording& recording, const Manifest& manifest,
                    std::span<const std::uint8_t> values, const MachineMaker& make,
                    const MachineMaker& other) {
    const Manifest actual = replayed_manifest(recording, make, nullptr);
    Verification v{.finding = first_difference(manifest, actual),
                   .same_commands = manifest.commands_hash == actual.commands_hash,
                   .same_scene = manifest.scene_hash == actual.scene_hash};
    if (!v.finding || !v.finding->pass || !v.finding->what.starts_with("plane ")) return v;
    const std::size_t pass = *v.finding->pass;
    v.actual_planes = played(recording, make, pass);
    Planes expected = values.empty() ? played(recording, other, pass)
                                     : planes_after(values, recording.width, recording.height, pass,
                                                    recording.profile.color_planes);
    if (is_as_said(expected, manifest.passes[pass])) v.expected_planes = std::move(expected);
    find_pixel(*v.finding, v.expected_planes, *v.actual_planes, ShownMaps(recording).of_pass(pass));
    find_call(*v.finding, recording);
    return v;
}

}  // namespace gw::inspect
