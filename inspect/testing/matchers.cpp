#include "inspect/testing/matchers.h"

#include "inspect/replay/plane_values.h"
#include "inspect/testing/failure_files.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>

#include <functional>
#include <sstream>

namespace gw {

void PrintTo(const Planes& planes, std::ostream* out) {
    *out << "planes of " << planes.width << " x " << planes.height << " pixels";
}

}  // namespace gw

namespace gw::testing {
namespace {

/// A question about planes: "" is yes, otherwise why not.
class Question : public ::testing::MatcherInterface<const Planes&> {
public:
    using Answer = std::function<std::string(const Planes&)>;
    Question(std::string says, Answer why_not)
        : says_(std::move(says)), why_not_(std::move(why_not)) {}

    bool MatchAndExplain(const Planes& planes,
                         ::testing::MatchResultListener* listener) const override {
        const std::string why = why_not_(planes);
        if (!why.empty() && listener->IsInterested()) *listener << why;
        return why.empty();
    }
    void DescribeTo(std::ostream* out) const override { *out << "planes where " << says_; }
    void DescribeNegationTo(std::ostream* out) const override {
        *out << "planes where not: " << says_;
    }

private:
    std::string says_;
    Answer why_not_;
};

PlanesMatcher asked(std::string says, Question::Answer why_not) {
    return ::testing::MakeMatcher(new Question(std::move(says), std::move(why_not)));
}

bool inside(const Planes& planes, int x, int y) {
    return x >= 0 && y >= 0 && x < planes.width && y < planes.height;
}

/// `one`: planes of one pixel with the expected value, which is compared as text.
PlanesMatcher pixel_is(Plane plane, int x, int y, const Planes& one) {
    const std::string value = value_at(one, plane, 0, 0);
    const std::string says = fmt::format("{} at ({}, {}) is {}", name_of(plane), x, y, value);
    return asked(says, [=](const Planes& planes) {
        if (!inside(planes, x, y))
            return fmt::format("which are {} x {}", planes.width, planes.height);
        const std::string actual = value_at(planes, plane, x, y);
        return actual == value ? "" : "which is " + actual;
    });
}

Planes one_pixel() { return {1, 1}; }

std::string difference(Plane plane, const Planes& expected, const Planes& actual) {
    if (expected.width != actual.width || expected.height != actual.height)
        return fmt::format("which are {} x {}, expected {} x {}", actual.width, actual.height,
                           expected.width, expected.height);
    const auto wrong = inspect::wrong_pixels(expected, actual, plane);
    if (wrong.empty()) return "";
    const auto [x, y, distance] = wrong.front();
    return fmt::format("where {} differs at {}, worst at ({}, {}): expected {}, got {}",
                       name_of(plane), inspect::plural(wrong.size(), "pixel", "pixels"), x, y,
                       value_at(expected, plane, x, y), value_at(actual, plane, x, y));
}

PlanesMatcher equal(std::string says, std::vector<Plane> which, Planes expected,
                    std::optional<Profile> profile) {
    return asked(std::move(says), [=](const Planes& actual) {
        for (const Plane plane : which) {
            const std::string why = difference(plane, expected, actual);
            if (why.empty()) continue;
            const bool same_size =
                expected.width == actual.width && expected.height == actual.height;
            if (!profile || !same_size) return why;
            return why + "\n" + write_failure_pictures("planes", expected, actual, *profile);
        }
        return std::string();
    });
}

}  // namespace

PlanesMatcher HasColor(int x, int y, Rgba color) {
    Planes one = one_pixel();
    one.color[0] = color;
    return pixel_is(Plane::Color, x, y, one);
}

PlanesMatcher HasDepth(int x, int y, std::uint32_t depth) {
    Planes one = one_pixel();
    one.depth[0] = depth;
    return pixel_is(Plane::Depth, x, y, one);
}

PlanesMatcher HasStencil(int x, int y, std::uint8_t stencil) {
    Planes one = one_pixel();
    one.stencil[0] = stencil;
    return pixel_is(Plane::Stencil, x, y, one);
}

PlanesMatcher HasAccum(int x, int y, std::array<std::int32_t, 4> sum) {
    Planes one = one_pixel();
    one.accum[0] = sum;
    return pixel_is(Plane::Accum, x, y, one);
}

PlanesMatcher PlaneEq(Plane plane, Planes expected, std::optional<Profile> profile) {
    return equal(std::string(name_of(plane)) + " is as expected, bit for bit", {plane},
                 std::move(expected), std::move(profile));
}

PlanesMatcher PlanesEq(Planes expected, std::optional<Profile> profile) {
    return equal("all are as expected, bit for bit",
                 {inspect::planes_in_order.begin(), inspect::planes_in_order.end()},
                 std::move(expected), std::move(profile));
}

PlanesMatcher HasDigest(Plane plane, std::string expected) {
    const std::string says = fmt::format("the digest of {} is {}", name_of(plane), expected);
    return asked(says, [=](const Planes& planes) {
        const std::string actual = to_string(digest(planes, plane));
        return actual == expected ? "" : "which is " + actual;
    });
}

PlanesMatcher CoveredPixels(Plane plane, Planes background, ::testing::Matcher<std::size_t> count) {
    std::stringstream says;
    says << "the number of pixels of " << name_of(plane) << " that are not the background's ";
    count.DescribeTo(&says);
    return asked(says.str(), [=](const Planes& planes) -> std::string {
        if (planes.width != background.width || planes.height != background.height)
            return difference(plane, background, planes);
        const std::size_t covered = inspect::wrong_pixels(background, planes, plane).size();
        return count.Matches(covered) ? "" : fmt::format("which is {}", covered);
    });
}

}  // namespace gw::testing
