#include "hiddensurface/run/pieces_svg.h"

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

/// All parts in one: where one is in another, it is a hole.
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

/// Even ones to the right of the middle: two middles may be one point.
std::string number(const Loop& loop, const Paper& paper, std::size_t n) {
    dvec3 middle(0);
    for (const dvec3& p : loop) middle += p / double(loop.size());
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"8\" text-anchor=\"middle\" "
        "stroke=\"white\" stroke-width=\"2\" paint-order=\"stroke\">{}</text>\n",
        middle.x / paper.unit + (n % 2 == 0 ? 4 : -4), paper.height - middle.y / paper.unit, n);
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
    // Above all pieces, or later ones hide them; more could not be read.
    constexpr std::size_t most = 99;
    for (std::size_t i = 0; i < pieces.size() && pieces.size() <= most; ++i)
        if (!pieces[i].parts.empty()) svg += number(pieces[i].parts.front(), paper, i + 1);
    return svg + "</svg>\n";
}

}  // namespace gw::hiddensurface
