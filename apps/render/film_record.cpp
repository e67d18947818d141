#include "apps/render/film_record.h"

#include "apps/render/request_words.h"
#include "gw/error.h"
#include "image/output/output_file.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

const std::string record_line = "film record 1";

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0, end; (end = text.find('\n', at)) != text.npos; at = end + 1)
        lines.push_back(text.substr(at, end - at));
    return lines;
}

std::string line_at(const std::vector<std::string>& lines,
                    std::vector<std::string>::const_iterator at) {
    return at == lines.end() ? "nothing" : "'" + scene::printable(*at, 120) + "'";
}

}  // namespace

std::vector<std::string> words_of_film(const Drawing& drawing, const scene::Film& film,
                                       const image::Tone& tone, const Session& session) {
    const Size size = drawing.request.size;
    std::vector<std::string> words{
        record_line,
        "version " + version(),
        "scene " + digest_of_files(session.inputs.names()),
        fmt::format("size {}x{}", size.width, size.height),
        "animation " + scene::printable(film.name, 200),
        fmt::format("rate {}", film.rate),
        fmt::format("shutter {}", film.shutter),
        fmt::format("instants {}", film.instants),
        fmt::format("gamma {}", tone.gamma),
        fmt::format("exposure {}", tone.exposure),
    };
    for (const auto& [name, word] : words_of(drawing.request)) words.push_back(name + " " + word);
    return words;
}

FilmRecord::FilmRecord(const std::filesystem::path& picture, std::vector<std::string> words)
    : file_(picture), words_(std::move(words)) {
    file_ += ".film";
    if (!std::filesystem::exists(file_)) return;
    found_ = lines_of(scene::read_bytes(file_));
    if (found_.empty() || found_.front() != record_line)
        throw Error(file_.string(), 0, "is no record of a film; expected one, or no such file");
}

void FilmRecord::check_same() const {
    if (found_ == words_) return;
    if (found_.empty())
        throw Error(file_.string(), 0,
                    "does not exist; expected the record of the film to continue");
    const auto [was, is] = std::ranges::mismatch(found_, words_);
    throw Error(file_.string(), 0,
                fmt::format("the film was drawn with {}, not with {}; expected the same, or no "
                            "--continue",
                            line_at(found_, was), line_at(words_, is)));
}

bool FilmRecord::has(const std::filesystem::path& picture) const {
    return std::filesystem::exists(picture) &&
           std::filesystem::last_write_time(picture) >= std::filesystem::last_write_time(file_);
}

void FilmRecord::write() const {
    if (found_ == words_) return;
    std::string text;
    for (const std::string& line : words_) text += line + "\n";
    image::write_file(file_, text);
}

}  // namespace gw::apps
