#include "apps/hidden/pictures.h"

#include "gw/base/arithmetic.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

Color to_color(const dvec3& v) {
    const auto byte = [](double x) { return static_cast<std::uint16_t>(quantize(x, 8)); };
    return {byte(v.x), byte(v.y), byte(v.z)};
}

}  // namespace

image::Picture blank(int width, int height) {
    return {width, height, 3, 8,
            std::vector<std::uint16_t>(std::size_t(width) * std::size_t(height) * 3)};
}

void put(image::Picture& picture, std::size_t pixel, const Color& color) {
    for (std::size_t c = 0; c < 3; ++c) picture.values[pixel * 3 + c] = color[c];
}

image::Picture picture_of_ids(const hs::Input& input, const std::vector<std::uint32_t>& ids,
                              const std::map<std::uint32_t, Color>& colors) {
    image::Picture picture = blank(input.view.width, input.view.height);
    for (std::size_t i = 0; i < ids.size(); ++i) put(picture, i, colors.at(ids[i]));
    return picture;
}

image::Picture picture_of_shares(const hs::Input& input, const std::vector<hs::Share>& shares,
                                 const std::map<std::uint32_t, Color>& colors) {
    image::Picture picture = blank(input.view.width, input.view.height);
    const Color& background = colors.at(0);
    const auto count = picture.values.size() / 3;
    std::vector<dvec3> sums(count, dvec3(background[0], background[1], background[2]));
    for (const hs::Share& share : shares)
        for (std::size_t c = 0; c < 3; ++c)
            sums[std::size_t(share.y * picture.width + share.x)][int(c)] +=
                share.part * (double(colors.at(share.id)[c]) - double(background[c]));
    for (std::size_t i = 0; i < count; ++i) put(picture, i, to_color(sums[i] / 255.0));
    return picture;
}

image::Picture picture_of_difference(image::Picture picture,
                                     const std::vector<hs::Difference>& difference) {
    for (std::uint16_t& v : picture.values) v = static_cast<std::uint16_t>(v / 4);
    for (std::size_t i = 0; i < difference.size(); ++i) {
        switch (difference[i]) {
            case hs::Difference::None: break;
            case hs::Difference::Tie: put(picture, i, yellow); break;
            case hs::Difference::Edge: put(picture, i, cyan); break;
            case hs::Difference::Snap: put(picture, i, blue); break;
            case hs::Difference::Wrong: put(picture, i, red); break;
        }
    }
    return picture;
}

image::Picture picture_of_counts(const std::vector<std::uint8_t>& counts, int width, int height) {
    image::Picture picture = blank(width, height);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const int more = std::min(std::max(counts[i] - 5, 0) * 20, 225);
        Color color = colors_of_counts[std::min<std::size_t>(counts[i], 5)];
        for (std::uint16_t& v : color) v = static_cast<std::uint16_t>(std::min(v + more, 255));
        put(picture, i, color);
    }
    return picture;
}

image::Picture enlarged(const image::Picture& picture) {
    const int times = std::max(320 / picture.width, 1);
    image::Picture out = blank(picture.width * times, picture.height * times);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const std::size_t from = std::size_t(y / times * picture.width + x / times);
            std::copy_n(picture.values.begin() + std::ptrdiff_t(3 * from), 3,
                        out.values.begin() + std::ptrdiff_t(3 * (y * out.width + x)));
        }
    return out;
}

image::Picture sheet_of(const std::vector<std::vector<image::Picture>>& rows) {
    constexpr int gap = 4;
    const image::Picture& one = rows.front().front();
    std::size_t longest = 0;
    for (const auto& row : rows) longest = std::max(longest, row.size());
    const int columns = int(longest), lines = int(rows.size());
    image::Picture sheet =
        blank(columns * (one.width + gap) - gap, lines * (one.height + gap) - gap);
    for (std::uint16_t& v : sheet.values) v = 255;
    for (int r = 0; r < lines; ++r)
        for (int c = 0; c < int(rows[std::size_t(r)].size()); ++c)
            for (int y = 0; y < one.height; ++y) {
                const auto row = std::size_t(one.width) * 3;
                const std::uint16_t* from =
                    rows[std::size_t(r)][std::size_t(c)].values.data() + std::size_t(y) * row;
                const auto to = pixel_index(c * (one.width + gap),
                                            (lines - 1 - r) * (one.height + gap) + y, sheet.width);
                std::copy(from, from + row, sheet.values.begin() + std::ptrdiff_t(to * 3));
            }
    return sheet;
}

std::array<std::vector<TextLine>, 2> captions_of(const std::string& algorithm,
                                                 const hs::Counts& counts) {
    TextLine work, others;
    const auto add = [](TextLine& line, std::uint64_t n, const char* name, const Color& color) {
        if (n > 0) line.push_back({fmt::format("{} {}", n, name), color});
    };
    add(work, counts.splits, "splits", grey);
    add(work, counts.overdraw, "overdraw", grey);
    add(others, counts.ties, "ties", yellow);
    add(others, counts.edges, "edges", cyan);
    add(others, counts.snapped, "snapped", blue);
    const Word wrong{fmt::format("{} wrong", counts.wrong), counts.wrong > 0 ? red : white};
    return {{{{{algorithm}}, work}, {{wrong}, others}}};
}

}  // namespace gw::apps
