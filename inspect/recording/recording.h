// A recording: everything that entered one machine, as a value, and its form as bytes.
// docs/recordings.md. Does not write files and does not execute: inspect/replay does.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "inspect/recording/calls.h"
#include "inspect/shown/color_map.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gw::inspect {

/// The paper's parameter set of the passes of this name.
struct ParameterSet {
    std::string pass, set;
    bool operator==(const ParameterSet&) const = default;
};

struct Recording {
    std::string producer;  ///< the program and its version
    std::string scene;     ///< the name of the scene's file
    std::string renderer;  ///< the renderer that made the lists
    Profile profile;
    int width = 0, height = 0;
    std::vector<ParameterSet> sets;
    std::vector<CommandList> lists;  ///< as they were executed, one after the other
    std::vector<CallTable> calls;    ///< of lists[i]; fewer, or empty: unknown
    /// How a screen shows the colours after lists[i]; none, or fewer: as after the list before, at
    /// first as colours.
    std::vector<std::optional<ColorMap>> color_maps;
};

/// The newest version of the schema that `decode` reads. `encode` writes the oldest that holds what
/// is recorded.
inline constexpr std::uint32_t newest_version = 2;

/// As inspect/recording/recording.fbs says. Meshes, maps, lights and states that are equal are
/// stored once. Throws Error if it would be larger than 2 GB, the format's limit.
std::vector<std::uint8_t> encode(const Recording& recording);

/// The most that a recording may demand of this process; more is refused. docs/recordings.md,
/// "Limits".
struct Limits {
    /// of commands, meshes, maps in memory
    std::uint64_t decoded_bytes = std::uint64_t{4} << 30;
    std::uint64_t machine_bytes = std::uint64_t{1} << 30;  ///< of slots, surfaces and read-backs
    /// primitives of a draw times 64x64 tiles
    std::uint64_t geometry = std::uint64_t{1} << 31;
};

/// The bytes of a file, for `decode`. Reads only the beginning of a file that is no recording, and
/// throws Error "T.gwt: not a recording; ...".
std::vector<std::uint8_t> read_recording_bytes(const std::filesystem::path& file);

/// From untrusted bytes: a recording whose lists are valid on its profile and window. Throws Error
/// with the reason if there is none.
Recording decode(std::span<const std::uint8_t> bytes, const Limits& limits = {});

}  // namespace gw::inspect
