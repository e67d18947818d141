#include "inspect/testing/failure_files.h"

#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/plane_pictures.h"
#include "image/write.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/replay/plane_values.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gw::testing {
namespace {

std::string name_of_test() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = test ? std::string(test->test_suite_name()) + "." + test->name() : "no test";
    std::replace(name.begin(), name.end(), '/', '_');  // parameterised tests
    return name;
}

Plane first_plane_that_differs(const Planes& a, const Planes& b) {
    const auto found = std::ranges::find_if(
        inspect::planes_in_order, [&](Plane plane) { return !inspect::same(a, b, plane); });
    return found == inspect::planes_in_order.end() ? Plane::Color : *found;
}

std::string written(const std::filesystem::path& file, const image::Picture& picture) {
    image::write_picture(file, picture);
    return "  " + file.string() + "\n";
}

std::string write_all(const std::string& name, const std::optional<Planes>& expected,
                      const Planes& actual, const Profile& profile) {
    const Plane plane = expected ? first_plane_that_differs(*expected, actual) : Plane::Color;
    std::filesystem::create_directories(output_folder());
    const auto file = [&](const char* kind) {
        return output_folder() /
               (name_of_test() + "-" + name + "-" + name_of(plane) + "-" + kind + ".png");
    };
    std::string lines = written(file("actual"), image::plane_picture(actual, plane, profile));
    if (!expected) return lines;
    lines += written(file("expected"), image::plane_picture(*expected, plane, profile));
    return lines + written(file("difference"),
                           image::distance_picture(inspect::distances(*expected, actual, plane),
                                                   actual.width, actual.height));
}

}  // namespace

std::filesystem::path output_folder() {
    const char* folder = std::getenv("GW_TESTING_OUTPUT");
    return folder && *folder ? folder : "gw-testing";
}

std::string write_failure_pictures(const std::string& name, const std::optional<Planes>& expected,
                                   const Planes& actual, const Profile& profile) {
    try {
        return "pictures:\n" + write_all(name, expected, actual, profile);
    } catch (const std::exception& error) {  // Error, or an exception of std::filesystem
        return std::string("no pictures: ") + error.what() + "\n";
    }
}

std::string write_failure_recording(const std::string& name, const inspect::Recording& actual,
                                    const std::filesystem::path& golden,
                                    const inspect::Finding& finding) {
    try {
        std::filesystem::create_directories(output_folder());
        const std::filesystem::path base = output_folder() / (name_of_test() + "-" + name);
        const std::filesystem::path recording = base.string() + ".gwt",
                                    manifest = base.string() + ".json";
        image::OutputSet files;
        files.add(recording).write(inspect::encode(actual));
        const auto made =
            inspect::replayed_manifest_file(actual, inspect::maker_of("reference"), manifest, true);
        files.add(inspect::values_file(manifest)).write(made.values);
        files.add(manifest).write_text(to_json(made.manifest));
        files.commit();
        std::string lines = "recording:\n  gw diff " + golden.string() + " " + manifest.string();
        if (finding.pixel)
            lines += fmt::format("\n  gw pixel {} {} {}", recording.string(), finding.pixel->x,
                                 actual.height - 1 - finding.pixel->y);
        return lines + "\n";
    } catch (const std::exception& error) {
        return std::string("no recording: ") + error.what() + "\n";
    }
}

}  // namespace gw::testing
