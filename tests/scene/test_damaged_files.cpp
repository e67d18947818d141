// Claim: whatever bytes a scene's files hold, reading ends with a scene or with an Error of one
// line.
#include <gtest/gtest.h>

#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

#include <cstdint>

namespace gw::scene {
namespace {

const std::string obj =
    "mtllib m.mtl\no a b\nv 0 0 0\nv 1.5 0 0 1 0 0\nv 1 1e-7 0\nv -1 2 3\nvt 0 1\nvn 0 0 1\ns 1\nusemtl red\n"
    "f 1/1/1 2//1 \\\n 3/1 4\ng x\ns off\nf -1 -2 -3\nl 1 2 3\np 4\nvp 1\n";
const std::string mtl =
    "newmtl red\nKd 1 0 0\nNs 5\nd 0.5\nTr 0.5\nillum 2\nmap_Kd -s 1 2 -o 0 -clamp on a b.png\nrefl -type "
    "sphere x\nbump y\n";
const std::string toml =
    "background = [0.1, 1e-3, 0x1]\n[camera]\neye = [0, 0, 5]\nfov = 30\n[[light]]\nposition = [0, 1, "
    "0]\nonly = 'a b'\n"
    "[[object]]\nfile = 'm.obj'\nrotate = {axis = [0, 1, 0], degrees = 30}\nmaterial = {Kd = 0.5, map_Kd = "
    "['x', {file = 'y'}]}\n"
    "[[object]]\nshape = 'box'\nwidth = 2\n[material.q]\nd = 0.5\n";

// A few bytes replaced, removed or doubled; the seed says which.
std::string damaged(std::string text, std::uint32_t& seed) {
    const auto random = [&seed](std::size_t below) {
        seed = seed * 1664525 + 1013904223;
        return (seed >> 8) % below;
    };
    const std::string likely = "0-1./\\#\n\r \"'[]{}=,e\xff\xef\t\v9afvn";
    for (std::size_t n = 1 + random(3); n > 0 && !text.empty(); --n) {
        const std::size_t at = random(text.size());
        switch (random(3)) {
            case 0: text[at] = likely[random(likely.size())]; break;
            case 1: text.erase(at, 1 + random(8)); break;
            case 2: text.insert(at, text.substr(random(text.size()), 1 + random(16))); break;
        }
    }
    return text;
}

void damage(const std::string& name, const std::string& text, const std::string& scene) {
    Folder folder;
    folder.write("m.obj", obj);
    folder.write("m.mtl", mtl);
    folder.write("s.toml", toml);
    int errors = 0;
    for (std::uint32_t start = 0; start < 400; ++start) {
        std::uint32_t seed = start;
        folder.write(name, damaged(text, seed));
        const std::string message = folder.error([&] { read_scene(folder.path() / scene); });
        EXPECT_EQ(message.find('\n'), message.npos) << "seed " << start << ": " << message;
        errors += message != "no error";
    }
    EXPECT_GT(errors, 40);
    EXPECT_LT(errors, 400);
}

}  // namespace

TEST(DamagedFiles, OfObjStatements) { damage("m.obj", obj, "m.obj"); }
TEST(DamagedFiles, OfMtlStatements) { damage("m.mtl", mtl, "m.obj"); }
TEST(DamagedFiles, OfGltfFiles) { damage("m.gltf", triangle_gltf(), "m.gltf"); }
TEST(DamagedFiles, OfGlbFiles) {
    damage("m.glb", glb(triangle_json(""), triangle_bytes()), "m.glb");
}
TEST(DamagedFiles, OfTomlScenes) { damage("s.toml", toml, "s.toml"); }

}  // namespace gw::scene
