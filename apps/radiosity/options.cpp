#include "apps/radiosity/options.h"

#include "apps/command/command.h"

#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

template <class Number>
void add_whole(CLI::App& command, const char* name, Number& to, int low, int high,
               const char* help) {
    command
        .add_option_function<std::string>(
            name,
            [=, &to](const std::string& word) {
                to = static_cast<Number>(whole_number_from(name, word, low, high));
            },
            help)
        ->type_name("N");
}

void add_number(CLI::App& command, const char* name, double& to, double low, double high,
                const char* type, const char* help) {
    command
        .add_option_function<std::string>(
            name, [=, &to](const std::string& word) { to = number_from(name, word, low, high); },
            help)
        ->type_name(type);
}

// "EX,EY,EZ/AX,AY,AZ"
std::pair<dvec3, dvec3> view_from(const std::string& word) {
    const std::size_t bar = word.find('/');
    if (bar == word.npos)
        throw UsageError("--view '" + word +
                         "': expected EX,EY,EZ/AX,AY,AZ, the eye and the point it looks at");
    const std::pair view{point_from("--view", word.substr(0, bar)),
                         point_from("--view", word.substr(bar + 1))};
    if (view.first == view.second)
        throw UsageError("--view '" + word + "': eye and at are the same point; expected two");
    return view;
}

void add_computation(CLI::App& command, RadiosityOptions& o) {
    add_whole(command, "--shots", o.shots, 0, 1000000000,
              "Shots in all (default: as many as --until takes)");
    add_number(command, "--until", o.until, 1e-9, 1, "SHARE",
               "Go on until this share of the emitted energy is unshot (default 0.0001)");
    command
        .add_option_function<std::string>(
            "--hemicube",
            [&o](const std::string& word) {
                const int size = whole_number_from("--hemicube", word, 8, max_window_size);
                if (size % 2 != 0)
                    throw UsageError("--hemicube '" + word + "': expected an even number, 8..4096");
                o.solver.form_factors.hemicube = size;
            },
            "Pixels across a hemicube, even (default 128)")
        ->type_name("N");
    add_number(command, "--texels", o.model.texels_per_unit, 1e-9, 1e9, "T",
               "Texels per unit length (default: the scene's)");
    add_whole(command, "--patch", o.model.patch, 1, 64,
              "A patch is a block of NxN texels (default 4)");
    add_whole(
        command, "--parts", o.solver.form_factors.scan.most_parts, 1, 1024,
        "Oversampling: a pixel is divided into at most N parts each way; 1: never (default 64)");
    add_whole(command, "--seed", o.solver.form_factors.seed, 0, 2147483647,
              "Seed for the turns of the hemicubes (default 0)");
}

void add_saving(CLI::App& command, RadiosityOptions& o) {
    command.add_flag("--save", o.save,
                     "Save the pixmaps in DIR/pixmaps.exr, every few seconds and at the end");
    command.add_flag("--resume", o.resume, "Go on from DIR/pixmaps.exr");
    command
        .add_option_function<std::string>(
            "--rank", [&o](const std::string& word) { o.rank = rank_from(word); },
            "Process I of N that solve together, with the bits of one; mpi: as mpirun or srun say. "
            "The first one writes")
        ->type_name("I/N");
    command.add_flag(
        "--record", o.record,
        "Also DIR/hemicubes.gwt and DIR/pictures.gwt, for gw replay, verify, pixel; on one thread");
}

/// Questions about the solved scene.
void add_questions(CLI::App& command, RadiosityOptions& o) {
    command
        .add_option_function<std::vector<std::string>>(
            "--change",
            [&o](const std::vector<std::string>& words) {
                for (const std::string& word : words) o.changes.push_back(change_from(word));
            },
            "Then change an object and shoot the difference: emission=R,G,B, dim=FACTOR, Kd=R,G,B "
            "or move=X,Y,Z. May be repeated; the picture is DIR/changed.png")
        ->type_name("NAME:WHAT=VALUE");
    command.add_flag("--anew", o.anew,
                     "With --change: also solve the changed scene anew, to compare");
    command.add_flag("--shares", o.shares,
                     "Also keep the light of each lamp apart, in DIR/share_1.exr ..., for --mix");
    command
        .add_option_function<std::vector<std::string>>(
            "--mix",
            [&o](const std::vector<std::string>& words) {
                for (const std::string& word : words) o.mix.push_back(strength_from(word));
            },
            "Solve nothing: show the shares of DIR, this lamp F or R,G,B times as strong, others as "
            "they are. May be repeated; the picture is DIR/mixed.png")
        ->type_name("LAMP=F");
    command
        .add_option("--form-factor", o.form_factor,
                    "Only print the form factors between two figures")
        ->expected(2)
        ->type_name("A B");
}

