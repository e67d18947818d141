// The submissions of a folder: a folder or a program file for each student. Copies one, and finds how
// it is run. Trusts no name, link or size in it. Does not run it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

struct Submission {
    std::string name;  ///< the student's: that of the folder, or of the file without its extension
    std::filesystem::path path;
};

/// By name. A file that is no program is left out with a warning. Throws Error if there is none, and if
/// two have one name.
std::vector<Submission> submissions_in(const std::filesystem::path& folder);

/// How a submission is run: a shell's words, in which "$1" is the file and "$2" the polygons.
struct WayToRun {
    std::string script, file;
    std::string program;  ///< a compiler or interpreter that the script needs; "" if not known
    std::string fault;    ///< why it cannot be run; "" if it can
};

/// Copies the regular files of a submission to an empty folder, where every user may read them. Links,
/// devices and hidden files are left out. The way has a fault if the files have more than `most` bytes. `command`:
/// the teacher's way to run it, "" to find one.
WayToRun copied(const Submission& submission, const std::filesystem::path& to, std::size_t most,
                const std::string& command);

/// A digest of the files' names and bytes.
std::string content_of(const std::filesystem::path& folder);

}  // namespace gw::apps
