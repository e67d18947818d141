// Recordings of drawings, and recordings in files. Does not parse options.
#pragma once

#include "apps/render/frame_files.h"
#include "image/output/output_set.h"
#include "inspect/manifest/manifest_file.h"

#include <filesystem>
#include <string>

namespace gw::apps {

/// What was executed while a drawing was drawn, with its names.
inspect::Recording recording_of(const Drawing& drawing, std::vector<CommandList> lists);

/// Everything that entered the machine while the drawing was drawn, or while a hidden-surface
/// algorithm of this name drew the scene ("": none).
inspect::Recording record(const Drawing& drawing, const Session& session,
                          const std::string& algorithm);

/// An input of the session. Throws Error "T.gwt: what is wrong".
inspect::Recording load_recording(const std::filesystem::path& file, Session& session);

/// Replays the recording and adds what came out to the files of `output`: the manifest and, where
/// wanted and `file` is no device, its values beside it, "M.values" for "M.json".
void put_manifest(image::OutputSet& output, const std::filesystem::path& file,
                  const inspect::Recording& recording, const inspect::MachineMaker& make,
                  bool with_values);

}  // namespace gw::apps
