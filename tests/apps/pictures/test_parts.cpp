// Claims of gw render --part and gw join: the joined picture has the bytes of the picture that one
// process draws, for every renderer and any number of parts; parts that do not belong together, a
// missing, doubled, cut or damaged one are refused, and nothing is written.
#include "apps/render/part_file.h"
#include "gw/error.h"
#include "render/renderers.h"
#include "tests/apps/scene_files.h"

#include <filesystem>

namespace gw::apps {
namespace {

class PartCommand : public SceneTest {
protected:
    /// A mirror, a shadow, a pane, two samples' soft light.
    PartCommand() {
        write("room.toml", R"([camera]
eye = [0, 2, 6]
at = [0, 0.5, 0]
[[light]]
position = [2, 5, 3]
Ia = 0.2
Id = 0.7
shadow = "map"
area = { shape = "disc", u = [0.5, 0, 0], v = [0, 0.5, 0] }
[[object]]
name = "floor"
shape = "rectangle"
width = 8
depth = 8
material = {Ka = 0.5, Kd = 0.8}
[[object]]
name = "ball"
shape = "sphere"
radius = 0.9
translate = [0, 0.9, 0]
material = {Ka = 0.2, Kd = 0.2, Ks = 0.6, Ns = 30, illum = 3}
[[object]]
name = "pane"
file = "quad.obj"
translate = [1, 1, 2]
material = {Kd = [0.9, 0.3, 0.1], d = 0.5}
)");
    }
    std::string part_name(int i, int n) const {
        return "part_" + std::to_string(i) + "_of_" + std::to_string(n) + ".part";
    }
    Outcome part(int i, int n, std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(),
                         {"room.toml", "--samples", "2", "--quiet", "--part",
                          std::to_string(i) + "/" + std::to_string(n), "-o", part_name(i, n)});
        return render(arguments);
    }
    /// Draws n parts and joins them, the last first.
    std::string joined(int n, const std::vector<std::string>& arguments) const {
        std::vector<std::string> words{"join"};
        for (int i = n; i > 0; --i) {
            EXPECT_EQ(part(i, n, arguments).code, 0);
            words.push_back(part_name(i, n));
        }
        words.insert(words.end(), {"-o", "joined.png"});
        const Outcome outcome = gw(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return bytes_of(in("joined.png"));
    }
    void expect_no_join(const std::vector<std::string>& parts,
                        const std::vector<std::string>& text) const {
        std::vector<std::string> words{"join"};
        words.insert(words.end(), parts.begin(), parts.end());
        words.insert(words.end(), {"-o", "never.png"});
        expect_refused(1, words, text);
    }
};

}  // namespace

TEST_F(PartCommand, JoinedPartsAreThePictureOfOneProcess) {
    for (const std::string& renderer : render::renderer_names()) {
        ASSERT_EQ(render({"room.toml", "--samples", "2", "--quiet", "--renderer", renderer, "-o",
                          "whole.png"})
                      .code,
                  0);
        const std::string whole = bytes_of(in("whole.png"));
        const bool is_first = renderer == render::renderer_names().front();
        for (const int n : is_first ? std::vector{1, 2, 3, 7} : std::vector{3})
            EXPECT_TRUE(joined(n, {"--renderer", renderer}) == whole) << renderer << ", " << n;
    }
}

TEST_F(PartCommand, MachineAndThreadsMayDiffer) {
    EXPECT_EQ(part(1, 2, {"--machine", "reference"}).code, 0);
    EXPECT_EQ(part(2, 2, {"--threads", "3"}).code, 0);
    EXPECT_EQ(gw({"join", part_name(1, 2), part_name(2, 2), "-o", "joined.png"}).code, 0);
    EXPECT_EQ(render({"room.toml", "--samples", "2", "--quiet", "-o", "whole.png"}).code, 0);
    EXPECT_TRUE(bytes_of(in("joined.png")) == bytes_of(in("whole.png")));
}

TEST_F(PartCommand, JoinsTwelveBitsAndAdjustsThemAsRenderDoes) {
    for (const int i : {1, 2}) EXPECT_EQ(part(i, 2, {"--profile", "reality"}).code, 0);
    EXPECT_EQ(gw({"join", part_name(1, 2), part_name(2, 2), "-o", "joined.png", "--gamma", "2.2",
                  "--exposure", "0.5"})
                  .code,
              0);
    EXPECT_EQ(render({"room.toml", "--samples", "2", "--quiet", "--profile", "reality", "-o",
                      "whole.png", "--gamma", "2.2", "--exposure", "0.5"})
                  .code,
              0);
    EXPECT_TRUE(bytes_of(in("joined.png")) == bytes_of(in("whole.png")));
}

TEST_F(PartCommand, RefusesMissingAndDoubledParts) {
    for (const int i : {1, 2, 3}) ASSERT_EQ(part(i, 3).code, 0);
    expect_no_join({part_name(1, 3), part_name(3, 3)}, {"part 2/3 is missing", "all 3 parts"});
    expect_no_join({part_name(1, 3), part_name(2, 3), part_name(1, 3)},
                   {part_name(1, 3), "is part 1/3, as is", "each part once"});
}

TEST_F(PartCommand, RefusesPartsOfDifferentPictures) {
    ASSERT_EQ(part(1, 2).code, 0);
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& text) {
        ASSERT_EQ(part(2, 2, arguments).code, 0);
        expect_no_join({part_name(1, 2), part_name(2, 2)}, {part_name(2, 2), text});
    };
    refused({"--renderer", "raytrace"}, "--renderer is 'raytrace', but 'multipass'");
    refused({"--fov", "20"}, "--fov is '20', but not given");
    refused({"--profile", "reality"}, "--profile is 'reality', but 'vgx'");
    write("quad.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n");
    refused({}, "digest of the scene's files");
    ASSERT_EQ(part(1, 3).code, 0);
    expect_no_join({part_name(2, 2), part_name(1, 3)}, {"number of parts is 3, but 2"});
    std::string other = bytes_of(in(part_name(2, 2)));
    const std::size_t at = other.find("version ") + 8;
    other.replace(at, other.find('\n', at) - at, "99");
    write("other.part", other);
    expect_no_join({"other.part"}, {"other.part", "is damaged"});
}

