#include "gw/error.h"
#include "gw/profile_text.h"

#include <gtest/gtest.h>

namespace gw {

namespace {

std::string refusal(std::string_view text) {
    try {
        profile_from_text(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(ProfileText, OfABuiltInProfileIsItsName) {
    for (const Profile& profile : profiles()) {
        EXPECT_EQ(profile_text(profile), profile.name);
        EXPECT_EQ(profile_from_text(profile.name), profile);
    }
}

/// Each member by itself, so that none is left out.
TEST(ProfileText, KeepsEveryMember) {
    const std::vector<int Profile::*> numbers{&Profile::color_bits,    &Profile::depth_bits,
                                              &Profile::stencil_bits,  &Profile::accum_bits,
                                              &Profile::lit_bits,      &Profile::subpixel_bits,
                                              &Profile::coverage_bits, &Profile::max_lights,
                                              &Profile::texel_bits,    &Profile::color_planes};
    const auto expect_kept = [](const Profile& profile) {
        EXPECT_EQ(profile_from_text(profile_text(profile)), profile) << profile_text(profile);
    };
    for (const Profile& base : profiles()) {
        for (const auto member : numbers)
            for (const int step : {-1, 1}) {
                Profile changed = base;
                changed.*member += step;
                try {
                    validate(changed);
                } catch (const Error&) {
                    continue;
                }
                expect_kept(changed);
            }
        for (const auto member : {&Profile::fragment_fog, &Profile::perspective_color}) {
            Profile changed = base;
            changed.*member = !(changed.*member);
            expect_kept(changed);
        }
        for (const ExtensionName& extension : extension_names()) {
            Profile changed = base;
            changed.extensions.*extension.member = !(changed.extensions.*extension.member);
            expect_kept(changed);
        }
        Profile renamed = base;
        renamed.name = "mine, color_bits=9,name=";
        expect_kept(renamed);
    }
}

TEST(ProfileText, ChangesABuiltInProfile) {
    Profile expected = opengl();
    expected.depth_bits = 32;
    expected.extensions.stipple = false;
    EXPECT_EQ(profile_from_text("opengl,depth_bits=32,stipple=0"), expected);
}

TEST(ProfileText, RefusesWhatItDoesNotKnow) {
    EXPECT_NE(refusal("").find("unknown profile ''"), std::string::npos);
    EXPECT_NE(refusal("indy").find("expected vgx, reality, ideal or opengl"), std::string::npos);
    EXPECT_NE(refusal("vgx,bits=3").find("'bits=3': expected a member"), std::string::npos);
    EXPECT_NE(refusal("vgx,").find("'': expected a member"), std::string::npos);
    EXPECT_NE(refusal("vgx,depth_bits=").find("expected a whole number"), std::string::npos);
    EXPECT_NE(refusal("vgx,depth_bits=2x").find("expected a whole number"), std::string::npos);
    EXPECT_NE(refusal("vgx,stipple=2").find("0 to 1"), std::string::npos);
    EXPECT_NE(refusal("vgx,depth_bits=40").find("depth_bits = 40; expected 16 to 32"),
              std::string::npos);
}

}  // namespace gw
