#include "apps/render/tone_options.h"

#include "apps/command/option_values.h"

#include <CLI/CLI.hpp>

namespace gw::apps {

void add_tone_options(CLI::App& command, image::Tone& tone) {
    command
        .add_option_function<std::string>(
            "--gamma",
            [&tone](const std::string& word) {
                tone.gamma = number_from("--gamma", word, 0.1, 10);
            },
            "The picture as v^(1/G) (default 1: as in the frame buffer)")
        ->type_name("G");
    command
        .add_option_function<std::string>(
            "--exposure",
            [&tone](const std::string& word) {
                tone.exposure = number_from("--exposure", word, -32, 32);
            },
            "The picture times 2^STOPS (default 0)")
        ->type_name("STOPS");
}

}  // namespace gw::apps
