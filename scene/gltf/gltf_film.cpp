#include "scene/gltf/gltf_film.h"

#include "gw/base/elementary.h"
#include "gw/error.h"
#include "scene/geometry/transform.h"
#include "scene/gltf/accessors.h"
#include "scene/gltf/gltf_camera.h"
#include "scene/gltf/read_gltf.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gw::scene {
namespace {

struct Channel {
    std::size_t node = 0;  ///< into the list of placed_nodes
    enum Path { Translation, Rotation, Scale, Weights } path = Translation;
    Keys keys;
};

/// `type`: of an element; of SCALAR, `width` elements are one value.
Keys read_keys(const GltfDocument& document, const JsonValue& sampler, std::size_t width,
               const char* type) {
    Keys keys{.width = width};
    const JsonValue input = sampler.at("input"), output = sampler.at("output");
    for (const float time : read_floats(document, input, {"SCALAR"}).numbers) {
        if (time < 0 || (!keys.times.empty() && double(time) <= keys.times.back()))
            input.fail("has no increasing times from 0; expected such");
        keys.times.push_back(double(time));
    }
    const Elements<float> values = read_floats(document, output, {type});
    const auto word = sampler.find("interpolation");
    const std::string kind = word ? word->text() : "LINEAR";
    if (kind == "STEP") keys.interpolation = Interpolation::Step;
    if (kind == "CUBICSPLINE") keys.interpolation = Interpolation::Smooth;
    if (kind != "STEP" && kind != "LINEAR" && kind != "CUBICSPLINE")
        word->fail_expected("STEP, LINEAR or CUBICSPLINE");
    const bool cubic = keys.interpolation == Interpolation::Smooth;
    const std::size_t tuples = keys.times.size() * (cubic ? 3 : 1),
                      expected = tuples * width / values.components;
    if (values.count() != expected)
        output.fail("has " + std::to_string(values.count()) + " elements; expected " +
                    std::to_string(expected) + " for " + std::to_string(keys.times.size()) +
                    " times");
    std::vector<double>* const lists[] = {&keys.slopes_in, &keys.values, &keys.slopes_out};
    for (std::size_t i = 0; i < tuples; ++i)
        for (std::size_t k = 0; k < width; ++k)
            (cubic ? lists[i % 3] : &keys.values)->push_back(double(values.numbers[i * width + k]));
    return keys;
}

/// The morph targets of a node's mesh.
std::size_t targets_of(const GltfDocument& document, const JsonValue& node) {
    const auto mesh = node.find("mesh");
    if (!mesh) return 0;
    const JsonValue primitives = document.element("meshes", *mesh).at("primitives");
    const auto targets = primitives.size() ? primitives[0].find("targets") : std::nullopt;
    return targets ? targets->size() : 0;
}

/// None for what is left out, with a warning.
std::optional<Channel> read_channel(const GltfDocument& document, const JsonValue& animation,
                                    const JsonValue& json, const std::vector<std::size_t>& placed) {
    const JsonValue target = json.at("target"), path = target.at("path");
    const auto node = target.find("node");
    constexpr std::array paths{"translation", "rotation", "scale", "weights"};
    constexpr std::array types{"VEC3", "VEC4", "VEC3", "SCALAR"};
    const auto found = std::ranges::find(paths, path.text());
    const std::size_t targets = node ? targets_of(document, document.element("nodes", *node)) : 0;
    if (!node || found == paths.end() || (found == paths.begin() + 3 && targets == 0)) {
        document.warn("channel", "an animation of " + path.text() + " is left out");
        return std::nullopt;
    }
    const JsonValue owner = document.element("nodes", *node);
    Channel channel;
    channel.path = Channel::Path(found - paths.begin());
    if (channel.path != Channel::Weights && owner.find("matrix"))
        owner.fail("has a matrix and is animated; expected translation, rotation and scale");
    const JsonValue samplers = animation.at("samplers"), index = json.at("sampler");
    if (samplers.size() == 0) index.fail_expected("an index into samplers, which are none");
    channel.node = placed[node->whole(0, placed.size() - 1)];
    channel.keys = read_keys(document, samplers[index.whole(0, samplers.size() - 1)],
                             channel.path == Channel::Weights    ? targets
                             : channel.path == Channel::Rotation ? 4
                                                                 : 3,
                             types[channel.path]);
    if (channel.node == GltfNode::no_parent) return std::nullopt;  // not in the scene
    return channel;
}

/// [GLTF2 C.4]: along the shorter arc.
dvec4 slerp(const dvec4& a, dvec4 b, double t) {
    double cosine = dot4(a, b);
    if (cosine < 0) b = -b;
    cosine = std::min(std::abs(cosine), 1.0);
    const double angle = acos(cosine), s = sin(angle);
    if (s < 1e-6) return a + (b - a) * t;
    return a * (sin((1 - t) * angle) / s) + b * (sin(t * angle) / s);
}

dvec4 quaternion(const double* v) { return {v[0], v[1], v[2], v[3]}; }

dvec4 rotation_at(const Keys& keys, double time) {
    const auto after = std::size_t(std::ranges::upper_bound(keys.times, time) - keys.times.begin());
    dvec4 q = quaternion(keys.at(time).data());
    if (keys.interpolation == Interpolation::Linear && after > 0 && after < keys.times.size()) {
        const double begin = keys.times[after - 1], end = keys.times[after];
        q = slerp(quaternion(&keys.values[4 * (after - 1)]), quaternion(&keys.values[4 * after]),
                  (time - begin) / (end - begin));
    }
    const double size = std::sqrt(dot4(q, q));
    return size > 0 ? q / size : dvec4(0, 0, 0, 1);
}

void set(GltfPlace& place, const Channel& channel, double time) {
    if (channel.path == Channel::Rotation) {
        place.rotation = rotation_at(channel.keys, time);
        return;
    }
    const std::vector<double> v = channel.keys.at(time);
    (channel.path == Channel::Scale ? place.scale : place.translation) = {v[0], v[1], v[2]};
}

/// The scene at rest, which all films of a file share.
struct Rest {
    std::vector<GltfNode> nodes;
    GltfHolders holders;
    dvec3 origin;
};

class NodePosing {
public:
    NodePosing(std::shared_ptr<const Rest> rest, std::vector<Channel> channels)
        : rest_(std::move(rest)), channels_(std::move(channels)) {}

