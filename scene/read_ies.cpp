#include "scene/read_ies.h"

#include "gw/error.h"
#include "scene/text/number.h"
#include "scene/text/statements.h"
#include "scene/text/text_file.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace gw::scene {
namespace {

/// More angles than any goniometer measures.
constexpr double most_angles = 100000, most_values = 4e6;

/// Words of numbers in any number of lines, separated by blanks or commas.
class Numbers {
public:
    Numbers(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

    std::string_view line() {
        if (rest_.empty()) fail("ends here", "TILT= and the photometry");
        ++line_;
        const std::size_t end = rest_.find('\n');
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
        return trim(line);
    }

    double number(const char* what) {
        const std::string_view word = next_word(what);
        const auto value = read_double(word);
        if (!value) fail("'" + excerpt_of(word) + "' is no number", what);
        return *value;
    }
    double number(const char* what, double low, double high) {
        const double value = number(what);
        if (!(value >= low && value <= high)) fail(number_text(value), what);
        return value;
    }
    std::size_t count(const char* what) {
        const double value = number(what, 1, most_angles);
        if (value != std::floor(value)) fail(number_text(value), what);
        return std::size_t(value);
    }

    void expect_end() {
        while (!rest_.empty() || !row_.empty()) {
            skip();
            if (!row_.empty())
                fail("'" + excerpt_of(row_) + "' follows the last candela value", "the end");
            if (!rest_.empty()) row_ = line();
        }
    }

    [[noreturn]] void fail(const std::string& is, const std::string& expected) const {
        throw Error(file_, line_, is + "; expected " + expected);
    }
    int line_number() const { return line_; }

private:
    static bool separates(char c) { return is_blank(c) || c == ',' || c == '\x1a'; }
    static std::string excerpt_of(std::string_view word) {
        std::string text;
        for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
        return text;
    }
    void skip() {
        while (!row_.empty() && separates(row_.front())) row_.remove_prefix(1);
    }
    std::string_view next_word(const char* what) {
        for (skip(); row_.empty(); skip()) {
            if (rest_.empty()) fail("ends here", what);
            row_ = line();
        }
        std::size_t size = 0;
        while (size < row_.size() && !separates(row_[size])) ++size;
        const std::string_view word = row_.substr(0, size);
        row_.remove_prefix(size);
        return word;
    }

    std::string file_;
    std::string_view rest_, row_;
    int line_ = 0;
};

/// Skips the labels. Returns whether the tilt's numbers follow.
bool read_labels(Numbers& in, const std::string& first) {
    for (std::string low = first;; low = lower(in.line())) {
        if (!low.starts_with("tilt=")) continue;
        const std::string tilt(trim(std::string_view(low).substr(5)));
        if (tilt == "none") return false;
        if (tilt == "include") return true;
        in.fail("TILT= names another file", "TILT=NONE or TILT=INCLUDE");
    }
}

/// How lamps that are not upright lose light: a luminaire is used as it was measured.
void skip_tilt(Numbers& in, const std::string& file, Warnings& warnings) {
    in.number("the lamp's geometry, 1 to 3", 1, 3);
    const std::size_t pairs = in.count("a number of tilt angles, 1 to 100000");
    for (std::size_t i = 0; i < pairs; ++i) in.number("a tilt angle", -360, 360);
    bool is_one = true;
    for (std::size_t i = 0; i < pairs; ++i)
        is_one = in.number("a tilt's factor from 0", 0, 1e6) == 1 && is_one;
    if (!is_one)
        warnings.add(file, in.line_number(), "tilt",
                     "factors of tilt are left out; the luminaire hangs as it was measured");
}

std::vector<double> angles(Numbers& in, std::size_t count, const char* what, double low,
                           double high) {
    std::vector<double> list;
    for (std::size_t i = 0; i < count; ++i) {
        list.push_back(in.number(what, low, high));
        if (i > 0 && list[i] <= list[i - 1])
            in.fail(number_text(list[i]) + " after " + number_text(list[i - 1]),
                    std::string(what) + " that ascend");
    }
    return list;
}

void check_vertical(const Numbers& in, const std::vector<double>& v) {
    if (v.size() < 2) in.fail("one vertical angle", "at least two");
    if ((v.front() != 0 && v.front() != 90) || (v.back() != 90 && v.back() != 180))
        in.fail("vertical angles from " + number_text(v.front()) + " to " + number_text(v.back()),
                "0 to 90, 90 to 180 or 0 to 180");
}

void check_horizontal(const Numbers& in, const std::vector<double>& h) {
    const double first = h.front(), last = h.back();
    const bool from_0 = first == 0 && (last == 0 || last == 90 || last == 180 || last == 360);
    if (!from_0 && !(first == 90 && last == 270))
        in.fail("horizontal angles from " + number_text(first) + " to " + number_text(last),
                "0, or 0 to 90, 180 or 360, or 90 to 270");
}

void read_angles_of_c(Numbers& in, std::size_t vertical, std::size_t horizontal, Photometry& web) {
    web.vertical = angles(in, vertical, "vertical angles of 0 to 180", 0, 180);
    check_vertical(in, web.vertical);
    web.horizontal = angles(in, horizontal, "horizontal angles of 0 to 360", 0, 360);
    check_horizontal(in, web.horizontal);
}

std::vector<double> angles_of_b(Numbers& in, std::size_t count, const char* kind) {
    std::vector<double> list =
        angles(in, count, (std::string(kind) + " angles of -90 to 90").c_str(), -90, 90);
    if (list.back() <= 0 || (list.front() != 0 && list.front() != -list.back()))
        in.fail(std::string(kind) + " angles from " + number_text(list.front()) + " to " +
                    number_text(list.back()),
                "-90 to 90, or 0 to 90");
    return list;
}

Photometry::Type read_type(Numbers& in) {
    const char* const expected = "1, C, or 2, B";
    const double type = in.number(expected);
    if (type == 1) return Photometry::Type::C;
    if (type == 2) return Photometry::Type::B;
    if (type == 3) in.fail("photometry of type 3, A, whose angles are of headlamps", expected);
    in.fail("photometry of type " + number_text(type), expected);
}

}  // namespace

Photometry read_ies(const std::filesystem::path& path, Warnings& warnings) {
    const std::string text = read_text(path), file = path.string();
    warnings.add_file(path);
    Numbers in(file, text);
    const std::string first = lower(in.line());
    // The second factor of light became "future use" in 2002, and a code of who made it in 2019.
    const bool has_one_factor =
        first.starts_with("iesna:lm-63-2002") || first.starts_with("ies:lm-63-2019");
    if (read_labels(in, first)) skip_tilt(in, file, warnings);
    in.count("a number of lamps from 1");
    in.number("lumens of a lamp, or -1", -1, 1e12);
    double factor = in.number("a candela multiplier above 0", 1e-12, 1e12);
    const std::size_t vertical = in.count("a number of vertical angles from 1"),
                      horizontal = in.count("a number of horizontal angles from 1");
    if (double(vertical) * double(horizontal) > most_values)
        in.fail(number_text(double(vertical) * double(horizontal)) + " candela values",
                "at most " + number_text(most_values));
    Photometry web;
    web.name = path.filename().string();
    web.type = read_type(in);
    in.number("units, 1 for feet or 2 for metres", 1, 2);
    for (const char* side : {"width", "length", "height"})
        in.number((std::string("the opening's ") + side).c_str(), -1e6, 1e6);
    factor *= in.number("a ballast factor above 0", 1e-12, 1e12);
    const double second = in.number("the second light factor above 0", 1e-12, 1e12);
    if (!has_one_factor) factor *= second;
    in.number("watts from 0", 0, 1e12);

    if (web.type == Photometry::Type::B) {
        web.vertical = angles_of_b(in, vertical, "vertical");
        web.horizontal = angles_of_b(in, horizontal, "horizontal");
    } else {
        read_angles_of_c(in, vertical, horizontal, web);
    }
    for (std::size_t i = 0; i < vertical * horizontal; ++i)
        web.candela.push_back(factor * in.number("candela from 0", 0, 1e12));
    in.expect_end();
    if (std::all_of(web.candela.begin(), web.candela.end(), [](double v) { return v == 0; }))
        in.fail("all candela are 0", "a luminaire that shines");
    return web;
}

}  // namespace gw::scene