void add_display(CLI::App& command, RadiosityOptions& o) {
    command
        .add_option_function<std::string>(
            "--display",
            [&o](const std::string& word) {
                o.display = one_of("--display", word, {"texture", "strips", "both"});
            },
            "Pixmaps as textures (default), as Gouraud strips, or both with their difference")
        ->type_name("NAME");
    command
        .add_option_function<std::vector<std::string>>(
            "--view",
            [&o](const std::vector<std::string>& words) {
                for (const std::string& word : words) o.views.push_back(view_from(word));
            },
            "A view instead of the camera's: the eye and the point it looks at. May be repeated; "
            "nothing is solved again")
        ->type_name("EYE/AT");
    command.add_flag("--units", o.units,
                     "Also each view in radiosity units, NAME_units.exr, and in false colours, "
                     "NAME_false.png, with their scale");
    command.add_flag("--lux", o.lux,
                     "Also the illuminance in each view, NAME_lux.exr, and in false colours, "
                     "NAME_lux.png, with their scale");
    command
        .add_option_function<std::vector<std::string>>(
            "--lux-at",
            [&o](const std::vector<std::string>& words) {
                for (const std::string& word : words)
                    o.lux_at.push_back(point_from("--lux-at", word));
            },
            "Print the illuminance of the surface nearest to this point. May be repeated")
        ->type_name("X,Y,Z");
    command.add_flag("--lightmaps", o.light_maps,
                     "Also the pixmaps for other programs: DIR/light_maps.gltf with its textures");
    add_number(command, "--rgbm", o.rgbm, 1, 1000, "RANGE",
               "With --lightmaps: also RGBM, light_map_1_rgbm.png ..., up to RANGE times white");
    add_whole(command, "--every", o.every, 1, 1000000000, "Also a picture after each N shots");
    command.add_flag("--no-ambient", o.no_ambient, "Do not show the estimate of unshot light");
    command.add_flag(
        "--specular", o.specular,
        "Add the specular and reflection passes, and rays for materials that ask for them");
    add_number(command, "--exposure", o.exposure, -32, 32, "STOPS",
               "Radiosity times 2^STOPS, by the scene's white if it has one (default 0)");
    add_number(command, "--gamma", o.gamma, 0.1, 10, "G", "The picture as v^(1/G) (default 1)");
}

constexpr const char* expected =
    "expected NAME:emission=R,G,B, NAME:dim=FACTOR, NAME:Kd=R,G,B or NAME:move=X,Y,Z";

/// --mix only reads shares.
void check_mix(const RadiosityOptions& o) {
    if (o.mix.empty()) return;
    if (o.shares || o.save || o.resume || o.record || o.anew || o.every > 0 || o.shots >= 0 ||
        !o.changes.empty() || !o.form_factor.empty())
        throw UsageError(
            "--mix solves nothing; expected it without --shares, --save, --resume, --record, "
            "--shots, --every, --change and --form-factor");
    for (std::size_t i = 0; i < o.mix.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (o.mix[i].lamp == o.mix[k].lamp)
                throw UsageError("--mix: '" + o.mix[i].lamp +
                                 "' has two factors; expected one for each lamp");
}

void check_range(const std::string& word, const dvec3& v, double high) {
    for (int c = 0; c < 3; ++c)
        if (!(v[c] >= 0 && v[c] <= high))
            throw UsageError("--change '" + word + "': expected numbers of 0 " +
                             (high == 1 ? "to 1" : "and more"));
}

}  // namespace

