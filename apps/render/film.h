// The pictures of a film, numbered files one after the other, and their video. Does not parse options.
#pragma once

#include "apps/render/frame_files.h"

#include <optional>
#include <string>
#include <utility>

namespace gw::apps {

class Progress;

struct FilmOptions {
    std::pair<int, int> first_last{1, 1};
    std::string animation{};              ///< its name or number from 0; empty: the first
    std::optional<double> rate, shutter;  ///< instead of the scene's
    std::optional<int> instants;
    bool quiet = false;             ///< no warnings
    bool go_on = false;             ///< begins at the first picture that is missing
    std::filesystem::path video{};  ///< made of the pictures; empty: none
};

/// Each picture is finished before the next is begun. The films are the drawing's: at least one.
/// Throws Error.
void draw_film(Drawing& drawing, const FrameFiles& files, const FilmOptions& options,
               Progress& progress, const Session& session);

}  // namespace gw::apps
