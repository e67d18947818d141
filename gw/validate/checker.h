// The checks of a command, with a message that names the command. Does not know the order of
// commands: list.cpp does.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/base/finite.h"
#include "gw/error.h"
#include "gw/machine.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gw {

/// The position in the list, and checks that throw Error with it.
struct Checker {
    const Profile& profile;
    Surface window;
    int width = 0, height = 0, depth_bits = 24;  ///< of the surface in use
    std::size_t command = 0;
    const char* name = "";
    std::string_view pass{};
    mutable const void* checked_lights = nullptr;          ///< of the last draw
    mutable const void* checked_mesh = nullptr;            ///< the last one
    mutable std::array<const State*, 2> checked_states{};  ///< the last two

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("command {} ({}){}: {}", command, name,
                                pass.empty() ? "" : fmt::format(" of pass '{}'", pass), what));
    }
    void require(bool ok, const char* what, const auto& value, const char* expected) const {
        if (!ok) fail(fmt::format("{} = {}; expected {}", what, value, expected));
    }
    void extension(bool used, bool present, const char* extension) const {
        if (used && !present)
            fail(fmt::format("extension {} is not in profile {}", extension, profile.name));
    }
    /// An enumeration with the values 0 to `last`.
    template <class Enum>
    void enumeration(const char* what, Enum value, Enum last) const {
        if (value > last)
            fail(fmt::format("{} = {}; expected 0 to {}", what, int(value), int(last)));
    }
    void planes(const char* what, PlaneMask mask) const {
        if ((mask & ~all_planes) != 0)
            fail(fmt::format("{} = {}; expected bits of four planes, 0 to {}", what, mask,
                             all_planes));
    }
    /// A colour plane that a machine of this profile may lack.
    void color_plane(const char* what, bool is_there, const char* value) const {
        if (!is_there)
            fail(fmt::format("{} = {}; expected a plane of profile {}", what, value, profile.name));
    }
    /// The largest side of a rectangle or a viewport: that of a surface, or of a window.
    bool is_side(int least, int v) const {
        const bool large = profile.extensions.surfaces;
        return v >= least && v <= (large ? max_surface_size : max_window_size);
    }
    const char* sides(const char* of_window, const char* of_surface) const {
        return profile.extensions.surfaces ? of_surface : of_window;
    }
    void position(const char* what, int v) const {
        require(v >= -max_window_size && v <= max_window_size, what, v, "-4096 to 4096");
    }
    void finite(const char* what, double v) const {
        require(std::isfinite(v), what, v, "a finite number");
    }
    void finite(const char* what, const dvec4& v) const { finite(what, &v.x, 4); }
    void finite(const char* what, const vec4& v) const { finite(what, &v.x, 4); }
    void finite(const char* what, const vec3& v) const { finite(what, &v.x, 3); }
    void finite(const char* what, const dmat4& m) const { finite(what, &m[0][0], 16); }

private:
    template <class T>
    void finite(const char* what, const T* first, std::size_t count) const {
        if (all_finite(first, count)) return;
        for (std::size_t i = 0; i < count; ++i) finite(what, double(first[i]));
    }
};

void check(const Checker& c, const BeginPass& pass);
void check(const Checker& c, const Clear& clear);
void check(const Checker& c, const SetState& set);
void check(const Checker& c, const Draw& draw);
void check(const Checker& c, const WriteSpans& write);
void check(const Checker& c, const WritePixels& write);
void check(const Checker& c, const Accumulate& accumulate);
void check(const Checker& c, const Copy& copy);
void check(const Checker& c, const CopyTexture& copy);
void check(const Checker& c, const Read& read);
void check(const Checker& c, const DrawPixels& draw);
void check(const Checker& c, const TextureBinding& map);
void check(const Checker& c, const MoreBindings& maps);
void check(const Checker& c, const SwapBuffers& swap);
void check(const Checker& c, const Query& query);
void check(const Checker& c, const MakeSurface& make);
void check(const Checker& c, const UseSurface& use);
void check(const Checker& c, const Blit& blit);

}  // namespace gw