void add_radiosity_options(CLI::App& command, RadiosityOptions& options) {
    add_picture_options(command, options.picture);
    for (const char* option : {"--renderer", "--samples"})
        command.remove_option(command.get_option(option));
    command.get_option("--size")->description(
        "Pixels of a picture, both sides 1..4096 (default 512x512)");
    command.get_option("--profile")
        ->description(
            "vgx, reality, ideal, opengl or a TOML file (default ideal), of the pictures");
    command
        .add_option("-o,--output", options.output,
                    "The folder for pictures, pixmaps and the report")
        ->type_name("DIR");
    add_computation(command, options);
    add_saving(command, options);
    add_questions(command, options);
    add_display(command, options);
}

void check(const RadiosityOptions& options) {
    if (options.form_factor.empty() && options.output.empty())
        throw UsageError("--output is missing; expected -o DIR, or --form-factor A B");
    if (!options.form_factor.empty() && (options.save || options.resume || options.record ||
                                         options.light_maps || !options.output.empty()))
        throw UsageError(
            "--form-factor computes no picture; expected it without --output, --save, "
            "--resume, --record and --lightmaps");
    if (options.shares && !options.changes.empty())
        throw UsageError("--change does not keep shares; expected --shares without it");
    if (options.shares && !options.form_factor.empty())
        throw UsageError("--form-factor solves nothing; expected it without --shares");
    check_mix(options);
    if (options.rank.count > 1 &&
        (options.record || options.anew || !options.mix.empty() || !options.form_factor.empty()))
        throw UsageError(
            "--rank shares shots; expected it without --record, --anew, --mix and --form-factor");
    if (options.rgbm > 0 && !options.light_maps)
        throw UsageError("--rgbm is a form of light maps; expected --lightmaps beside it");
    if (options.specular && options.display != "texture")
        throw UsageError("--specular draws pixmaps as textures; expected no --display beside it");
    if (!options.changes.empty() && options.save)
        throw UsageError(
            "--change: the pixmaps of the changed scene are not saved; expected no --save");
    if (options.anew && options.changes.empty())
        throw UsageError("--anew compares with a changed scene; expected --change beside it");
    if (!options.changes.empty() && !options.form_factor.empty())
        throw UsageError("--form-factor computes no picture; expected it without --change");
    const bool own_camera = options.picture.camera.eye || options.picture.camera.at;
    if (own_camera && !options.views.empty())
        throw UsageError("--view cannot go with --eye or --at; expected one of them");
}

Strength strength_from(const std::string& word) {
    const std::size_t equals = word.rfind('=');
    if (equals == word.npos || equals == 0)
        throw UsageError("--mix '" + word + "': expected LAMP=FACTOR or LAMP=R,G,B");
    const std::string value = word.substr(equals + 1), name = "--mix " + word.substr(0, equals);
    Strength strength{word.substr(0, equals)};
    if (value.find(',') == value.npos)
        strength.factor = dvec3(number_from(name, value, 0, 1e9));
    else
        strength.factor = point_from(name, value);
    for (int c = 0; c < 3; ++c)
        if (!(strength.factor[c] >= 0 && strength.factor[c] <= 1e9))
            throw UsageError("--mix '" + word + "': expected numbers of 0 to 1e9");
    return strength;
}

Change change_from(const std::string& word) {
    const std::size_t equals = word.rfind('='), colon = word.rfind(':', equals);
    if (equals == word.npos || colon == word.npos || colon == 0)
        throw UsageError("--change '" + word + "': " + expected);
    Change change{word.substr(0, colon), word.substr(colon + 1, equals - colon - 1)};
    const std::string value = word.substr(equals + 1);
    if (change.what == "dim")
        change.value = dvec3(number_from("--change dim", value, 0, 1e9));
    else if (change.what == "emission" || change.what == "Kd" || change.what == "move")
        change.value = point_from("--change " + change.what, value);
    else
        throw UsageError("--change '" + word + "': " + expected);
    if (change.what != "move") check_range(word, change.value, change.what == "Kd" ? 1 : 1e30);
    return change;
}

}  // namespace gw::apps
