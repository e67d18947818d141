// The record beside a film's pictures: what they depend on. Pictures of one film are drawn at several
// times and by several processes, and none may be of another film. Does not draw.
#pragma once

#include "apps/picture/picture_options.h"
#include "image/picture.h"
#include "scene/film.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// A line for each option and file that changes pixels. `film` is as it is drawn.
std::vector<std::string> words_of_film(const Drawing& drawing, const scene::Film& film,
                                       const image::Tone& tone, const Session& session);

class FilmRecord {
public:
    /// The record of pictures IMAGE_001 ... is "planet.png.film". Throws Error if it is none.
    FilmRecord(const std::filesystem::path& picture, std::vector<std::string> words);

    bool is_there() const { return !found_.empty(); }
    /// Throws Error if these words differ from those of the record, or if there is none.
    void check_same() const;
    /// Whether the file is there, and was written since the record was.
    bool has(const std::filesystem::path& picture) const;
    /// Writes it, unless it has these words. From then on earlier pictures are of another film.
    void write() const;

private:
    std::filesystem::path file_;
    std::vector<std::string> words_;
    std::vector<std::string> found_;  ///< none: there is no record
};

}  // namespace gw::apps
