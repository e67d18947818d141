// gw irisgl-config: how a program of IRIS GL is compiled.
#include "apps/command/command.h"
#include "apps/programs/program.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace gw::apps {
namespace {

struct IrisGlOptions {
    bool cflags = false, libs = false;
};

std::string compiler_words(const IrisGlOptions& options) {
    const bool all = !options.cflags && !options.libs;
    std::string words;
    if (options.cflags || all) {
        const std::string headers = folder_beside({"include/irisgl"}, "gl/gl.h").string();
        words = fmt::format(
            "-std=gnu99 -fgnu89-inline -fcommon -w -Wno-implicit-int "
            "-Wno-implicit-function-declaration -fno-builtin-exit -I{} -I{}/gl",
            headers, headers);
    }
    if (options.libs || all) {
        const std::string library =
            folder_beside({"lib/irisgl", GW_INSTALLED_IRISGL}, "libgl.so").string();
        words += fmt::format("{}-L{} -Wl,-rpath,{} -lgl -lm", words.empty() ? "" : " ", library,
                             library);
    }
    return words;
}

}  // namespace

Command add_irisgl_config(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "irisgl-config", "Prints the compiler's options for a program of IRIS GL");
    const auto options = std::make_shared<IrisGlOptions>();
    command->add_flag("--cflags", options->cflags, "Those of compiling");
    command->add_flag("--libs", options->libs, "Those of linking");
    command->footer("Example:\n  build/release/bin/gw irisgl-config --cflags --libs");
    return {command, [options](Session&) {
                fmt::print("{}\n", compiler_words(*options));
                return int(Done);
            }};
}

}  // namespace gw::apps
