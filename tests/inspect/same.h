// Equality of recordings by content: meshes, maps and lights are compared by value.
#pragma once

#include "inspect/recording/content.h"
#include "inspect/recording/recording.h"
#include "tests/fuzz/suites.h"

namespace gw::inspect {

inline bool same(const MeshRef& a, const MeshRef& b) { return a->data() == b->data(); }
inline bool same(const TextureRef& a, const TextureRef& b) {
    return a == b ||
           (a && b && a->name == b->name && a->levels == b->levels && a->format == b->format &&
            a->dimensions == b->dimensions && a->border == b->border &&
            a->given_levels == b->given_levels && a->cube == b->cube && a->depths == b->depths);
}
/// Of units 1 and up.
inline bool same(const std::shared_ptr<const MoreBindings>& a,
                 const std::shared_ptr<const MoreBindings>& b) {
    return a == b || (a && b &&
                      std::equal(a->begin(), a->end(), b->begin(),
                                 [](const TextureBinding& x, TextureBinding y) {
                                     if (!same(x.texture, y.texture)) return false;
                                     y.texture = x.texture;
                                     return x == y;
                                 }));
}
inline bool same(const LightsRef& a, const LightsRef& b) { return a == b || (a && b && *a == *b); }

inline bool same_value(const auto& a, const auto& b) { return a == b || (a && b && *a == *b); }

inline bool same(const Command& a, const Command& b) {
    if (a.index() != b.index()) return false;
    if (const auto* drawn = std::get_if<DrawPixels>(&a)) {
        DrawPixels other = std::get<DrawPixels>(b);
        if (!same(drawn->map.texture, other.map.texture) ||
            !same(drawn->more_maps, other.more_maps))
            return false;
        other.map.texture = drawn->map.texture;
        other.more_maps = drawn->more_maps;
        return *drawn == other;
    }
    const auto* x = std::get_if<Draw>(&a);
    if (!x) return a == b;
    Draw y = std::get<Draw>(b);
    if (!same(x->mesh, y.mesh) || !same(x->map.texture, y.map.texture) ||
        !same(x->more_maps, y.more_maps) || !same(x->lights, y.lights) ||
        !same_value(x->back_material, y.back_material) || !same_value(x->current, y.current))
        return false;
    y.mesh = x->mesh;
    y.map.texture = x->map.texture;
    y.more_maps = x->more_maps;
    y.lights = x->lights;
    y.back_material = x->back_material;
    y.current = x->current;
    return *x == y;
}

inline bool same(const CommandList& a, const CommandList& b) {
    return std::equal(a.commands.begin(), a.commands.end(), b.commands.begin(), b.commands.end(),
                      [](const Command& x, const Command& y) { return same(x, y); });
}

/// One list on a machine of 1 x 1 pixels.
inline Recording recording_of(const Command& command) {
    Recording recording;
    recording.width = recording.height = 1;
    recording.lists.push_back({{command}});
    return recording;
}

/// A random case as a recording of one list.
inline Recording recording_of(const fuzz::Case& c) {
    Recording recording;
    recording.producer = "test";
    recording.scene = "case";
    recording.renderer = "fuzz";
    recording.profile = c.profile;
    recording.width = c.width;
    recording.height = c.height;
    recording.sets = {{"a", "(Ka=1)"}};
    recording.lists = {c.list};
    return recording;
}

}  // namespace gw::inspect
