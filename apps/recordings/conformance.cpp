// gw conformance: writes the recordings that test a machine, and the manifests it must agree with.
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/recordings/recording_files.h"
#include "conformance/suite.h"
#include "gw/escape_controls.h"
#include "image/output/output_set.h"
#include "inspect/compare/verify.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

struct ConformanceOptions {
    std::filesystem::path folder;
    std::vector<std::string> groups;
    bool values = false, list = false, quiet = false;
};

void add_options(CLI::App& command, ConformanceOptions& options) {
    command.add_option("DIR", options.folder, "The folder for the files")->type_name("DIR");
    command.add_option("--only", options.groups, "Only these groups (default: all of --list)")
        ->type_name("GROUP");
    command.add_flag("--values", options.values,
                     "Also the planes after every pass, so that gw verify names pixels");
    command.add_flag("--list", options.list, "Only print the groups and the rules they reach");
    command.add_flag("--quiet", options.quiet, "No progress");
}

std::vector<conformance::Group> chosen(const std::vector<std::string>& names) {
    if (names.empty()) return conformance::groups();
    std::vector<conformance::Group> out;
    for (const std::string& name : names) {
        const auto& all = conformance::groups();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& g) { return g.name == name; });
        if (found == all.end())
            throw UsageError("--only " + name + ": no such group; expected one of --list");
        out.push_back(*found);
    }
    return out;
}

int list_groups() {
    for (const conformance::Group& group : conformance::groups())
        print(fmt::format("{:18} {}\n{:18} {}\n", group.name, group.about, "", group.rules));
    return Done;
}

int write_suite(const ConformanceOptions& options) {
    if (options.list) return list_groups();
    if (options.folder.empty()) throw UsageError("DIR is missing; expected a folder, or --list");
    const auto groups = chosen(options.groups);
    Progress progress("writing", options.quiet);
    image::OutputSet output;
    output.make_folder(options.folder);
    int count = 0;
    for (const conformance::Group& group : groups) {
        progress.at(group.name);
        for (const conformance::Member& member : conformance::members(group)) {
            output.add(options.folder / (member.name + ".gwt"))
                .write(inspect::encode(member.recording));
            put_manifest(output, options.folder / (member.name + ".json"), member.recording,
                         inspect::maker_of("reference"), options.values);
            ++count;
        }
        output.commit();  // after each group, so that few files are open at once
    }
    print(fmt::format("{}: {} recordings and their manifests\n",
                      escape_controls(options.folder.string()), count));
    return Done;
}

}  // namespace

Command add_conformance(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "conformance", "Recordings and manifests that a foreign machine must agree with");
    const auto options = std::make_shared<ConformanceOptions>();
    add_options(*command, *options);
    command->footer(
        "Example:\n  build/release/bin/gw conformance suite --only fog && "
        "build/release/bin/gw verify suite/fog_01.gwt suite/fog_01.json");
    return {command, [options](Session&) { return write_suite(*options); }};
}

}  // namespace gw::apps
