#include "hiddensurface/lines/lines_svg.h"

#include <fmt/format.h>

namespace gw::hiddensurface {
namespace {

std::string path_of(const Input& input, const Line& line, const std::vector<Part>& parts) {
    const double unit = double(1 << input.subpixel_bits());
    std::string path;
    for (const auto& [from, to] : parts)
        for (const double t : {from, to}) {
            const dvec3 p = line.a + t * (line.b - line.a);
            path += fmt::format("{}{:.3f},{:.3f}", t == from ? "M" : "L", p.x / unit,
                                input.view.height - p.y / unit);
        }
    return path;
}

std::string layer(const std::string& path, const char* stroke) {
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke-linecap=\"round\" {}/>\n", path,
                       stroke);
}

}  // namespace

std::string lines_svg(const Input& input, const std::vector<Line>& lines) {
    std::string seen, hidden;
    for (const Line& line : lines) {
        seen += path_of(input, line, line.visible);
        hidden += path_of(input, line, rest_of(line.visible));
    }
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{2}\" "
               "height=\"{3}\">\n"
               "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
               input.view.width, input.view.height, 2 * input.view.width, 2 * input.view.height) +
           layer(hidden, "stroke=\"#9aa4b5\" stroke-width=\"0.25\" stroke-dasharray=\"1.5 1.5\"") +
           layer(seen, "stroke=\"black\" stroke-width=\"0.6\"") + "</svg>\n";
}

}  // namespace gw::hiddensurface
