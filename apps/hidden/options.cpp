#include "apps/hidden/options.h"

#include <CLI/CLI.hpp>

namespace gw::apps {

void add_form_options(CLI::App& command, Form& form, bool is_table) {
    CLI::Option* json = command.add_flag_callback(
        "--json", [&] { form = Form::Json; }, "The answer as JSON");
    if (!is_table) return;
    command
        .add_flag_callback(
            "--csv", [&] { form = Form::Csv; }, "The answer as comma-separated values")
        ->excludes(json);
}

void add_polygon_options(CLI::App& command, PictureOptions& picture) {
    add_picture_options(command, picture);
    remove_pass_options(command);
    command.get_option("--size")->description("Pixels, both sides 1..4096 (default 320x240)");
}

}  // namespace gw::apps