TEST_F(PartCommand, RefusesEveryCutAndEveryFlippedByte) {
    ASSERT_EQ(gw({"render", "room.toml", "--size", "3x2", "--part", "1/1", "-o", "a.part"}).code,
              0);
    const std::string good = bytes_of(in("a.part"));
    EXPECT_EQ(encode(decode_part("a.part", good)), good);
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_THROW(decode_part("a.part", good.substr(0, size)), Error) << size;
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = char(bad[i] ^ 1);
        EXPECT_THROW(decode_part("a.part", bad), Error) << i;
    }
    write("cut.part", good.substr(0, good.size() - 1));
    expect_no_join({"cut.part"}, {"has 47 bytes of pixels; expected 48"});
    expect_no_join({"room.toml"}, {"is no part of a picture"});
    expect_no_join({"none.part"}, {"none.part: cannot be opened"});
}

TEST_F(PartCommand, RefusesImpossibleWords) {
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& text) {
        std::vector<std::string> words{"render", "room.toml", "--size", "16x16"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        expect_refused(2, words, {text});
    };
    for (const char* word : {"0/2", "3/2", "2", "a/2", "1/", "-1/2"})
        refused({"--part", word, "-o", "a.part"}, "--part");
    refused({"--part", "1/17", "-o", "a.part"}, "16 rows");
    refused({"--part", "1/2", "-o", "a.png"}, "expected FILE.part");
    refused({"--part", "1/2", "-o", "a.part", "--gamma", "2"}, "gw join");
    refused({"--part", "1/2", "-o", "a.part", "--turntable", "2"}, "--turntable");
    refused({"--part", "1/2", "-o", "a.part", "--manifest", "m.json"}, "one whole picture");
}

TEST_F(PartCommand, ReplacesNoPart) {
    ASSERT_EQ(part(1, 1).code, 0);
    std::filesystem::copy_file(in(part_name(1, 1)), in("kept.png"));
    expect_refused(1, {"join", "kept.png", "-o", "kept.png"},
                   {"kept.png", "this command reads it"});
}

}  // namespace gw::apps
