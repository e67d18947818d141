// The table of a request's options: names, words, limits and help. Each door passes on the words
// that it was given, so all take the same ones and refuse others with the same text. To add an
// option, add a row in options.cpp.
#pragma once

#include "render/request.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::render {

struct Option {
    std::string name;                ///< "samples"; --samples of the command
    std::string type;                ///< of its word, for help: "N"
    std::string about;               ///< for help, with limits and default
    std::vector<std::string> words;  ///< that it takes; empty: see `type`
    /// Throws OptionError.
    std::function<void(Request&, const std::string& word)> set;
    /// The word that sets the request's value; empty: none was given.
    std::function<std::string(const Request&)> word;
};

/// In the order of help.
const std::vector<Option>& options();

/// Sets the option of this name, which must be one of options(). Throws OptionError.
void set(Request& request, const std::string& option, const std::string& word);

/// Whether the word of a profile names a file.
bool is_profile_file(const std::string& word);

/// Rays in a path; threads; superposed pictures.
inline constexpr int most_depth = 64, most_threads = 1024, most_samples = 32768;

}  // namespace gw::render
