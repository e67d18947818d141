#include "scene/obj/map_options.h"

#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <algorithm>
#include <array>
#include <optional>

namespace gw::scene {
namespace {

enum class Argument { OnOff, Number, Base, Vector, Word, Channel };

// `neutral` is the argument that leaves the picture as it is; others are warned about. Honoured
// options have none.
struct Option {
    std::string_view name;
    Argument argument;
    std::string_view neutral = {};
};
constexpr std::array known_options{
    Option{"-o", Argument::Vector},
    Option{"-s", Argument::Vector},
    Option{"-clamp", Argument::OnOff},
    Option{"-type", Argument::Word},
    Option{"-t", Argument::Vector, "0"},
    Option{"-mm", Argument::Base, "0 1"},
    Option{"-bm", Argument::Number, "1"},
    Option{"-boost", Argument::Number, "0"},
    Option{"-texres", Argument::Number, "none"},
    Option{"-blendu", Argument::OnOff, "on"},
    Option{"-blendv", Argument::OnOff, "on"},
    Option{"-cc", Argument::OnOff, "off"},
    Option{"-imfchan", Argument::Channel, "none"},
};

struct ChannelWord {
    std::string_view word;
    OpacityChannel channel;
};
constexpr std::array channel_words{
    ChannelWord{"r", OpacityChannel::Red},       ChannelWord{"g", OpacityChannel::Green},
    ChannelWord{"b", OpacityChannel::Blue},      ChannelWord{"m", OpacityChannel::Alpha},
    ChannelWord{"l", OpacityChannel::Luminance},
};

std::optional<float> number(std::string_view word) {
    const FloatText text = read_float(word.data(), word.data() + word.size());
    const bool good = text.fault == NumberFault::None && text.end == word.data() + word.size();
    return good ? std::optional(text.value) : std::nullopt;
}

class MapReader {
public:
    MapReader(const Statements& in, Warnings& warnings)
        : in_(in),
          warnings_(warnings),
          rest_(in.rest()),
          is_scalar_(lower(in.keyword()) == "map_d") {
        if (is_scalar_) result_.map.channel = OpacityChannel::AlphaOrLuminance;
    }

    MapStatement read(const std::filesystem::path& folder) {
        while (rest_.size() > 1 && rest_[0] == '-' && rest_[1] >= 'a' && rest_[1] <= 'z') option();
        if (rest_.empty()) return {};
        result_.map.file = find_file(folder, rest_);
        result_.map.origin = {in_.file(), in_.line()};
        result_.map.may_lack = true;
        return std::move(result_);
    }

private:
    std::string_view word() {
        const std::string_view taken = take_word(rest_);
        rest_ = trim(rest_);
        return taken;
    }

    void option() {
        const std::string_view name = word();
        for (const Option& option : known_options)
            if (option.name == name) return honour(option);
        std::vector<std::string> known;
        for (const Option& option : known_options) known.emplace_back(option.name);
        in_.fail(unknown("option", name, known));
    }

    void honour(const Option& option) {
        const std::string_view begin = rest_;
        switch (option.argument) {
            case Argument::OnOff: on_off(option); break;
            case Argument::Number: numbers(option, 1, 1); break;
            case Argument::Base: numbers(option, 2, 2); break;
            case Argument::Vector: vector(option); break;
            case Argument::Word: type(option); break;
            case Argument::Channel:
                if (channel(option)) return;
                break;
        }
        const std::string_view argument = trim(begin.substr(0, begin.size() - rest_.size()));
        if (!option.neutral.empty() && argument != option.neutral)
            warnings_.add(in_.file(), in_.line(), std::string(option.name),
                          "map option " + std::string(option.name) + " is not honoured");
    }

    void on_off(const Option& option) {
        const std::string_view argument = word();
        if (argument != "on" && argument != "off") fail(option, argument, "on or off");
        if (option.name == "-clamp")
            result_.map.wrap_s = result_.map.wrap_t = argument == "on" ? Wrap::Clamp : Wrap::Repeat;
    }

    void type(const Option& option) {
        const std::string_view argument = word();
        if (argument.empty()) fail(option, argument, "a word");
        if (option.name == "-type") result_.type = argument;
    }

    /// Whether it is honoured: a map of colours has all channels, and pictures have no depths, z.
    bool channel(const Option& option) {
        const std::string_view argument = word();
        if (argument.empty() && !is_scalar_) fail(option, argument, "a word");
        if (!is_scalar_ || argument == "none" || argument == "z") return false;
        const auto* const found = std::ranges::find(channel_words, argument, &ChannelWord::word);
        if (found == channel_words.end()) fail(option, argument, "r, g, b, m, l or z");
        result_.map.channel = found->channel;
        return true;
    }

    // One to three numbers; a number that ends the statement is the file's name.
    void vector(const Option& option) {
        const float missing = option.name == "-s" ? 1.0f : 0.0f;
        const std::vector<float> given = numbers(option, 1, 3);
        const vec2 value(given[0], given.size() > 1 ? given[1] : missing);
        if (option.name == "-s") result_.map.scale = value;
        if (option.name == "-o") result_.map.offset = value;
    }

    std::vector<float> numbers(const Option& option, std::size_t least, std::size_t most) {
        std::vector<float> values;
        while (values.size() < most) {
            std::string_view ahead = rest_;
            const std::string_view argument = take_word(ahead);
            const std::optional<float> value = number(argument);
            if (!value && values.size() < least) fail(option, argument, "a number");
            if (!value || (values.size() >= least && trim(ahead).empty())) break;
            values.push_back(*value);
            rest_ = trim(ahead);
        }
        return values;
    }

    [[noreturn]] void fail(const Option& option, std::string_view argument,
                           std::string_view expected) {
        in_.fail(std::string(option.name) + " has '" + printable(argument) + "'; expected " +
                 std::string(expected));
    }

    const Statements& in_;
    Warnings& warnings_;
    std::string_view rest_;
    bool is_scalar_;  ///< a map of numbers, which are a channel of its picture
    MapStatement result_;
};

}  // namespace

MapStatement read_map(const Statements& in, const std::filesystem::path& folder,
                      Warnings& warnings) {
    return MapReader(in, warnings).read(folder);
}

}  // namespace gw::scene
