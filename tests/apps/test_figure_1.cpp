// Fig. 1 of [K]: a map in one pass reddens the gloss, multi-pass leaves it white.
#include "pictures.h"
#include "scene_files.h"

#include <algorithm>

namespace gw::apps {

class Figure1 : public SceneTest {
protected:
    Pixels picture(const std::string& scene, const std::string& renderer) const {
        const Outcome outcome = gw({"render", GW_SOURCE_DIR "/scenes/" + scene, "--renderer", renderer, "--size", "320x240",
                                    "-o", "a.png"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return read_pixels(in("a.png"));
    }
    /// Where the gloss is: pixels that are white without a map.
    std::vector<std::size_t> gloss(const Pixels& plain) const {
        std::vector<std::size_t> first;
        for (std::size_t i = 0; i < plain.values.size(); i += 3) {
            if (*std::min_element(&plain.values[i], &plain.values[i] + 3) >= 0.99f) first.push_back(i);
        }
        EXPECT_GT(first.size(), 100u);
        return first;
    }
};

TEST_F(Figure1, WithoutAMapTheGlossIsWhite) {
    const Pixels plain = picture("rings_plain.toml", "hardware");
    for (std::size_t i : gloss(plain)) EXPECT_EQ(plain.values[i], plain.values[i + 2]);
}

TEST_F(Figure1, InOnePassTheMapReddensTheGloss) {
    const Pixels red = picture("rings.toml", "hardware");
    for (std::size_t i : gloss(picture("rings_plain.toml", "hardware"))) {
        EXPECT_GT(red.values[i], 0.4f);
        EXPECT_LT(std::max(red.values[i + 1], red.values[i + 2]), 0.25f * red.values[i]);
    }
}

TEST_F(Figure1, InMultiPassTheGlossStaysWhite) {
    const Pixels multi = picture("rings.toml", "multipass"), single = picture("rings.toml", "hardware");
    float whitest = 0;
    for (std::size_t i : gloss(picture("rings_plain.toml", "hardware"))) {
        const float white = std::min(multi.values[i + 1], multi.values[i + 2]);
        EXPECT_GT(white, std::max(single.values[i + 1], single.values[i + 2]) + 0.2f);
        whitest = std::max(whitest, white / multi.values[i]);
    }
    EXPECT_GT(whitest, 0.75f);  // green and blue beside red, where the gloss is strongest
}

}  // namespace gw::apps
