#include "inspect/text/state_fields.h"

#include "gw/describe/state_fields.h"
#include "inspect/text/value_text.h"

#include <fmt/format.h>

#include <concepts>

namespace gw::inspect {
namespace {

template <typename T>
concept Bits = std::unsigned_integral<T> && !std::same_as<T, bool>;

std::string field_text(Bits auto mask) { return fmt::format("{:#x}", mask); }
template <typename T>
requires(!Bits<T>) && requires(T value) { inspect::text(value); }
std::string field_text(const T& value) { return inspect::text(value); }
std::string field_text(const ViewportState& v) {
    return inspect::text(Rect{v.x, v.y, v.width, v.height});
}

/// Rows from the bottom; "none" where there is no stipple.
std::string field_text(const PolygonStippleState& stipple) {
    if (!stipple.pattern) return "none";
    std::string rows;
    for (const std::uint32_t row : *stipple.pattern) rows += fmt::format("{:08x} ", row);
    rows.pop_back();
    return rows;
}

/// The values of each unit that are not the initial ones.
std::string field_text(const MoreTextures& more);

/// All values of a struct that have a text.
std::vector<Field> fields_in(const auto& values) {
    std::vector<Field> all;
    for_each_value(
        values, [&](const Path& path, const auto& value,
                    const auto&) requires requires { field_text(value); } {
            all.push_back({path.str(), field_text(value)});
        });
    return all;
}

std::string field_text(const MoreTextures& more) {
    if (!more.units) return "none";
    const std::vector<Field> initial = fields_in(TextureState{});
    std::string out;
    for (std::size_t unit = 0; unit < more.units->size(); ++unit) {
        const std::vector<Field> now = fields_in((*more.units)[unit]);
        out += fmt::format("{}{}:", unit > 0 ? "; " : "", unit + 1);
        for (std::size_t i = 0; i < now.size(); ++i)
            if (now[i] != initial[i]) out += fmt::format(" {} {}", now[i].name, now[i].value);
    }
    return out;
}

}  // namespace

std::vector<Field> fields(const State& state) { return fields_in(state); }

std::vector<Field> changed_fields(const State& before, const State& state) {
    const std::vector<Field> old = fields(before), now = fields(state);
    std::vector<Field> changed;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (old[i] != now[i]) changed.push_back(now[i]);
    return changed;
}

}  // namespace gw::inspect
