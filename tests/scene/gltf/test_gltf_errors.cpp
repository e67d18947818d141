// Claims: each malformed glTF file is one message with its place in the JSON, what is wrong and what
// was expected.
#include <gtest/gtest.h>

#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

#include <limits>

namespace gw::scene {
namespace {

struct GltfError : testing::Test {
    Folder folder;
    std::string of(const std::string& text) { return folder.scene_error("m.gltf", text); }
    /// Of the triangle with a word replaced.
    std::string with(const std::string& from, const std::string& to) {
        return of(replaced(triangle_gltf(), from, to));
    }
    std::string of_glb(const std::string& bytes) { return folder.scene_error("m.glb", bytes); }
};

}  // namespace

TEST_F(GltfError, TextsThatAreNone) {
    EXPECT_EQ(
        of("{"),
        "m.gltf:1: is no JSON: syntax error while parsing object key - unexpected end of input; expected string literal; expected glTF 2.0");
    EXPECT_EQ(of("[]"), "m.gltf: is an array; expected an object");
    EXPECT_EQ(of("{}"), "m.gltf: has no asset; expected one");
    EXPECT_EQ(with("\"2.0\"", "\"1.0\""),
              "m.gltf: asset.version is '1.0'; expected 2.0: other versions of glTF are not read");
    EXPECT_EQ(with("\"2.0\"", "\"2.1\", \"minVersion\": \"2.1\""),
              "m.gltf: asset.minVersion is '2.1'; expected 2.0: a later version is not read");
    EXPECT_EQ(of(R"({"asset": {"version": "2.0"}})"),
              "m.gltf: has nothing to draw; expected a scene with a node that has a mesh");
    EXPECT_EQ(of(std::string(200000, '[')).substr(0, 20), "m.gltf:1: is no JSON");
}

TEST_F(GltfError, LyingGlbFiles) {
    const std::string whole = glb(triangle_json(""), triangle_bytes());
    EXPECT_EQ(of_glb(whole), "no error");
    EXPECT_EQ(of_glb(whole.substr(0, 100)), "m.glb: is cut off: it has 100 bytes; expected " +
                                                std::to_string(whole.size()) +
                                                " as its header says");
    EXPECT_EQ(of_glb("glTF" + word_bytes(2)),
              "m.glb: is a GLB of 8 bytes; expected a header and JSON");
    EXPECT_EQ(of_glb("glTF" + word_bytes(1) + whole.substr(8)),
              "m.glb: is a GLB of version 1; expected 2");
    EXPECT_EQ(of_glb(whole.substr(0, 12) + word_bytes(0xFFFFFFFF) + whole.substr(16)),
              "m.glb: chunk 0 has 4294967295 bytes; expected at most " +
                  std::to_string(whole.size() - 20) + " to the end of the file");
    EXPECT_EQ(of_glb(whole.substr(0, 16) + "BLOB" + whole.substr(20)),
              "m.glb: chunk 0 is no JSON; expected type 'JSON'");
    EXPECT_EQ(of_glb(glb(triangle_json(""), "")),
              "m.glb: buffers[0].byteLength is 42; expected at most 0, which the buffer has");
}

TEST_F(GltfError, BuffersThatAreNotThere) {
    EXPECT_EQ(of(triangle_json("")),
              "m.gltf: buffers[0] has no uri; expected one, or a GLB file with a second chunk");
    EXPECT_EQ(of(triangle_json(R"(, "uri": "x.bin")")),
              "m.gltf: buffers[0].uri 'x.bin' does not exist; expected a file");
    for (const std::string uri : {"/etc/passwd", "http://a.b/c.bin", "file:///c", "C:/c.bin"})
        EXPECT_EQ(of(triangle_json(", \"uri\": \"" + uri + "\"")),
                  "m.gltf: buffers[0].uri is '" + uri +
                      "'; expected the name of a file, relative to this one");
    EXPECT_EQ(
        of(triangle_json(R"(, "uri": "data:;base64,QUJ")")),
        "m.gltf: buffers[0].uri is no base64 text; expected groups of four of its 64 characters");
    EXPECT_EQ(
        of(triangle_json(R"(, "uri": "data:text/plain,ABC")")),
        "m.gltf: buffers[0].uri is a data URI of another kind; expected data:TYPE;base64,TEXT");
    EXPECT_EQ(
        with("\"byteLength\": 42", "\"byteLength\": 4294967296"),
        "m.gltf: buffers[0].byteLength is 4294967296; expected at most 42, which the buffer has");
}

TEST_F(GltfError, AccessorsBeyondTheirBuffers) {
    EXPECT_EQ(with("\"byteOffset\": 36", "\"byteOffset\": -4"),
              "m.gltf: bufferViews[1].byteOffset is -4; expected a whole number from 0 to 42");
    EXPECT_EQ(with("\"byteLength\": 36", "\"byteLength\": 43"),
              "m.gltf: bufferViews[0].byteLength is 43; expected a whole number from 1 to 42");
    EXPECT_EQ(
        with("\"count\": 3, \"type\": \"VEC3\"", "\"count\": 4, \"type\": \"VEC3\""),
        "m.gltf: accessors[0] has 4 elements; expected at most 3, which its buffer view holds");
    EXPECT_EQ(
        with("\"count\": 3, \"type\": \"VEC3\"", "\"count\": 4294967296, \"type\": \"VEC3\""),
        "m.gltf: accessors[0].count is 4294967296; expected a whole number from 1 to 268435456");
    EXPECT_EQ(with("\"count\": 3, \"type\": \"VEC3\"", "\"count\": 1.5, \"type\": \"VEC3\""),
              "m.gltf: accessors[0].count is 1.5; expected a whole number from 1 to 268435456");
    EXPECT_EQ(
        with("{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3",
             "{\"componentType\": 5126, \"count\": 20000000"),
        "m.gltf: accessors[0] has 20000000 elements without a bufferView; expected at most 16777216");
    EXPECT_EQ(
        with("\"componentType\": 5126", "\"componentType\": 5124"),
        "m.gltf: accessors[0].componentType is 5124; expected 5120, 5121, 5122, 5123, 5125 or 5126");
    EXPECT_EQ(with("\"type\": \"VEC3\"", "\"type\": \"VEC2\""),
              "m.gltf: accessors[0].type is 'VEC2'; expected VEC3");
    EXPECT_EQ(with("\"byteLength\": 36", "\"byteLength\": 36, \"byteStride\": 8"),
              "m.gltf: bufferViews[0].byteStride is 8; expected a whole number from 12 to 252");
    EXPECT_EQ(
        with("\"POSITION\": 0", "\"POSITION\": 7"),
        "m.gltf: meshes[0].primitives[0].attributes.POSITION is 7; expected a whole number from 0 to 1");
    EXPECT_EQ(with("\"indices\": 1", "\"indices\": 0"),
              "m.gltf: accessors[0].type is 'VEC3'; expected SCALAR");
}

TEST_F(GltfError, NumbersThatAreWrong) {
    const auto with_bytes = [&](const std::string& bytes) {
        return of(triangle_json(", \"uri\": \"" + data_uri(bytes) + "\""));
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::string indices = triangle_bytes().substr(36);
    EXPECT_EQ(with_bytes(bytes_of<float>({0, 0, 0, 2, 0, nan, 0, 3, 0}) + indices),
              "m.gltf: accessors[0] is not finite at element 1; expected finite numbers");
    EXPECT_EQ(
        with_bytes(bytes_of<float>({0, 0, 0, 2, 0, 1e30f, 0, 3, 0}) + indices),
        "m.gltf: meshes[0].primitives[0].attributes.POSITION is beyond 1e18 at element 1; expected less");
    EXPECT_EQ(
        with_bytes(triangle_bytes().substr(0, 36) + bytes_of<std::uint16_t>({0, 1, 3})),
        "m.gltf: meshes[0].primitives[0].indices has index 3 at 2; expected less than 3, the number of vertices");
    EXPECT_EQ(with("\"mesh\": 0", "\"mesh\": 0, \"translation\": [0, 1e400, 0]"),
              "m.gltf: is no JSON: a number is beyond 1e308; expected glTF 2.0");
    EXPECT_EQ(with("\"mesh\": 0", "\"mesh\": 0, \"translation\": [0, 1e30, 0]"),
              "m.gltf: nodes[0].translation[1] is 1e+30; expected a number from -1e+18 to 1e+18");
    EXPECT_EQ(with("\"mesh\": 0", "\"mesh\": 0, \"rotation\": [0, 0, 0, 0]"),
              "m.gltf: nodes[0].rotation is 0; expected a quaternion of length 1");
    EXPECT_EQ(with("\"mesh\": 0", "\"mesh\": 0, \"matrix\": [1]"),
              "m.gltf: nodes[0].matrix has 1 elements; expected 16");
}

TEST_F(GltfError, NodesThatAreNoTree) {
    const std::string expected = "has two parents, or is in a circle; expected a tree of nodes";
    EXPECT_EQ(with("\"mesh\": 0", "\"mesh\": 0, \"children\": [0]"),
              "m.gltf: nodes[0] " + expected);
    EXPECT_EQ(with("\"nodes\": [0]", "\"nodes\": [0, 0]"), "m.gltf: nodes[0] " + expected);
    EXPECT_EQ(with("\"nodes\": [0]", "\"nodes\": [1]"),
              "m.gltf: scenes[0].nodes[0] is 1; expected a whole number from 0 to 0");
    EXPECT_EQ(with("\"mesh\": 0", "\"mesh\": 3"),
              "m.gltf: nodes[0].mesh is 3; expected a whole number from 0 to 0");
}

TEST_F(GltfError, ExtensionsThatAreNeeded) {
    EXPECT_EQ(
        with("\"scene\": 0", R"("scene": 0, "extensionsRequired": ["KHR_draco_mesh_compression"])"),
        "m.gltf: extensionsRequired[0] is 'KHR_draco_mesh_compression'; expected only extensions that GW reads: a file without this one");
}

TEST_F(GltfError, ShortFilesThatAskForMuchMemory) {
    // A thousand primitives of 16 million vertices that have no bytes.
    std::string one = R"({"attributes": {"POSITION": 0}})", many = one;
    for (int i = 1; i < 1000; ++i) many += ", " + one;
    std::string text =
        replaced(triangle_gltf(), R"({"attributes": {"POSITION": 0}, "indices": 1})", many);
    text = replaced(text, R"("bufferView": 0, "componentType": 5126, "count": 3)",
                    R"("componentType": 5126, "count": 60000)");
    EXPECT_EQ(
        of(replaced(text, "60000", "16777217")),
        "m.gltf: accessors[0] has 16777217 elements without a bufferView; expected at most 16777216");
    EXPECT_EQ(
        of(replaced(text, "60000", "200000000")),
        "m.gltf: meshes[0].primitives[0] and those before it have more than 134217728 elements; expected fewer");
}

}  // namespace gw::scene
