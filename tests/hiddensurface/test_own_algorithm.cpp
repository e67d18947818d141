// Claims: the lecture's example of an own algorithm (docs/lecture.md, "Your own") is the file
// mine.cpp beside this one, letter for letter, and does what it says.
#include "test_paths.h"
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace gw::hiddensurface {
namespace {

std::string text_of(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(GW_SOURCE_DIR "/" + file).rdbuf();
    return text.str();
}

/// The page's only listing in C++.
std::string listing_of(const std::string& page) {
    const std::string text = text_of(page), begin = "\n```cpp\n";
    const std::size_t first = text.find(begin);
    if (first == text.npos) return "";
    return text.substr(first + begin.size(),
                       text.find("```", first + begin.size()) - first - begin.size());
}

}  // namespace

TEST(OwnAlgorithm, IsTheListingOfBothPages) {
    const std::string source = text_of("tests/hiddensurface/mine.cpp");
    EXPECT_GT(source.size(), 500u);
    EXPECT_EQ(listing_of("docs/lecture.md"), source);
    EXPECT_EQ(listing_of("docs/lecture.ja.md"), source);
}

TEST(OwnAlgorithm, ShowsWhatIsFarthest) {
    Trial trial(random_layers(1, 16), vgx(), 16, 12);
    StepLog log(Level::Polygon);
    Result result = run_on(*trial.machine, mine(), trial.input, log);
    compare(result, trial.z_buffer.ids, trial.input);
    const auto& polygons = trial.input.polygons;
    const auto farthest =
        std::max_element(polygons.begin(), polygons.end(),
                         [](const auto& a, const auto& b) { return a.farthest < b.farthest; });
    EXPECT_EQ(result.ids, std::vector<std::uint32_t>(16 * 12, farthest->id));
    EXPECT_EQ(result.counts.wrong, 16u * 12u);
    EXPECT_GT(result.counts.keys, 15u);
    EXPECT_EQ(log.steps().size(), 16u);
}

}  // namespace gw::hiddensurface