    void operator()(Scene& scene, double time) const {
        std::vector<GltfNode> nodes = rest_->nodes;
        const GltfHolders& holders = rest_->holders;
        for (const Channel& channel : channels_)
            if (channel.path != Channel::Weights) set(nodes[channel.node].place, channel, time);
        place_in_world(nodes);
        for (GltfNode& node : nodes) node.world_from_node[3] -= dvec4(rest_->origin, 0);
        for (std::size_t i = 0; i < holders.objects.size() && i < scene.objects.size(); ++i)
            scene.objects[i].world_from_object =
                drawable(nodes[holders.objects[i]].world_from_node * holders.node_from_object[i]);
        for (const GltfShaped& shaped : holders.shaped)
            if (shaped.object < scene.objects.size())
                reshape(scene.objects[shaped.object], shaped, nodes, time);
        for (std::size_t i = 0; i < holders.lights.size() && i < scene.lights.size(); ++i) {
            const dmat4& world = nodes[holders.lights[i]].world_from_node;
            scene.lights[i].position = vec3(dvec3(world[3]));
            scene.lights[i].direction = light_direction(world);
        }
        if (holders.camera && scene.camera)
            place_camera(*scene.camera, nodes[*holders.camera].world_from_node);
    }

private:
    void reshape(Object& object, GltfShaped shaped, const std::vector<GltfNode>& nodes,
                 double time) const {
        shaped.base -= rest_->origin;
        for (const Channel& channel : channels_)
            if (channel.path == Channel::Weights && channel.node == shaped.node)
                shaped.weights = channel.keys.at(time);
        std::optional<MeshData> mesh = posed(shaped, nodes, object.mesh->data().polygon_ids);
        if (!mesh)
            throw Error("object '" + printable(object.name) +
                        "' has a vertex beyond 1e18; expected less");
        object.mesh = make_mesh(*std::move(mesh));
        if (shaped.skin) object.world_from_object = translation(shaped.base);
    }

    std::shared_ptr<const Rest> rest_;
    std::vector<Channel> channels_;
};

/// Adds the numbers of its keys to `numbers`.
std::vector<Channel> read_channels(const GltfDocument& document, const JsonValue& animation,
                                   const std::vector<std::size_t>& placed, std::size_t& numbers) {
    const JsonValue list = animation.at("channels");
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < list.size(); ++i) {
        auto channel = read_channel(document, animation, list[i], placed);
        if (!channel) continue;
        numbers += channel->keys.times.size() + 3 * channel->keys.values.size();
        if (numbers > most_gltf_numbers)
            list[i].fail("and those before it have more than " + std::to_string(most_gltf_numbers) +
                         " numbers; expected fewer");
        channels.push_back(std::move(*channel));
    }
    return channels;
}

}  // namespace

std::vector<Film> read_gltf_films(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                                  const GltfHolders& holders, const dvec3& origin) {
    const std::size_t count = document.count("animations");
    if (count == 0) return {};
    const std::vector<std::size_t> placed = places_of(document, nodes);
    const auto rest = std::make_shared<const Rest>(Rest{nodes, holders, origin});
    std::vector<Film> films;
    std::size_t numbers = 0;
    bool moves = false;
    for (std::size_t i = 0; i < count; ++i) {
        const JsonValue animation = document.root().at("animations")[i];
        const auto name = animation.find("name");
        Film film{.name = name ? name->text() : ""};
        std::vector<Channel> channels = read_channels(document, animation, placed, numbers);
        for (const Channel& channel : channels)
            film.seconds = std::max(film.seconds, channel.keys.times.back());
        moves = moves || !channels.empty();
        film.pose = NodePosing(rest, std::move(channels));
        films.push_back(std::move(film));
    }
    if (!moves) return {};
    return films;
}

}  // namespace gw::scene
