// Fig. 1 of [K]: a map in one pass reddens the gloss, multi-pass leaves it white.
#include "test_paths.h"
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

#include <algorithm>

namespace gw::apps {

class Figure1 : public SceneTest {
protected:
    Pixels picture(const std::string& scene, const std::string& renderer) const {
        const Outcome outcome =
            gw({"render", GW_SOURCE_DIR "/scenes/" + scene, "--renderer", renderer, "--size",
                "320x240", "-o", "a.png", "--components", "parts"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return read_pixels(in("a.png"));
    }
    /// Where the gloss is: the first values of pixels whose specular component is above 0.6.
    std::vector<std::size_t> gloss() const {
        picture("rings.toml", "multipass");
        const Pixels specular = read_pixels(in("parts/specular.png"));
        std::vector<std::size_t> first;
        for (std::size_t i = 0; i < specular.values.size(); i += 3) {
            if (specular.values[i + 1] > 0.6f) first.push_back(i);
        }
        EXPECT_GT(first.size(), 100u);
        return first;
    }
};

TEST_F(Figure1, WithoutAMapTheGlossIsWhite) {
    const Pixels plain = picture("rings_plain.toml", "hardware");
    for (std::size_t i : gloss()) {
        for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(plain.values[i + c], 1);
    }
}

TEST_F(Figure1, InOnePassTheMapReddensTheGloss) {
    const Pixels red = picture("rings.toml", "hardware");
    for (std::size_t i : gloss()) {
        ASSERT_GT(red.values[i], 0.5f);
        ASSERT_LT(std::max(red.values[i + 1], red.values[i + 2]), 0.25f * red.values[i]);
    }
}

TEST_F(Figure1, InMultiPassTheGlossStaysWhite) {
    const Pixels multi = picture("rings.toml", "multipass");
    for (std::size_t i : gloss()) {
        ASSERT_GT(std::min(multi.values[i + 1], multi.values[i + 2]), 0.6f * multi.values[i]);
    }
}

}  // namespace gw::apps
