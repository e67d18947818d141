#include "apps/render/film.h"

#include "apps/command/terminal.h"
#include "apps/render/film_record.h"
#include "apps/render/video.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/write.h"
#include "scene/draw/fit.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace gw::apps {
namespace {

/// The mean of pictures, to nearest, as an accumulation buffer with bits for all of them has it.
class Exposure {
public:
    void add(const std::vector<Rgba>& color) {
        sums_.resize(color.size());
        for (std::size_t i = 0; i < color.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k) sums_[i][k] += color[i][k];
        ++count_;
    }
    std::vector<Rgba> mean() const {
        std::vector<Rgba> color(sums_.size());
        for (std::size_t i = 0; i < color.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k)
                color[i][k] = std::uint16_t((2 * sums_[i][k] + count_) / (2 * count_));
        return color;
    }

private:
    std::vector<std::array<std::uint32_t, 4>> sums_;
    std::uint32_t count_ = 0;
};

std::vector<Rgba> exposed(Drawing& drawing, const scene::Film& film, int number, Machine& machine) {
    Exposure exposure;
    for (const double time : film.instants_of(number)) {
        film.pose(drawing.scene, time);
        render::draw(drawing, drawing.view(), machine);
        exposure.add(machine.planes().color);
    }
    return exposure.mean();
}

/// ", 40 s left", from the second picture on.
std::string left_text(std::chrono::steady_clock::time_point begin, int drawn, int left) {
    if (drawn == 0) return {};
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    return fmt::format(", {:.0f} s left", std::ceil(spent.count() / drawn * left));
}

/// A camera that nobody gave sees the scene at all times of the film, whichever pictures are drawn.
void fit_to_film(Drawing& drawing, const scene::Film& film) {
    constexpr int poses = 17;
    scene::Bounds all;
    for (int i = 0; i < poses; ++i) {
        film.pose(drawing.scene, film.seconds * i / (poses - 1));
        const scene::Bounds box = scene::bounds(drawing.scene);
        if (box.empty) continue;
        scene::extend(all, box.low);
        scene::extend(all, box.high);
    }
    const Size size = drawing.request.size;
    drawing.scene.camera = render::with_options(scene::fit_camera(all, size.width, size.height),
                                                drawing.request.camera);
}

int first_missing(const FilmRecord& record, const FrameFiles& files,
                  std::pair<int, int> first_last) {
    int number = first_last.first;
    while (number <= first_last.second && record.has(numbered(files.picture, number))) ++number;
    return number;
}

/// The first picture to draw. From then on the record is of this film.
int begin_film(const FilmRecord& record, const FrameFiles& files, const FilmOptions& options) {
    int first = options.first_last.first;
    if (options.go_on &&
        (record.is_there() || std::filesystem::exists(numbered(files.picture, first)))) {
        record.check_same();
        first = first_missing(record, files, options.first_last);
    }
    record.write();
    return first;
}

/// "0 'walk', 1 'run' or 2"
std::string names_of(const std::vector<scene::Film>& films) {
    std::string text;
    for (std::size_t i = 0; i < films.size(); ++i) {
        const bool is_last = i + 1 == films.size();
        text += fmt::format("{}{}", i == 0 ? "" : is_last ? " or " : ", ", i);
        if (!films[i].name.empty()) text += " '" + scene::printable(films[i].name) + "'";
    }
    return text;
}

/// The film of the animation that was asked for; the first one, with a warning if there are others.
const scene::Film& chosen(const Drawing& drawing, const FilmOptions& options) {
    const std::string& animation = options.animation;
    const std::vector<scene::Film>& films = drawing.films;
    const std::string file = drawing.request.scene.string();
    if (animation.empty()) {
        if (films.size() > 1 && !options.quiet)
            print_warning(
                fmt::format("{}: has {} animations; the first is drawn; --animation takes {}", file,
                            films.size(), names_of(films)));
        return films.front();
    }
    const auto named = std::ranges::find(films, animation, &scene::Film::name);
    if (named != films.end()) return *named;
    for (std::size_t i = 0; i < films.size(); ++i)
        if (animation == std::to_string(i)) return films[i];
    throw Error(file, 0,
                fmt::format("has no animation '{}'; expected {}", scene::printable(animation),
                            names_of(films)));
}

}  // namespace

void draw_film(Drawing& drawing, const FrameFiles& files, const FilmOptions& options,
               Progress& progress, const Session& session) {
    scene::Film film = chosen(drawing, options);
    film.rate = options.rate.value_or(film.rate);
    film.shutter = options.shutter.value_or(film.shutter);
    film.instants = options.instants.value_or(film.instants);
    if (drawing.is_fitted) {
        progress.at("fitting the camera to the film");
        fit_to_film(drawing, film);
    }
    const Size size = drawing.request.size;
    const int last = options.first_last.second;
    for (int number = options.first_last.first; number <= last; ++number) {
        session.inputs.check(numbered(files.picture, number));
        if (numbered(files.picture, number) == options.video)
            throw UsageError("--video is one of the pictures; expected another name");
    }
    const FilmRecord record(files.picture, words_of_film(drawing, film, files.tone, session));
    const int first = begin_film(record, files, options);
    const auto machine = make_machine(drawing.request, drawing.profile, session);
    const auto begin = std::chrono::steady_clock::now();
    for (int number = first; number <= last; ++number) {
        progress.at(fmt::format("drawing picture {} of {}{}", number, last,
                                left_text(begin, number - first, last - number + 1)));
        const image::Picture picture =
            image::picture_of(exposed(drawing, film, number, *machine), size.width, size.height,
                              drawing.profile.color_bits);
        image::OutputSet output(session.inputs);
        image::put_picture(output.add(numbered(files.picture, number)),
                           image::toned(picture, files.tone));
        output.commit();
    }
    if (options.video.empty()) return;
    progress.at("making a video by ffmpeg");
    make_video(options.video, files.picture, options.first_last, film.rate, session);
}

}  // namespace gw::apps
