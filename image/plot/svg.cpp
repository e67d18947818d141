// Draws a plot: frame with ticks, lines and markers, legend, title, caption.
#include "gw/error.h"
#include "image/plot/markup.h"
#include "image/plot/scale.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::plot {
namespace {

constexpr double width = 720, left = 76, right = 500, top = 40, bottom = 380, line_height = 17;
constexpr std::size_t caption_columns = 104;

/// Okabe, Ito: most colour-blind readers can distinguish them.
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#e69f00", "#56b4e9", "#000000"};
constexpr std::size_t color_count = std::size(colors);

/// With more series than colours, a repeated colour has another line.
constexpr const char* dashes[] = {"", " stroke-dasharray=\"9 3\"", " stroke-dasharray=\"2 3\""};

/// Markers around (0, 0), a different one for each series.
constexpr const char* shapes[] = {"M-3.5,0a3.5,3.5 0 1,0 7,0a3.5,3.5 0 1,0 -7,0",
                                  "M-3,-3h6v6h-6z",
                                  "M0,-4L4,3H-4z",
                                  "M0,-4.5L4.5,0L0,4.5L-4.5,0z",
                                  "M0,4L4,-3H-4z",
                                  "M-3,-3L3,3M-3,3L3,-3",
                                  "M0,-4V4M-4,0H4"};

/// The text in lines, broken at blanks.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = std::min(text.size(), text.find('\n', at));
        if (end - at > caption_columns) {
            const std::size_t blank = text.rfind(' ', at + caption_columns);
            end = blank != text.npos && blank > at ? blank : at + caption_columns;
        }
        lines.push_back(text.substr(at, end - at));
        at = end + (end < text.size() && (text[end] == ' ' || text[end] == '\n') ? 1 : 0);
    }
    return lines;
}

struct Paper {
    Scale x, y;
    double at_x(double value) const { return left + x.place(value) * (right - left); }
    double at_y(double value) const { return bottom - y.place(value) * (bottom - top); }
};

Paper paper_of(const Plot& plot) {
    std::vector<double> xs, ys;
    for (const Series& s : plot.series)
        for (const dvec2& p : s.points) {
            xs.push_back(p.x);
            ys.push_back(p.y);
        }
    return {make_scale(plot.x, xs), make_scale(plot.y, ys)};
}

std::string line(double x1, double y1, double x2, double y2, const char* color) {
    return fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\"/>\n", x1, y1,
        x2, y2, color);
}

std::string text(double x, double y, const char* attributes, const std::string& words) {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" {}>{}</text>\n", x, y, attributes,
                       escaped(words));
}

std::string ticks(const Paper& paper) {
    std::string out;
    for (const Tick& tick : paper.x.ticks) {
        const double x = paper.at_x(tick.value);
        out += line(x, top, x, bottom + 4, tick.text.empty() ? "#f2f2f2" : "#dddddd");
        if (!tick.text.empty()) out += text(x, bottom + 18, "text-anchor=\"middle\"", tick.text);
    }
    for (const Tick& tick : paper.y.ticks) {
        const double y = paper.at_y(tick.value);
        out += line(left - 4, y, right, y, tick.text.empty() ? "#f2f2f2" : "#dddddd");
        if (!tick.text.empty()) out += text(left - 8, y + 4, "text-anchor=\"end\"", tick.text);
    }
    return out;
}

std::string frame(const Plot& plot) {
    const double middle = (top + bottom) / 2;
    return fmt::format(
               "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#444444\"/>\n",
               left, top, right - left, bottom - top) +
           text((left + right) / 2, bottom + 38, "text-anchor=\"middle\"", plot.x.label) +
           text(0, 0,
                fmt::format("text-anchor=\"middle\" transform=\"translate(18,{}) rotate(-90)\"",
                            middle)
                    .c_str(),
                plot.y.label) +
           text(left, 24, "font-size=\"15\" font-weight=\"bold\"", plot.title);
}

std::string stroke_of(const Series& series, std::size_t index) {
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}",
                       colors[index % color_count],
                       series.dashed ? " stroke-dasharray=\"5 4\""
                                     : dashes[index / color_count % std::size(dashes)]);
}

std::string marker(double x, double y, std::size_t index, const std::string& title) {
    // A repeated colour has another shape.
    const std::size_t shape = (index + index / color_count) % std::size(shapes);
    const char* color = colors[index % color_count];
    return fmt::format(
               "<path transform=\"translate({:.2f},{:.2f})\" d=\"{}\" fill=\"{}\" stroke=\"{}\">",
               x, y, shapes[shape], color, color) +
           (title.empty() ? "" : "<title>" + escaped(title) + "</title>") + "</path>\n";
}

std::string drawn(const Series& series, std::size_t index, const Paper& paper) {
    std::string points, markers;
    index = series.style.value_or(index);
    for (const dvec2& p : series.points) {
        const double x = paper.at_x(p.x), y = paper.at_y(p.y);
        points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : " ", x, y);
        if (series.markers)
            markers +=
                marker(x, y, index, fmt::format("{}: {:.6g}, {:.6g}", series.name, p.x, p.y));
    }
    if (!series.line) return markers;
    return fmt::format("<polyline points=\"{}\" {}/>\n", points, stroke_of(series, index)) +
           markers;
}

std::string legend(const std::vector<Series>& all) {
    std::string out;
    double y = top + 10;
    for (std::size_t i = 0; i < all.size(); ++i, y += line_height + 4) {
        const std::size_t style = all[i].style.value_or(i);
        if (all[i].line)
            out += fmt::format("<path d=\"M{},{}h24\" {}/>\n", right + 12, y,
                               stroke_of(all[i], style));
        if (all[i].markers) out += marker(right + 24, y, style, "");
        out += text(right + 42, y + 4, "", all[i].name);
    }
    return out;
}

}  // namespace

std::string svg(const Plot& plot) {
    const Paper paper = paper_of(plot);
    std::string below;
    double y = std::max(bottom + 64, top + 24 + double(plot.series.size()) * (line_height + 4));
    for (const std::string& words : lines_of(plot.caption))
        below += text(12, y, "", words), y += line_height;
    for (const std::string& words : lines_of(plot.command))
        below += text(12, y, "font-family=\"monospace\" font-size=\"11\"", words), y += line_height;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        width, y);
    if (!plot.command.empty())
        out += "<desc class=\"command\">" + escaped(plot.command) + "</desc>\n";
    out += ticks(paper) + frame(plot);
    for (std::size_t i = 0; i < plot.series.size(); ++i) out += drawn(plot.series[i], i, paper);
    return out + legend(plot.series) + below + "</svg>\n";
}

}  // namespace gw::plot
