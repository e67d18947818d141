// The list of temporary files and new folders, so that a signal can remove them. Also removes those
// that killed processes left. Does not create or write them: OutputFile, OutputSet and OutputFolder
// do.
#pragma once

#include <filesystem>

namespace gw::image {

/// Announces a temporary file or folder before it is created. Throws Error if there are more than
/// 1024, about as many as a process may keep open.
void register_temporary(const std::filesystem::path& name);
/// The same for a folder that is removed with all its files.
void register_temporary_tree(const std::filesystem::path& name);
/// Removes from a folder the temporary files and folders of processes that no longer exist. Works
/// once for each folder and process. Files of other users stay. So do files that another process
/// locks, even one in another container, which is invisible from here.
void remove_stale_temporaries(const std::filesystem::path& folder);
/// Forgets a file or folder, after it was renamed, removed or committed.
void forget_temporary(const std::filesystem::path& name);

/// Removes them all, before the process ends otherwise than by returning. Allocates nothing.
void remove_temporaries();
/// From now on SIGINT, SIGTERM and SIGHUP remove the temporary files, trees and empty folders and
/// then end the process as they do by default (the shell sees 130 for Ctrl-C); and a file grown
/// beyond `ulimit -f` is an error, not a signal. A signal that is ignored stays ignored.
void remove_temporaries_on_signals();

}  // namespace gw::image
