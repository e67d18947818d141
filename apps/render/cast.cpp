// gw cast: ray casting as it is taught, by a chosen method, with its costs. [L9 to L12]
#include "apps/command/command.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/plane_pictures.h"
#include "image/write.h"
#include "raytrace/casting/cast_picture.h"
#include "render/words/option_words.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace gw::apps {
namespace {

using raytrace::CastMethod;
using raytrace::InsideTest;

struct CastOptions {
    PictureOptions picture{{.size = {320, 240}}};
    CastMethod method = CastMethod::Hierarchy;
    InsideTest inside = InsideTest::Crossings;
    std::filesystem::path output, tests;
};

/// Adds an option whose words are those of a table.
template <class Table, class Value>
void add_choice(CLI::App& command, const std::string& name, const Table& table, Value& value,
                const std::string& help) {
    command
        .add_option_function<std::string>(
            name,
            [name, &table, &value](const std::string& word) {
                value = render::value_from(name, word, table);
            },
            help)
        ->type_name("NAME");
}

std::string counts_table(const raytrace::CastPicture& picture, std::size_t shapes) {
    const raytrace::CastCounts& c = picture.counts;
    const auto row = [&](const char* name, std::uint64_t n) {
        return std::vector<std::string>{name, std::to_string(n),
                                        fmt::format("{:.2f}", double(n) / double(c.rays))};
    };
    return table({{"", "all", "of a ray"},
                  row("rays", c.rays),
                  row("tests of shapes", c.shapes),
                  row("tests of boxes", c.boxes),
                  row("voxels", c.voxels),
                  {"shapes in the scene", std::to_string(shapes), ""}});
}

int cast(const CastOptions& options, Session& session) {
    check_picture_target(options.output);
    if (!options.tests.empty()) check_picture_target(options.tests);
    if (options.output == options.tests)
        throw UsageError("--output and --tests are the same file; expected two");
    const Progress progress("casting", options.picture.quiet);
    const scene::Scene scene = load_scene(
        options.picture, session,
        {scene::DrawnBy::Rays,
         {"shadows", "reflections", "maps", "translucency", "fog", "glare", "motion", "aperture"}});
    session.inputs.check(options.output);
    session.inputs.check(options.tests);
    const Size size = options.picture.size;
    const auto shapes = raytrace::cast_shapes(scene);
    const auto caster = raytrace::make_caster(options.method, shapes, options.inside);
    const auto picture = raytrace::cast_picture(*caster, shapes, scene,
                                                scene::make_view(scene, size.width, size.height),
                                                options.picture.threads);
    if (!options.picture.quiet) print_warnings({scene::empty_picture(scene, picture.color, 8)});
    image::OutputSet output(session.inputs);
    image::put_picture(output.add(options.output),
                       image::picture_of(picture.color, size.width, size.height, 8));
    if (!options.tests.empty())
        image::put_picture(output.add(options.tests),
                           image::amount_picture(picture.tests, size.width, size.height));
    output.commit();
    print(counts_table(picture, shapes.size()));
    return Done;
}

}  // namespace

Command add_cast(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "cast", "Ray casting as it is taught: methods, inside tests, their counts");
    const auto options = std::make_shared<CastOptions>();
    add_picture_options(*command, options->picture);
    remove_pass_options(*command);
    for (const char* unused : {"--machine", "--profile"})
        command->remove_option(command->get_option(unused));
    command->get_option("--size")->description("Pixels, both sides 1..4096 (default 320x240)");
    command->get_option("--threads")->description("Threads that share the rows (default: all)");
    add_choice(
        *command, "--method", render::cast_method_words, options->method,
        "The search for the nearest shape: brute-force, volumes, hierarchy (default) or grid");
    add_choice(*command, "--inside", render::inside_test_words, options->inside,
               "Ray and polygon: crossings (default), products or angles; "
               "they differ on concave polygons");
    command->add_option("-o,--output", options->output, "The picture")
        ->required()
        ->type_name("IMAGE");
    command
        ->add_option("--tests", options->tests,
                     "Also a picture of the tests that each pixel cost, the costliest white")
        ->type_name("IMAGE");
    command->footer(
        "Example:\n"
        "  build/release/bin/gw cast scenes/hidden/solids.toml --method grid -o cast.png --tests "
        "tests.png");
    return {command, [options](Session& session) { return cast(*options, session); }};
}

}  // namespace gw::apps
