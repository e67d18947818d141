// The user's environment variables: GW_PROFILE, GW_THREADS, GW_MACHINE. docs/opengl.md
#pragma once

#include "gw/machine.h"
#include "gw/profile.h"

#include <memory>
#include <string_view>

namespace gw::gl {

struct Settings {
    Profile profile = opengl();  ///< GW_PROFILE: gw/profile_text.h
    int threads = 0;             ///< GW_THREADS; 0: all
    bool reference = false;      ///< GW_MACHINE: fast or reference
};

/// Read once. A variable whose value is wrong is ignored, and one line on stderr says so.
const Settings& settings();

/// "gw: GW_THREADS is 'many'; expected 0 to 256; it is ignored", on stderr.
void report_ignored(std::string_view variable, std::string_view value, std::string_view expected);

/// A machine of the settings' kind.
std::unique_ptr<Machine> make_machine(const Profile& profile, int width, int height);

}  // namespace gw::gl
