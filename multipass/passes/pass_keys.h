// The keys of [[pass]], each named once: what reads them and what writes them go through the same
// functions.
// Does neither itself: read_passes.cpp and write_passes.cpp do.
#pragma once

#include "multipass/passes/pass.h"

namespace gw::multipass {

/// [[pass]]. `keys` has a function for each kind of value; a table stands for a switch that is on.
template <typename Keys, typename PassOrConst>
void pass_keys(Keys& keys, PassOrConst& pass) {
    keys.name("name", pass.name);
    keys.word("action", pass.action);
    keys.planes("clear", pass.clear);
    keys.parameter("Ka", pass.material.Ka);
    keys.parameter("Kd", pass.material.Kd);
    keys.parameter("Ks", pass.material.Ks);
    keys.parameter("Ke", pass.material.Ke);
    keys.word("Map", pass.material.Map);
    keys.table("depth", pass.depth.test, pass.depth, [](auto& k, auto& depth) {
        k.word("func", depth.func);
        k.flag("mask", depth.mask);
    });
    const auto stencil_face = [](auto& k, auto& face) {
        k.word("func", face.func);
        k.number("ref", face.ref);
        k.number("mask", face.mask);
        k.word("fail", face.fail);
        k.word("zfail", face.zfail);
        k.word("zpass", face.zpass);
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
    keys.word("fog", pass.fog);
    keys.word("lights", pass.lights);
    keys.objects("objects", pass.objects, pass.names);
}

}  // namespace gw::multipass
