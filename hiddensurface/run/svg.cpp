#include "hiddensurface/run/svg.h"

#include <fmt/format.h>

namespace gw::hiddensurface {
namespace {

/// Grid units to pixels, y down.
struct Paper {
    double unit;
    int height;
    std::string at(const dvec3& p) const {
        return fmt::format("{:.3f},{:.3f}", p.x / unit, height - p.y / unit);
    }
};

/// All parts as one path: a part inside another is a hole.
std::string outline(const std::vector<Loop>& parts, const Paper& paper, const std::string& color) {
    std::string path;
    for (const Loop& loop : parts) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            path += (i == 0 ? "M" : " L") + paper.at(loop[i]);
        path += "Z";
    }
    return fmt::format(
        "<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"black\" stroke-width=\"0.5\"/>\n",
        path, color);
}

/// Even numbers stand to the right of the middle, odd ones to the left: two middles may coincide.
std::string number(const Loop& loop, const Paper& paper, std::size_t n) {
    dvec3 middle(0);
    for (const dvec3& p : loop) middle += p / double(loop.size());
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"8\" text-anchor=\"middle\" "
        "stroke=\"white\" stroke-width=\"2\" paint-order=\"stroke\">{}</text>\n",
        middle.x / paper.unit + (n % 2 == 0 ? 4 : -4), paper.height - middle.y / paper.unit, n);
}

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

std::string pieces_svg(const Input& input, const std::vector<Piece>& pieces,
                       const std::vector<std::string>& colors) {
    const Paper paper{double(1 << input.subpixel_bits()), input.view.height};
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{2}\" height=\"{3}\" "
        "font-family=\"sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        input.view.width, input.view.height, 2 * input.view.width, 2 * input.view.height);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::string id =
            fmt::format("piece {} of polygon {}", i + 1, input.polygons[pieces[i].polygon].id);
        svg += "<g fill-opacity=\"0.8\"><title>" + id + "</title>\n";
        svg += outline(pieces[i].parts, paper, colors[pieces[i].polygon]) + "</g>\n";
    }
    // Numbers come after all pieces, which would hide them. More than 99 could not be read.
    constexpr std::size_t most = 99;
    for (std::size_t i = 0; i < pieces.size() && pieces.size() <= most; ++i)
        if (!pieces[i].parts.empty()) svg += number(pieces[i].parts.front(), paper, i + 1);
    return svg + "</svg>\n";
}

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
