// The temporary files and new folders that exist now, so that a signal can remove them; and those
// that a killed process left. Does not create or write them: OutputFile, OutputSet and OutputFolder
// do.
#pragma once

#include <filesystem>

namespace gw::image {

/// Announces a temporary file or folder before it is created. Throws Error when there are more than
/// 1024, about as many as a process may keep open.
void register_temporary(const std::filesystem::path& name);
/// The same of a folder that goes away with all that is in it.
void register_temporary_tree(const std::filesystem::path& name);
/// Removes from a folder the temporary files and folders of processes that are gone: killed, or cut
/// off with the machine. Once per folder and process. Files of other users stay, and files that a
/// process locks which is not seen from here, as in another container.
void remove_stale_temporaries(const std::filesystem::path& folder);
/// Forgets it, after it was renamed, removed or committed.
void forget_temporary(const std::filesystem::path& name);

/// From now on SIGINT, SIGTERM and SIGHUP remove the temporary files, trees and empty folders and
/// then end the process as they do by default (the shell sees 130 for Ctrl-C); and a file grown
/// beyond `ulimit -f` is an error, not a signal. A signal that is ignored stays ignored.
void remove_temporaries_on_signals();

}  // namespace gw::image
