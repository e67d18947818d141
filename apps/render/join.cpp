// gw join: the parts of a picture, which several processes drew, as one picture.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/render/part_file.h"
#include "apps/render/tone_options.h"
#include "image/output/output_set.h"
#include "image/picture.h"
#include "image/write.h"
#include "scene/text/text_file.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace gw::apps {
namespace {

struct JoinOptions {
    std::vector<std::filesystem::path> parts;
    std::filesystem::path output;
    image::Tone tone;
};

int join(const JoinOptions& options, Session& session) {
    check_picture_target(options.output);
    std::vector<Part> parts;
    for (const std::filesystem::path& file : options.parts) {
        parts.push_back(decode_part(file, scene::read_bytes(file)));
        session.inputs.add(file);
    }
    const Part& first = parts.front();
    const image::Picture picture =
        image::picture_of(joined(parts), first.size.width, first.size.height, first.bits);
    image::OutputSet output(session.inputs);
    image::put_picture(output.add(options.output), image::toned(picture, options.tone));
    output.commit();
    return Done;
}

}  // namespace

Command add_join(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("join", "One picture of the parts that several processes drew");
    const auto options = std::make_shared<JoinOptions>();
    command->add_option("PARTS", options->parts, "All parts that gw render --part wrote")
        ->required()
        ->type_name("FILE...");
    command
        ->add_option("-o,--output", options->output,
                     "The picture: .png, .exr, .tif or any other format that OpenImageIO writes")
        ->required()
        ->type_name("IMAGE");
    add_tone_options(*command, options->tone);
    command->footer(
        "Example:\n"
        "  build/release/bin/gw render scenes/rings.toml --part 1/2 -o rings_1.part && "
        "build/release/bin/gw render scenes/rings.toml --part 2/2 -o rings_2.part && "
        "build/release/bin/gw join rings_1.part rings_2.part -o rings.png");
    return {command, [options](Session& session) { return join(*options, session); }};
}

}  // namespace gw::apps
