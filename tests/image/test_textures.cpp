// Claims: texels are the values of the file; an error names the statement that asks for the file.
#include "gw/error.h"
#include "image/textures.h"
#include "image/write.h"

#include "tests/image/files.h"
#include "tests/image/refusal.h"
#include "tests/judge/judge.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

namespace gw::image {
namespace {

template <class T>
void write_raw(const std::filesystem::path& file, int width, int height, int channels,
               const std::vector<T>& values, judge::Sample stored = judge::sample_of<T>) {
    ASSERT_TRUE(judge::store(file, {width, height, channels, stored}, values));
}

using Texels = std::vector<std::uint16_t>;

Texels texels(const std::filesystem::path& file) { return read_texture(file)->levels[0].rgba; }

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

scene::Scene scene_with_map(const std::filesystem::path& file) {
    scene::Scene scene;
    scene.materials.resize(1);
    scene.materials[0].map_Kd.push_back({.file = file, .origin = {"stone.mtl", 12}});
    return scene;
}

}  // namespace

TEST(ReadTexture, TurnsTheBottomRowFirst) {
    const Folder folder;
    write_raw<std::uint8_t>(folder / "a.png", 1, 2, 3, {1, 2, 3, 4, 5, 6});
    EXPECT_EQ(texels(folder / "a.png"),
              (Texels{4 * 257, 5 * 257, 6 * 257, 65535, 257, 2 * 257, 3 * 257, 65535}));
}

TEST(ReadTexture, KeepsColourUnderAlphaAsItIsStored) {
    const Folder folder;
    write_raw<std::uint8_t>(folder / "a.png", 2, 1, 4, {200, 100, 50, 0, 200, 100, 50, 128});
    EXPECT_EQ(texels(folder / "a.png"), (Texels{200 * 257, 100 * 257, 50 * 257, 0, 200 * 257,
                                                100 * 257, 50 * 257, 128 * 257}));
}

TEST(ReadTexture, SpreadsGreyAndGreyWithAlpha) {
    const Folder folder;
    write_raw<std::uint8_t>(folder / "grey.png", 1, 1, 1, {7});
    EXPECT_EQ(texels(folder / "grey.png"), (Texels{7 * 257, 7 * 257, 7 * 257, 65535}));
    write_raw<std::uint8_t>(folder / "alpha.png", 1, 1, 2, {7, 9});
    EXPECT_EQ(texels(folder / "alpha.png"), (Texels{7 * 257, 7 * 257, 7 * 257, 9 * 257}));
}

TEST(ReadTexture, KeepsSixteenBits) {
    const Folder folder;
    write_raw<std::uint16_t>(folder / "a.png", 1, 1, 3, {1, 256, 65535});
    EXPECT_EQ(texels(folder / "a.png"), (Texels{1, 256, 65535, 65535}));
}

TEST(ReadTexture, ClampsFloatsAndRounds) {
    const Folder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    write_raw<float>(folder / "a.exr", 2, 1, 3, {-1, 0.5f, 2, nan, infinity, 1.0f / 65535});
    EXPECT_EQ(texels(folder / "a.exr"), (Texels{0, 32768, 65535, 65535, 0, 65535, 1, 65535}));
}

TEST(ReadTexture, ReadsWhatWritePictureWrote) {
    const Folder folder;
    const Picture picture{.width = 2,
                          .height = 2,
                          .channels = 3,
                          .bits = 8,
                          .values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        write_picture(folder / name, picture);
        Texels expected;
        for (std::size_t i = 0; i < 12; i += 3) {
            for (std::size_t c = 0; c < 3; ++c) expected.push_back(picture.values[i + c]);
            expected.push_back(255);
        }
        Texels found = texels(folder / name);
        for (std::uint16_t& v : found) v = static_cast<std::uint16_t>((v + 128) / 257);
        EXPECT_EQ(found, expected) << name;
    }
}

TEST(ReadTexture, ReadsFilesAndFoldersOfAnyName) {
    const std::vector<const char*> names{"r?1", "a?b=c", "per%cent", "#1", "a b", "a:b", "a*b"};
    const std::vector<const char*> extensions{".png", ".tif", ".exr", ".ppm"};
    const Folder folder;
    // Each name with one kind of file, and one name with all: every reading is a process.
    std::vector<std::pair<std::string, std::string>> files;
    for (std::size_t i = 0; i < names.size(); ++i)
        files.emplace_back(names[i], extensions[i % extensions.size()]);
    for (const char* extension : extensions) files.emplace_back("[x]", extension);
    for (const auto& [name, extension] : files) {
        std::filesystem::create_directory(folder / name);
        const auto odd = folder / name / (name + extension);
        write_picture(odd,
                      {.width = 1, .height = 1, .channels = 3, .bits = 8, .values = {255, 0, 255}});
        EXPECT_EQ(texels(odd).size(), 4u) << odd;
    }
}

TEST(ReadTexture, RefusesWhatIsNoPicture) {
    const Folder folder;
    EXPECT_EQ(refusal(folder / "missing.png"), "no such file; expected a picture file");
    EXPECT_EQ(refusal(folder / ""), "it is a folder; expected a picture file");
    EXPECT_EQ(refusal("/dev/null"), "it is not a regular file; expected a picture file");
    std::ofstream(folder / "text.png") << "this is no picture";
    EXPECT_TRUE(contains(refusal(folder / "text.png"), "it cannot be read"));
    std::ofstream(folder / "empty.jpg");
    EXPECT_TRUE(contains(refusal(folder / "empty.jpg"), "it cannot be read"));
    EXPECT_FALSE(contains(refusal(folder / "text.png"), "\n"));
}

TEST(ReadTexture, RefusesAFileThatIsCutShort) {
    for (const char* extension : {"png", "tif", "exr", "jpg", "tga", "ppm"}) {
        const Folder folder;
        std::vector<std::uint8_t> noise(64 * 64 * 3);
        unsigned seed = 1;
        for (std::uint8_t& v : noise)
            v = static_cast<std::uint8_t>((seed = seed * 1664525 + 1013904223) >> 24);
        const auto file = folder / std::string("a.").append(extension);
        write_raw<std::uint8_t>(file, 64, 64, 3, noise);
        std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
        testing::internal::CaptureStderr();
        EXPECT_TRUE(contains(refusal(file), "expected a whole picture file")) << extension;
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << extension;
    }
}

TEST(ReadTexture, RefusesSidesThatATextureCannotHave) {
    const Folder folder;
    write_raw<std::uint8_t>(folder / "wide.png", max_texture_size + 1, 1, 1,
                            std::vector<std::uint8_t>(max_texture_size + 1));
    EXPECT_EQ(refusal(folder / "wide.png"), "it has 4097 x 1 pixels; expected sides of 1 to 4096");
}

TEST(LoadTextures, ReadsPicturesThatLieWithinAFile) {
    const Folder folder;
    const std::vector<std::uint8_t> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    for (const char* name : {"a.png", "a.tif"}) {
        write_raw<std::uint8_t>(folder / name, 2, 2, 3, values);
        std::ifstream in(folder / name, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        scene::Scene scene = scene_with_map("m.glb: images[0]");
        scene.materials[0].map_Kd[0].bytes = std::make_shared<const std::string>(bytes);
        load_textures(scene);
        const TextureRef texture = scene.materials[0].map_Kd[0].texture;
        EXPECT_EQ(texture->levels[0].rgba, TexelValues(texels(folder / name))) << name;
        EXPECT_EQ(texture->name, "m.glb: images[0]");
    }
}

/// A glTF file has places and no statements.
TEST(LoadTextures, NamesThePlaceThatAsks) {
    const Folder folder;
    const auto refused = [](scene::Scene& scene, const std::string& place) {
        scene.materials[0].map_Kd[0].origin = {"m.gltf", 0};
        scene.materials[0].map_Kd[0].place = place;
        try {
            load_textures(scene);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    const std::string missing = (folder / "missing.png").string();
    scene::Scene scene = scene_with_map(missing);
    EXPECT_EQ(refused(scene, "images[0].uri"),
              "m.gltf: images[0].uri " + missing + ": no such file; expected a picture file");
    scene.materials[0].map_Kd[0].bytes = std::make_shared<const std::string>("no picture");
    EXPECT_EQ(refused(scene, "images[1]").substr(0, 36), "m.gltf: images[1]: it cannot be read");
}

TEST(LoadTextures, NamesTheFileAndLineThatAsk) {
    const Folder folder;
    scene::Scene scene = scene_with_map(folder / "missing.png");
    try {
        load_textures(scene);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "stone.mtl:12: map_Kd " + (folder / "missing.png").string() +
                                    ": no such file; expected a picture file");
    }
}

TEST(LoadTextures, AModelMayLackAFileButNotHaveAWrongOne) {
    const Folder folder;
    scene::Scene scene = scene_with_map(folder / "missing.png");
    scene.materials[0].map_Kd[0].may_lack = true;
    EXPECT_TRUE(load_textures(scene).empty());
    EXPECT_FALSE(scene.materials[0].map_Kd[0].texture);
    std::ofstream(folder / "missing.png") << "no picture";
    EXPECT_THROW(load_textures(scene), Error);
}

TEST(LoadTextures, ReadsEachFileOnceForAllMaps) {
    const Folder folder;
    write_raw<std::uint8_t>(folder / "a.png", 1, 1, 3, {1, 2, 3});
    std::filesystem::create_directory(folder / "sub");
    scene::Scene scene = scene_with_map(folder / "a.png");
    scene.materials.push_back(scene_with_map(folder / "sub/../a.png").materials[0]);
    scene.materials[1].refl = scene.materials[0].map_Kd;
    load_textures(scene);
    ASSERT_TRUE(scene.materials[0].map_Kd[0].texture);
    EXPECT_EQ(scene.materials[0].map_Kd[0].texture, scene.materials[1].map_Kd[0].texture);
    EXPECT_EQ(scene.materials[0].map_Kd[0].texture, scene.materials[1].refl[0].texture);
}

TEST(LoadTextures, WarnsOnceOfAFileWithValuesAbove1) {
    const Folder folder;
    write_raw<float>(folder / "sky.exr", 2, 1, 3, {0.5f, 12.5f, 0, 1, 1, 1});
    write_raw<float>(folder / "plain.exr", 1, 1, 4, {1, 1, 1, 1});
    scene::Scene scene = scene_with_map(folder / "sky.exr");
    scene.materials[0].refl = scene.materials[0].map_Kd;
    scene.materials.push_back(scene_with_map(folder / "plain.exr").materials[0]);
    EXPECT_EQ(load_textures(scene),
              std::vector{"stone.mtl:12: map_Kd " + (folder / "sky.exr").string() +
                          ": has values to 12.5; expected 0 to 1, to which they are clamped"});
}

TEST(LoadTextures, KeepsWhatIsLoaded) {
    scene::Scene scene = scene_with_map("nowhere.png");
    scene.materials[0].map_Kd[0].texture = std::make_shared<Texture>();
    load_textures(scene);
}

}  // namespace gw::image
