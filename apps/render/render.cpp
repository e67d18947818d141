// gw render: draws a picture of a scene, and on request its components, planes, manifest, counters.
#include "apps/command/command.h"
#include "apps/command/peak_memory.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "apps/render/film.h"
#include "apps/render/frame_files.h"
#include "apps/render/part_file.h"
#include "apps/render/request_words.h"
#include "apps/render/tone_options.h"
#include "apps/render/video.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/write.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <utility>

namespace gw::apps {
namespace {

/// Number first .. last of `pictures`, as IMAGE_001 ...; each is finished before the next is begun.
/// Throws Error.
void draw_turntable(Drawing& drawing, const FrameFiles& files, int pictures,
                    std::pair<int, int> first_last, Progress& progress, const Session& session) {
    const Size size = drawing.request.size;
    const scene::Camera camera = *drawing.scene.camera;
    const auto machine = make_machine(drawing.request, drawing.profile, session);
    const auto draw_view = render::view_drawer(drawing, *machine);
    const auto [first, last] = first_last;
    for (int number = first; number <= last; ++number)
        session.inputs.check(numbered(files.picture, number));
    for (int number = first; number <= last; ++number) {
        progress.at(fmt::format("drawing picture {} of {}", number, pictures));
        drawing.scene.camera = scene::turntable(camera, 360.0 * (number - 1) / pictures);
        draw_view(drawing.view());
        image::OutputSet output(session.inputs);
        const image::Picture picture = image::picture_of(machine->planes().color, size.width,
                                                         size.height, drawing.profile.color_bits);
        image::put_picture(output.add(numbered(files.picture, number)),
                           image::toned(picture, files.tone));
        output.commit();
    }
}

/// The rows of one part of a picture that several processes draw. Throws UsageError if the picture has
/// fewer rows than parts, Error if the file cannot be written.
void draw_part(const Drawing& drawing, const Share& share, const std::filesystem::path& file,
               const Session& session) {
    const render::Size size = drawing.request.size;
    if (share.of > size.height)
        throw UsageError(
            fmt::format("--part {}: the picture has {} rows; expected at most as many parts",
                        to_string(share), size.height));
    scene::View view = drawing.view();
    const scene::Rows rows = rows_of(share, size.height);
    view.only_rows = rows;
    const auto machine = make_machine(drawing.request, drawing.profile, session);
    render::draw(drawing, view, *machine);
    const std::vector<Rgba>& color = machine->planes().color;
    const auto row = [&](int y) { return color.begin() + std::ptrdiff_t(view.index(0, y)); };
    const Part part{.file = file,
                    .version = version(),
                    .scene = digest_of_files(session.inputs.names()),
                    .share = share,
                    .size = size,
                    .bits = drawing.profile.color_bits,
                    .options = words_of(drawing.request),
                    .color = {row(rows.first), row(rows.end)}};
    image::OutputSet output(session.inputs);
    output.add(file).write_text(encode(part));
    output.commit();
}

constexpr int most_film_pictures = 99999;

struct RenderOptions {
    PictureOptions picture;
    FrameFiles files;
    int turntable = 0;     ///< pictures; 0: none
    std::string frames{};  ///< "A-B": only these pictures of the turntable
    std::string film{};    ///< "A-B": these pictures of the film; empty: none
    std::string part{};    ///< "I/N": only this part of the picture; empty: all of it
    FilmOptions film_options{};
    bool memory = false;  ///< prints peak memory
};

void add_film_options(CLI::App& command, RenderOptions& options) {
    FilmOptions& film = options.film_options;
    command
        .add_option("--film", options.film,
                    "Pictures A to B of a scene that changes with time, as IMAGE_001 ...")
        ->type_name("A-B");
    command
        .add_option("--animation", film.animation,
                    "Which of glTF's animations is the film (default: the first, 0)")
        ->type_name("NAME|N");
    const auto add_number = [&](const char* name, std::optional<double>& field, double low,
                                double high, const char* about) {
        command
            .add_option_function<std::string>(
                name,
                [&field, name, low, high](const std::string& word) {
                    field = number_from(name, word, low, high);
                },
                about)
            ->type_name("N");
    };
    add_number("--rate", film.rate, 0.001, 1000,
               "Pictures a second of the film (default: the scene's, 24)");
    add_number("--shutter", film.shutter, 0, 1,
               "How long the shutter is open, of the time of a picture (default: the scene's, 0)");
    command
        .add_option_function<std::string>(
            "--instants",
            [&film](const std::string& word) {
                film.instants = whole_number_from("--instants", word, 1, 256);
            },
            "Pictures superposed while the shutter is open (default: the scene's, 8)")
        ->type_name("N");
    command.add_flag("--continue", film.go_on,
                     "Begin the film at its first picture that is missing");
    command
        .add_option(
            "--video", film.video,
            "Also make a video of the pictures, by ffmpeg: .mp4, .mkv, .webm, .mov, .avi, .gif")
        ->type_name("FILE");
}

void add_options(CLI::App& command, RenderOptions& options) {
    add_picture_options(command, options.picture);
    command
        .add_option("-o,--output", options.files.picture,
                    "The picture: .png, .exr, .tif or any other format that OpenImageIO writes")
        ->required()
        ->type_name("IMAGE");
    command
        .add_option_function<std::string>(
            "--turntable",
            [&](const std::string& word) {
                options.turntable = whole_number_from("--turntable", word, 1, 9999);
            },
            "N pictures IMAGE_001 ... around the scene")
        ->type_name("N");
    command
        .add_option("--frames", options.frames,
                    "Only pictures A to B of the turntable, so that several processes can share it")
        ->type_name("A-B");
    add_film_options(command, options);
    command
        .add_option(
            "--part", options.part,
            "Only part I of N of the picture, as FILE.part: gw join makes the picture of all")
        ->type_name("I/N");
    command
        .add_option("--components", options.files.components,
                    "Also write a picture of each component, and their sum")
        ->type_name("DIR");
    command
        .add_option(
            "--planes", options.files.planes,
            "Also write Z, stencil, identifiers, accumulation: values as EXR, false colours as PNG")
        ->type_name("DIR");
    command
        .add_option("--manifest", options.files.manifest,
                    "Also write counters and digests of every pass, as JSON")
        ->type_name("FILE");
    command
        .add_option("--counters", options.files.counters,
                    "Also write each pass's runs and counters, as JSON")
        ->type_name("FILE");
    add_tone_options(command, options.files.tone);
    command.add_flag("--memory", options.memory, "Print the peak memory");
}

void check_different(const FrameFiles& files) {
    const std::pair<const char*, const std::filesystem::path&> all[] = {
        {"--output", files.picture},
        {"--manifest", files.manifest},
        {"--counters", files.counters}};
    for (auto a = std::begin(all); a != std::end(all); ++a)
        for (auto b = std::begin(all); b != a; ++b)
            if (!a->second.empty() && a->second == b->second)
                throw UsageError(
                    fmt::format("{} and {} are the same file; expected two", a->first, b->first));
}

/// The first and the last picture of the turntable to draw, from 1.
std::pair<int, int> frames_of(const RenderOptions& options) {
    if (options.frames.empty()) return {1, options.turntable};
    return range_from("--frames", options.frames, 1, options.turntable);
}

void check_film(const RenderOptions& options) {
    const FilmOptions& film = options.film_options;
    const bool needs_film = film.rate || film.shutter || film.instants || film.go_on ||
                            !film.animation.empty() || !film.video.empty();
    if (options.film.empty() && needs_film)
        throw UsageError(
            "--animation, --rate, --shutter, --instants, --continue or --video without --film; "
            "expected it");
    if (options.film.empty()) return;
    if (options.turntable > 0) throw UsageError("--film with --turntable; expected one of them");
    range_from("--film", options.film, 1, most_film_pictures);
    if (!film.video.empty()) check_video(film.video);
}

void check_part(const RenderOptions& options) {
    share_from("--part", options.part);
    const FrameFiles& files = options.files;
    if (files.tone != image::Tone{})
        throw UsageError("--gamma or --exposure with --part; expected them with gw join");
    if (options.turntable > 0 || !options.film.empty())
        throw UsageError("--part with --turntable or --film; expected one picture, or --frames");
    if (files.picture.extension() != ".part")
        throw UsageError("--part writes no picture: --output '" + files.picture.string() +
                         "'; expected FILE.part");
    image::check_target(files.picture);
}

// Wrong words are a UsageError. Finds files that cannot be written before long work.
void check(const RenderOptions& options) {
    if (!options.frames.empty() && options.turntable == 0)
        throw UsageError("--frames without --turntable; expected both, or neither for one picture");
    if (options.turntable > 0) frames_of(options);
    check_film(options);
    const FrameFiles& files = options.files;
    if (options.part.empty())
        check_picture_target(files.picture);
    else
        check_part(options);
    const bool more_files = !files.components.empty() || !files.planes.empty() ||
                            !files.manifest.empty() || !files.counters.empty();
    const bool one_picture = options.turntable == 0 && options.film.empty() && options.part.empty();
    if (!one_picture && more_files) {
        throw UsageError(
            "--turntable, --film and --part cannot go with --components, --planes, --manifest or "
            "--counters; expected one whole picture for these");
    }
    check_different(files);
    if (!files.components.empty() && !render::renderer_named(options.picture.renderer).pass_owner) {
        throw UsageError("--components: renderer " + options.picture.renderer +
                         " has none; expected hardware or multipass");
    }
    for (const auto& file : {files.manifest, files.counters})
        if (!file.empty()) image::check_target(file);
}

int render(const RenderOptions& options, Session& session) {
    check(options);
    Progress progress("reading", options.picture.quiet);
    Drawing drawing = make_drawing(options.picture, session);
    for (const auto& file : {options.files.picture, options.files.manifest, options.files.counters})
        session.inputs.check(file);
    progress.at("drawing");
    if (!options.film.empty()) {
        FilmOptions film = options.film_options;
        film.quiet = options.picture.quiet;
        film.first_last = range_from("--film", options.film, 1, most_film_pictures);
        if (drawing.films.empty())
            throw Error(options.picture.scene.string(), 0,
                        "is no film; expected a scene with [[track]], or glTF with animations");
        draw_film(drawing, options.files, film, progress, session);
    } else if (options.turntable > 0) {
        draw_turntable(drawing, options.files, options.turntable, frames_of(options), progress,
                       session);
    } else if (!options.part.empty()) {
        draw_part(drawing, share_from("--part", options.part), options.files.picture, session);
    } else {
        draw_frame(drawing, options.files, session, options.picture.quiet);
    }
    if (options.memory) fmt::print("peak memory: {} MB\n", peak_memory() >> 20);
    return Done;
}

}  // namespace

Command add_render(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "A picture of a scene");
    const auto options = std::make_shared<RenderOptions>();
    add_options(*command, *options);
    command->footer("Example:\n  build/release/bin/gw render scenes/rings.toml -o rings.png");
    return {command, [options](Session& session) { return render(*options, session); }};
}

}  // namespace gw::apps
