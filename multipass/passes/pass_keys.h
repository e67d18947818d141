// The keys of [[pass]], each named once: reader and writer share these functions. Does not read or
// write (read_passes.cpp, write_passes.cpp).
#pragma once

#include "multipass/passes/pass.h"

namespace gw::multipass {

/// [[pass]]. `keys` has a function for each kind of value; a table stands for a switch that is on.
template <typename Keys, typename PassOrConst>
void pass_keys(Keys& keys, PassOrConst& pass) {
    keys.name("name", pass.name);
    keys.token("action", pass.action);
    keys.planes("clear", pass.clear);
    keys.parameter("Ka", pass.material.Ka);
    keys.parameter("Kd", pass.material.Kd);
    keys.parameter("Ks", pass.material.Ks);
    keys.parameter("Ke", pass.material.Ke);
    keys.token("Map", pass.material.Map);
    keys.table("depth", pass.depth.test, pass.depth, [](auto& k, auto& depth) {
        k.token("func", depth.func);
        k.flag("mask", depth.mask);
    });
    const auto stencil_face = [](auto& k, auto& face) {
        k.token("func", face.func);
        k.number("ref", face.ref);
        k.number("mask", face.mask);
        k.token("fail", face.fail);
        k.token("zfail", face.zfail);
        k.token("zpass", face.zpass);
        k.number("write_mask", face.write_mask);
    };
    keys.table("stencil", pass.stencil.test, pass.stencil, [&](auto& k, auto& stencil) {
        stencil_face(k, stencil);
        k.table("back", stencil.two_side, stencil.back, stencil_face);
    });
    keys.table("blend", pass.blend.enable, pass.blend, [](auto& k, auto& blend) {
        k.source("src", blend.src);
        k.destination("dst", blend.dst);
    });
    keys.flag("color", pass.color);
    keys.token("fog", pass.fog);
    keys.token("lights", pass.lights);
    keys.objects("objects", pass.objects, pass.names);
}

}  // namespace gw::multipass
