// The lists that make a new machine's planes equal to another's. A recording that starts in the middle
// of a program begins with them.
#pragma once

#include "gw/command_list.h"
#include "gw/machine.h"
#include "gw/planes.h"
#include "gw/profile.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gw::gl {

/// One pass of this name. The machine's planes are 0; its state is the initial one, and `state`
/// afterwards.
CommandList restoring_list(const Planes& planes, const Profile& profile, const std::string& pass,
                           const gw::State& state);

/// A surface and all of its values, the same for all samples of a pixel.
struct SurfaceValues {
    gw::Surface surface;
    std::vector<Readback> parts;
};
/// The same for a machine's surfaces, by number; `in_use` is used afterwards. The window's planes stay 0.
CommandList restoring_list(const std::map<std::uint32_t, SurfaceValues>& surfaces,
                           const std::string& pass, std::uint32_t in_use, const gw::State& state);

}  // namespace gw::gl
