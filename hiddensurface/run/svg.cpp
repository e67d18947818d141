#include "hiddensurface/run/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
std::string area(const std::vector<Loop>& parts, const Paper& paper, const std::string& color) {
    std::string path;
    for (const Loop& loop : parts) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            path += (i == 0 ? "M" : " L") + paper.at(loop[i]);
        path += "Z";
    }
    return fmt::format("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"none\"/>\n", path,
                       color);
}

/// Between these ends is one side.
bool are_near(const dvec3& a, const dvec3& b) {
    return std::abs(a.x - b.x) < 1e-6 && std::abs(a.y - b.y) < 1e-6;
}

/// The sides but those at which two convex parts of the piece meet.
std::string outline(const std::vector<Loop>& parts, const Paper& paper) {
    std::vector<std::pair<dvec3, dvec3>> sides;
    for (const Loop& loop : parts)
        for (std::size_t i = 0; i < loop.size(); ++i)
            sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    std::string path;
    for (const auto& [a, b] : sides) {
        const dvec3 &from = a, &to = b;
        const bool is_inner = std::any_of(sides.begin(), sides.end(), [&](const auto& other) {
            return are_near(other.first, to) && are_near(other.second, from);
        });
        if (!is_inner) path += "M" + paper.at(a) + " L" + paper.at(b);
    }
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"black\" stroke-width=\"0.5\" "
        "stroke-linecap=\"round\"/>\n",
        path);
}

/// Twice the area, and the centroid.
std::pair<double, dvec2> centroid_of(const Loop& loop) {
    double area = 0;
    dvec2 sum(0), mean(0);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const dvec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        const double part = a.x * b.y - b.x * a.y;
        area += part;
        sum += part * dvec2(a.x + b.x, a.y + b.y);
        mean += dvec2(a.x, a.y) / double(loop.size());
    }
    return {std::abs(area), area == 0 ? mean : sum / (3 * area)};
}

/// Places of the pieces' numbers: in the largest part of each, and below the number that has the
/// place already.
class NumberPlaces {
public:
    explicit NumberPlaces(const Paper& paper) : paper_(paper) {}

    dvec2 next(const std::vector<Loop>& parts) {
        std::pair<double, dvec2> best{-1, dvec2(0)};
        for (const Loop& loop : parts)
            if (const auto one = centroid_of(loop); one.first > best.first) best = one;
        dvec2 at(best.second.x / paper_.unit, paper_.height - best.second.y / paper_.unit);
        while (std::any_of(taken_.begin(), taken_.end(), [&](const dvec2& p) {
            return std::abs(p.x - at.x) < letter && std::abs(p.y - at.y) < letter;
        }))
            at.y += letter;
        taken_.push_back(at);
        return at;
    }

    static constexpr double letter = 8;

private:
    Paper paper_;
    std::vector<dvec2> taken_;
};

std::string number(const dvec2& at, std::size_t n) {
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\" text-anchor=\"middle\" "
        "stroke=\"white\" stroke-width=\"2\" paint-order=\"stroke\">{}</text>\n",
        at.x, at.y, NumberPlaces::letter, n);
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
        svg += area(pieces[i].parts, paper, colors[pieces[i].polygon]) +
               outline(pieces[i].parts, paper) + "</g>\n";
    }
    // Numbers come after all pieces, which would hide them. More than 99 could not be read.
    constexpr std::size_t most = 99;
    NumberPlaces places(paper);
    for (std::size_t i = 0; i < pieces.size() && pieces.size() <= most; ++i)
        if (!pieces[i].parts.empty()) svg += number(places.next(pieces[i].parts), i + 1);
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
