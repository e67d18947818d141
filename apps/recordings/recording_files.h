// Recordings of drawings, and their files. Does not parse options.
#pragma once

#include "apps/picture/picture_options.h"
#include "image/output/output_set.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/recording/stream.h"

#include <filesystem>
#include <iosfwd>
#include <string>

namespace CLI {
class App;
}

namespace gw::apps {

/// The recording of lists that were executed for a drawing, with the drawing's names.
inspect::Recording recording_of(const Drawing& drawing, std::vector<CommandList> lists);

/// Hidden-surface algorithms write each polygon's identifier for its colour.
bool writes_identifiers(const inspect::Recording& recording);

/// Draws the drawing and records everything that enters the machine. A hidden-surface algorithm of
/// this name draws the scene instead; "": none.
inspect::Recording record(const Drawing& drawing, const Session& session,
                          const std::string& algorithm);

/// Draws the drawing and writes everything that enters the machine to a stream with one window.
void record_stream(const Drawing& drawing, const Session& session, const std::string& algorithm,
                   std::ostream& out);

/// A recording's file, and one of its windows: a name or a number; empty if it has only one.
struct RecordingChoice {
    std::filesystem::path file;
    std::string window;
};
/// --window.
void add_window_option(CLI::App& command, std::string& window);
/// RECORDING and --window.
void add_recording_options(CLI::App& command, RecordingChoice& choice);

/// Reads a recording, as an input of the session. Warns if it is cut short. Throws Error "T.gwt:
/// what is wrong".
inspect::Recording load_recording(const RecordingChoice& choice, Session& session);

/// The same, with all windows if none is chosen.
inspect::Stream load_windows(const RecordingChoice& choice, Session& session);

/// --surface: of the pixels that a command shows; 0 is the window.
void add_surface_option(CLI::App& command, std::uint32_t& number);

/// The largest size of the chosen surface. Throws Error if the recording does not make it. Warns if
/// it is the window, and others are left out.
Surface chosen_surface(const inspect::Recording& recording, const RecordingChoice& choice,
                       std::uint32_t number);

/// Replays the recording and adds its manifest to the files of `output`. With values, adds
/// "M.values" beside "M.json", unless `file` is a device.
void put_manifest(image::OutputSet& output, const std::filesystem::path& file,
                  const inspect::Recording& recording, const inspect::MachineMaker& make,
                  bool with_values);

}  // namespace gw::apps
