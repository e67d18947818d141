#include "gw/profile_text.h"

#include "gw/error.h"
#include "gw/escape_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <vector>

namespace gw {

namespace {

/// A member by its name; the words of a file of a profile.
struct NamedMember {
    std::string_view name;
    std::function<int(const Profile&)> get;
    std::function<void(Profile&, int)> set;
    int most;
};

template <class T>
NamedMember member(std::string_view name, T Profile::*m, int most) {
    return {name, [m](const Profile& p) { return int(p.*m); },
            [m](Profile& p, int value) { p.*m = T(value); }, most};
}

std::vector<NamedMember> named_members() {
    std::vector<NamedMember> all{
        member("color_bits", &Profile::color_bits, 64),
        member("depth_bits", &Profile::depth_bits, 64),
        member("stencil_bits", &Profile::stencil_bits, 64),
        member("accum_bits", &Profile::accum_bits, 64),
        member("subpixel_bits", &Profile::subpixel_bits, 64),
        member("lit_bits", &Profile::lit_bits, 64),
        member("max_lights", &Profile::max_lights, 1'000'000),
        member("texel_bits", &Profile::texel_bits, 64),
        member("coverage_bits", &Profile::coverage_bits, 64),
        member("color_planes", &Profile::color_planes, 64),
        member("fragment_fog", &Profile::fragment_fog, 1),
        member("perspective_color", &Profile::perspective_color, 1),
    };
    for (const ExtensionName& extension : extension_names())
        all.push_back(
            {extension.name, [m = extension.member](const Profile& p) { return p.extensions.*m; },
             [m = extension.member](Profile& p, int value) { p.extensions.*m = value != 0; }, 1});
    return all;
}

/// Sets the member of one word, "stipple=0".
void set_member(Profile& profile, std::string_view word) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string_view name = word.substr(0, equals);
    for (const NamedMember& m : named_members()) {
        if (m.name != name) continue;
        const std::string_view digits = word.substr(std::min(equals + 1, word.size()));
        int value = -1;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || value < 0 ||
            value > m.most)
            throw Error(fmt::format("'{}': expected a whole number, 0 to {}", escape_controls(word),
                                    m.most));
        return m.set(profile, value);
    }
    throw Error(fmt::format("'{}': expected a member of a profile, such as depth_bits=32",
                            escape_controls(word)));
}

}  // namespace

std::string profile_text(const Profile& profile) {
    const auto built_in = std::find(profiles().begin(), profiles().end(), profile);
    if (built_in != profiles().end()) return profile.name;
    std::string text = profiles().front().name;
    for (const NamedMember& m : named_members())
        text += fmt::format(",{}={}", m.name, m.get(profile));
    return text + ",name=" + profile.name;
}

Profile profile_from_text(std::string_view text) {
    constexpr std::string_view name_key = ",name=";
    const std::size_t named = text.find(name_key);
    std::string_view words = text.substr(0, named);
    const std::size_t comma = std::min(words.find(','), words.size());
    Profile profile = profile_named(words.substr(0, comma));
    words.remove_prefix(comma);
    while (!words.empty()) {
        words.remove_prefix(1);  // the comma
        const std::size_t end = std::min(words.find(','), words.size());
        set_member(profile, words.substr(0, end));
        words.remove_prefix(end);
    }
    if (named != text.npos) profile.name = text.substr(named + name_key.size());
    validate(profile);
    return profile;
}

}  // namespace gw
