#include "scene/obj/obj_tokens.h"

#include "scene/obj/obj_data.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"

#include <charconv>

namespace gw::scene {
namespace {

std::string number_fault_text(std::string_view word, NumberFault fault, std::string_view form) {
    return "'" + printable(word) + "'" + std::string(fault_text(fault)) + "; expected " +
           std::string(form);
}

[[noreturn]] void fail_number(const Statements& in, std::string_view word, NumberFault fault,
                              std::string_view form) {
    in.fail(number_fault_text(word, fault, form));
}

/// The whole word; "1.#IND" and "-1.#QNAN" of older C libraries are not finite.
FloatText read_word(std::string_view word) {
    FloatText number = read_float(word.data(), word.data() + word.size());
    const auto rest = std::size_t(number.end - word.data());
    if (number.fault == NumberFault::None && rest < word.size())
        number.fault = word.substr(rest).starts_with("#") && word.find(".#") + 1 == rest
                           ? NumberFault::NotFinite
                           : NumberFault::NotANumber;
    return number;
}

float read_number(const Statements& in, std::string_view word, std::string_view form) {
    const FloatText number = read_word(word);
    if (number.fault != NumberFault::None) fail_number(in, word, number.fault, form);
    return number.value;
}

[[noreturn]] void fail_corner(const Statements& in, std::string_view word) {
    in.fail("'" + printable(word) + "' is not a corner; expected v, v/vt, v//vn or v/vt/vn");
}

// One index at `at`: 1 is the first, -1 the last of the `count` read so far.
std::uint32_t read_index(const Statements& in, std::string_view word, const char*& at,
                         std::string_view kind, std::size_t count) {
    int given = 0;
    const auto result = std::from_chars(at, word.data() + word.size(), given);
    if (result.ec != std::errc{}) fail_corner(in, word);
    at = result.ptr;
    const long long index = given < 0 ? given + static_cast<long long>(count) : given - 1LL;
    if (index < 0) in.fail(index_fault(kind, given, count));
    return static_cast<std::uint32_t>(index);
}

}  // namespace

std::size_t read_numbers(const Statements& in, std::string_view text, std::span<float> values,
                         std::string_view form) {
    std::size_t count = 0;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text), ++count) {
        const float number = read_number(in, word, form);
        if (count < values.size()) values[count] = number;
    }
    if (count > values.size()) fail_count(in, count, form);
    return count;
}

std::optional<std::string> not_finite(std::string_view text, std::string_view form) {
    std::optional<std::string> first;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
        const FloatText number = read_word(word);
        if (number.fault == NumberFault::NotFinite && !first)
            first = number_fault_text(word, number.fault, form);
        else if (number.fault != NumberFault::None && number.fault != NumberFault::NotFinite)
            return std::nullopt;
    }
    return first;
}

void fail_count(const Statements& in, std::size_t count, std::string_view form) {
    const std::string numbers = count == 1 ? " number" : " numbers";
    in.fail(std::string(in.keyword()) + " has " + std::to_string(count) + numbers + "; expected " +
            std::string(form));
}

Corner read_corner(const Statements& in, std::string_view word, const ObjData& obj) {
    const char* at = word.data();
    const char* const end = at + word.size();
    Corner corner;
    corner.v = read_index(in, word, at, "v", obj.positions.size());
    if (at < end && *at == '/' && ++at < end && *at != '/')
        corner.vt = read_index(in, word, at, "vt", obj.texcoords.size());
    if (at < end && *at == '/' && ++at < end)
        corner.vn = read_index(in, word, at, "vn", obj.normals.size());
    if (at != end) fail_corner(in, word);
    return corner;
}

}  // namespace gw::scene
