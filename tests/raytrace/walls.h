// Scenes of rectangles for the tests of rays.
#pragma once

#include "gw/stages/vertex.h"
#include "scene/scene.h"
#include "scene/scene_builder.h"

namespace gw::raytrace {

class Walls {
public:
    scene::Scene scene;

    Walls() {
        scene.camera =
            scene::Camera{.eye = {0, 0, 5}, .at = {0, 0, 0}, .near_plane = 0.5, .far_plane = 50};
    }

    /// A quad with half axes u and v around `center`, seen counter-clockwise from u x v.
    scene::Material& add(const vec3& center, const vec3& u, const vec3& v) {
        const vec3 n(normalized(cross3(dvec3(u), dvec3(v))));
        MeshData quad{.primitive = Primitive::Quads,
                      .positions = {center - u - v, center + u - v, center + u + v, center - u + v},
                      .normals = {n, n, n, n}};
        scene.objects.push_back({.name = "wall " + std::to_string(scene.objects.size()),
                                 .mesh = scene::make_numbered_mesh(std::move(quad), next_),
                                 .material = scene.materials.size()});
        scene.materials.push_back({.Ka = vec3(0), .Kd = vec3(0)});
        return scene.materials.back();
    }

    /// The same that only shines.
    scene::Material& add_shining(const vec3& center, const vec3& u, const vec3& v, const vec3& Ke) {
        scene::Material& m = add(center, u, v);
        m.Ke = Ke;
        return m;
    }

private:
    std::uint32_t next_ = 0;
};

}  // namespace gw::raytrace
