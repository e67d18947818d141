#include "apps/render/part_file.h"

#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "gw/machine.h"
#include "inspect/recording/content.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>

namespace gw::apps {
namespace {

constexpr std::string_view first_line = "picture part 1\n", end_word = "digest ";
constexpr int most_parts = max_window_size;
/// Bytes of a digest's line after its word.
constexpr std::size_t digest_size = 32;
constexpr std::size_t bytes_of_pixel = 8;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
    throw Error(file.string(), 0, what);
}

std::string digest_of(std::string_view text) {
    return to_string(inspect::digest_of_bytes(
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

std::string header_of(const Part& part) {
    std::string text(first_line);
    text += fmt::format("version {}\nscene {}\npart {} {}\nsize {} {}\nbits {}\n", part.version,
                        part.scene, part.share.part, part.share.of, part.size.width,
                        part.size.height, part.bits);
    for (const auto& [name, word] : part.options) text += fmt::format("option {} {}\n", name, word);
    return text;
}

/// The four channels of each pixel, 16 bits each, low byte first.
std::string bytes_of(const std::vector<Rgba>& color) {
    std::string bytes;
    bytes.reserve(color.size() * bytes_of_pixel);
    for (const Rgba& pixel : color)
        for (int k = 0; k < 4; ++k) {
            bytes += char(pixel[k] & 255);
            bytes += char(pixel[k] >> 8);
        }
    return bytes;
}

std::vector<Rgba> color_of(std::string_view bytes) {
    std::vector<Rgba> color(bytes.size() / bytes_of_pixel);
    const auto value = [&](std::size_t i) { return std::uint16_t(std::uint8_t(bytes[i])); };
    for (std::size_t i = 0; i < bytes.size(); i += 2)
        color[i / bytes_of_pixel][int(i % bytes_of_pixel / 2)] =
            std::uint16_t(value(i) | value(i + 1) << 8);
    return color;
}

/// Reads the lines of a header. A line that is not as `header_of` writes it makes it false.
class HeaderReader {
public:
    explicit HeaderReader(std::string_view text) : text_(text) {}

    /// The rest of the next line if it begins with this word.
    std::optional<std::string> line(std::string_view word) {
        const std::size_t end = text_.find('\n');
        if (end == text_.npos || !text_.starts_with(word) || text_[word.size()] != ' ') return {};
        const std::string rest(text_.substr(word.size() + 1, end - word.size() - 1));
        text_.remove_prefix(end + 1);
        return rest;
    }
    std::string word(std::string_view name) {
        const auto found = line(name);
        good_ = good_ && found;
        return found.value_or("");
    }
    /// Whole numbers, each 1 .. high.
    template <class... Numbers>
    void numbers(std::string_view name, int high, Numbers&... values) {
        const std::string rest = word(name);
        const char* at = rest.data();
        const char* const end = at + rest.size();
        for (int* value : {&values...}) {
            if (at != rest.data() && at != end && *at == ' ') ++at;
            const auto [after, error] = std::from_chars(at, end, *value);
            good_ = good_ && error == std::errc() && 1 <= *value && *value <= high;
            at = after;
        }
        good_ = good_ && at == end;
    }
    bool good() const { return good_; }

private:
    std::string_view text_;
    bool good_ = true;
};

Part header_from(const std::filesystem::path& file, std::string_view text) {
    Part part{.file = file};
    HeaderReader lines(text.substr(first_line.size()));
    part.version = lines.word("version");
    part.scene = lines.word("scene");
    lines.numbers("part", most_parts, part.share.part, part.share.of);
    lines.numbers("size", max_window_size, part.size.width, part.size.height);
    lines.numbers("bits", 16, part.bits);
    while (const auto option = lines.line("option")) {
        const std::size_t blank = std::min(option->find(' '), option->size() - 1);
        part.options.push_back({option->substr(0, blank), option->substr(blank + 1)});
    }
    if (!lines.good() || part.share.part > part.share.of || header_of(part) != text)
        fail(file, "has a header that gw render --part did not write; expected its file unchanged");
    return part;
}

/// Names the fact by which two parts belong to different pictures; empty: to one.
std::string difference(const Part& a, const Part& b) {
    const auto differ = [&](const std::string& what, const std::string& of_a,
                            const std::string& of_b) {
        return of_a == of_b ? "" : fmt::format("{} is {}, but {}", what, of_b, of_a);
    };
    std::string text = differ("version of gw", a.version, b.version);
    if (text.empty()) text = differ("digest of the scene's files", a.scene, b.scene);
    if (text.empty())
        text = differ("number of parts", std::to_string(a.share.of), std::to_string(b.share.of));
    const auto word_in = [](const Part& part, const std::string& name) {
        const auto found = std::find_if(part.options.begin(), part.options.end(),
                                        [&](const auto& option) { return option.first == name; });
        return found == part.options.end() ? "not given" : "'" + found->second + "'";
    };
    for (const Part* part : {&a, &b})
        for (const auto& option : part->options)
            if (text.empty())
                text =
                    differ("--" + option.first, word_in(a, option.first), word_in(b, option.first));
    if (text.empty() && (a.size != b.size || a.bits != b.bits)) text = "size or bits differ";
    return text;
}

std::size_t pixels_of(const Part& part) {
    return std::size_t(part.size.width) *
           std::size_t(rows_of(part.share, part.size.height).count());
}

}  // namespace

Share share_from(const std::string& option, const std::string& word) {
    const std::size_t slash = word.find('/');
    const std::string expected =
        option + " '" + word + "': expected I/N, part I of N, as 2/7; I at least 1, at most N";
    if (slash == word.npos) throw UsageError(expected);
    Share share;
    share.of = whole_number_from(option, word.substr(slash + 1), 1, most_parts);
    share.part = whole_number_from(option, word.substr(0, slash), 1, most_parts);
    if (share.part > share.of) throw UsageError(expected);
    return share;
}

std::string to_string(const Share& share) { return fmt::format("{}/{}", share.part, share.of); }

scene::Rows rows_of(const Share& share, int height) {
    const auto below = [&](int part) { return height - height * part / share.of; };
    return {below(share.part), below(share.part - 1)};
}

std::string encode(const Part& part) {
    const std::string header = header_of(part), pixels = bytes_of(part.color);
    return header + std::string(end_word) + digest_of(header + pixels) + "\n" + pixels;
}

Part decode_part(const std::filesystem::path& file, std::string_view bytes) {
    if (!bytes.starts_with(first_line))
        fail(file, "is no part of a picture; expected a file that gw render --part wrote");
    const std::size_t end = bytes.find("\n" + std::string(end_word)) + 1,
                      pixels = end + end_word.size() + digest_size + 1;
    if (end == 0 || bytes.size() < pixels || bytes[pixels - 1] != '\n')
        fail(file, "ends in its header; expected a whole part");
    const std::string header(bytes.substr(0, end));
    Part part = header_from(file, header);
    const std::string_view color = bytes.substr(pixels);
    if (color.size() != pixels_of(part) * bytes_of_pixel)
        fail(file, fmt::format("has {} bytes of pixels; expected {}", color.size(),
                               pixels_of(part) * bytes_of_pixel));
    if (bytes.substr(end + end_word.size(), digest_size) != digest_of(header + std::string(color)))
        fail(file, "is damaged: its digest is not that of its content; expected it as written");
    part.color = color_of(color);
    return part;
}

std::vector<Rgba> joined(const std::vector<Part>& parts) {
    const Part& first = parts.front();
    std::vector<const Part*> found(std::size_t(first.share.of));
    for (const Part& part : parts) {
        const std::string text = difference(first, part);
        if (!text.empty())
            fail(part.file, "is of another picture than " + first.file.string() + ": its " + text +
                                " there; expected parts of one picture");
        const Part*& place = found[std::size_t(part.share.part - 1)];
        if (place)
            fail(part.file, "is part " + to_string(part.share) + ", as is " + place->file.string() +
                                "; expected each part once");
        place = &part;
    }
    std::vector<Rgba> color;
    for (std::size_t i = found.size(); i-- > 0;) {
        if (!found[i])
            throw Error(fmt::format("part {}/{} is missing; expected all {}", i + 1, first.share.of,
                                    inspect::plural(std::uint64_t(found.size()), "part", "parts")));
        color.insert(color.end(), found[i]->color.begin(), found[i]->color.end());
    }
    return color;
}

}  // namespace gw::apps
