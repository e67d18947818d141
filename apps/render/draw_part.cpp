#include "apps/render/draw_part.h"

#include "gw/error.h"
#include "image/output/output_set.h"
#include "inspect/recording/content.h"
#include "render/options.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

/// Of the contents of all files, in the order in which they were read.
std::string digest_of(const std::vector<std::filesystem::path>& files) {
    std::string all;
    for (const std::filesystem::path& file : files) {
        const std::string bytes = scene::read_bytes(file);
        all += to_string(inspect::digest_of_bytes(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
    }
    return to_string(
        inspect::digest_of_bytes({reinterpret_cast<const std::uint8_t*>(all.data()), all.size()}));
}

/// Machines give the same bits, with any number of threads. The size stands in the header.
bool changes_pixels(const std::string& option) {
    return option != "threads" && option != "machine" && option != "size";
}

std::vector<std::pair<std::string, std::string>> words_of(const render::Request& request) {
    std::vector<std::pair<std::string, std::string>> words;
    for (const render::Option& option : render::options()) {
        const std::string word = option.word(request);
        if (word.empty() || !changes_pixels(option.name)) continue;
        // A file's content is in the scene's digest; its folder differs from machine to machine.
        const bool is_file = option.name == "profile" && render::is_profile_file(word);
        words.push_back({option.name, is_file ? "of a file" : word});
    }
    return words;
}

}  // namespace

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
                    .scene = digest_of(session.inputs.names()),
                    .share = share,
                    .size = size,
                    .bits = drawing.profile.color_bits,
                    .options = words_of(drawing.request),
                    .color = {row(rows.first), row(rows.end)}};
    image::OutputSet output(session.inputs);
    output.add(file).write_text(encode(part));
    output.commit();
}

}  // namespace gw::apps
