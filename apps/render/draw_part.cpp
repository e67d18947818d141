#include "apps/render/draw_part.h"

#include "apps/render/request_words.h"
#include "gw/error.h"
#include "image/output/output_set.h"

#include <fmt/format.h>

namespace gw::apps {

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
