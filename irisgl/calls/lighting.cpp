// lmdef, lmbind, lmcolor and normals.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <string>

namespace gw::irisgl::calls {

namespace {

/// The values behind a word of a definition: 0 if there is no such word.
int count_of(int word) {
    switch (word) {
        case SHININESS:
        case ALPHA:
        case LOCALVIEWER:
        case TWOSIDE:
        case ATTENUATION2: return 1;
        case ATTENUATION:
        case SPOTLIGHT: return 2;
        case AMBIENT:
        case DIFFUSE:
        case SPECULAR:
        case EMISSION:
        case COLORINDEXES:
        case LCOLOR:
        case SPOTDIRECTION: return 3;
        case POSITION: return 4;
    }
    return 0;
}

vec4 color_at(Values v) { return {v[0], v[1], v[2], 1}; }

void set_material(Material& m, int word, Values v) {
    if (word == AMBIENT) m.ambient = color_at(v);
    if (word == DIFFUSE) m.diffuse = color_at(v);
    if (word == SPECULAR) m.specular = color_at(v);
    if (word == EMISSION) m.emission = color_at(v);
    if (word == SHININESS) m.shininess = v[0];
    if (word == ALPHA) m.alpha = v[0];
    if (word == COLORINDEXES) m.indices = {v[0], v[1], v[2]};
}

void set_light(Light& l, int word, Values v) {
    if (word == AMBIENT) l.ambient = color_at(v);
    if (word == LCOLOR) l.color = color_at(v);
    if (word == POSITION) l.position = {v[0], v[1], v[2], v[3]};
    if (word == SPOTDIRECTION) l.direction = {v[0], v[1], v[2], 0};
    if (word == SPOTLIGHT) {
        l.exponent = v[0];
        l.spread = v[1];
    }
}

void set_model(LightModel& m, int word, Values v) {
    if (word == AMBIENT) m.ambient = color_at(v);
    if (word == LOCALVIEWER) m.local_viewer = v[0] != 0;
    if (word == TWOSIDE) m.two_side = v[0] != 0;
    if (word == ATTENUATION) m.attenuation = {v[0], v[1]};
    if (word == ATTENUATION2) m.attenuation2 = v[0];
}

void define(short kind, short index, int word, Values v) {
    if (kind == DEFMATERIAL) set_material(program().materials[index], word, v);
    if (kind == DEFLIGHT) set_light(program().lights[index], word, v);
    if (kind == DEFLMODEL) set_model(program().models[index], word, v);
}

vec4 eye_from_object(const vec4& v) {
    if (state().matrix_mode == MSINGLE) return v;
    const dmat4& m = state().matrices.back();
    vec4 out;
    for (int k = 0; k < 4; ++k)
        out[k] = float(dot4({m[0][k], m[1][k], m[2][k], m[3][k]},
                            {double(v.x), double(v.y), double(v.z), double(v.w)}));
    return out;
}

/// A bound light's new place or direction is turned by the matrix of now, as at lmbind.
void turn_bound(short index, int word) {
    if (program().current == nullptr) return;
    Bound& b = state().bound;
    const Light& light = program().lights[index];
    for (std::size_t i = 0; i < b.lights.size(); ++i) {
        if (b.lights[i] != index) continue;
        if (word == POSITION) b.positions[i] = eye_from_object(light.position);
        if (word == SPOTDIRECTION) b.directions[i] = eye_from_object(light.direction);
    }
}

/// A definition that is bound changes what is drawn next.
void apply_bound(short kind, short index) {
    if (program().current == nullptr) return;
    const Bound& b = state().bound;
    if (kind == DEFMATERIAL && (b.material == index || b.back_material == index))
        apply_color_mode();
    if (kind == DEFLMODEL && b.model == index) apply_light_model();
    for (int i = 0; kind == DEFLIGHT && i < light_count; ++i)
        if (b.lights[std::size_t(i)] == index) apply_light(i);
}

/// "LMNULL as the first word resets the definition."
template <class Definition>
void begin_definition(Definition& definition, Values props) {
    if (props.empty() || props[0] == LMNULL) definition = {};
}

void bind_light(int number, short index) {
    Bound& b = state().bound;
    const std::size_t i = std::size_t(number);
    b.lights[i] = index;
    const Light& light = program().lights[index];
    b.positions[i] = eye_from_object(light.position);
    b.directions[i] = eye_from_object(light.direction);
    apply_light(number);
}

bool is_defined(short target, short index) {
    if (index == 0) return true;
    if (target == MATERIAL || target == BACKMATERIAL) return program().materials.contains(index);
    if (target == LMODEL) return program().models.contains(index);
    return program().lights.contains(index);
}

}  // namespace

void define_light(short kind, short index, Values props) {
    const bool is_kind = kind == DEFMATERIAL || kind == DEFLIGHT || kind == DEFLMODEL;
    if (!is_kind || index <= 0)
        return warn(
            "lmdef: definition " + std::to_string(index) + " of kind " + std::to_string(kind) +
            "; expected DEFMATERIAL, DEFLIGHT or DEFLMODEL and an index from 1; it is ignored");
    if (kind == DEFMATERIAL) begin_definition(program().materials[index], props);
    if (kind == DEFLIGHT) begin_definition(program().lights[index], props);
    if (kind == DEFLMODEL) begin_definition(program().models[index], props);
    for (std::size_t i = 0; i < props.size();) {
        const int word = int(props[i]), count = count_of(word);
        if (word == 0) break;
        if (count == 0 || i + std::size_t(count) >= props.size() + 0u) {
            warn("lmdef: property " + std::to_string(word) +
                 " is not known or cut short; it and what "
                 "follows are ignored");
            break;
        }
        define(kind, index, word, props.subspan(i + 1, std::size_t(count)));
        if (kind == DEFLIGHT) turn_bound(index, word);
        i += std::size_t(count) + 1;
    }
    apply_bound(kind, index);
}

void lmbind(short target, short index) {
    Bound& b = state().bound;
    const bool light = target >= LIGHT0 && target <= LIGHT7;
    if (!light && target != MATERIAL && target != BACKMATERIAL && target != LMODEL)
        return warn("lmbind: target " + std::to_string(target) + " is not known; it is ignored");
    if (!is_defined(target, index)) index = 0;
    if (light) return bind_light(target - LIGHT0, index);
    if (target == MATERIAL) b.material = index;
    if (target == BACKMATERIAL) b.back_material = index;
    if (target == LMODEL) {
        b.model = index;
        return apply_light_model();
    }
    apply_color_mode();
}

void lmcolor(long mode) {
    if (mode < LMC_COLOR || mode > LMC_NULL)
        return warn("lmcolor: " + std::to_string(mode) +
                    "; expected LMC_COLOR to LMC_NULL; it is ignored");
    state().bound.color_mode = mode;
    apply_color_mode();
}

void normal(float x, float y, float z) {
    state().normal = {x, y, z};
    state().is_lit = true;
}

}  // namespace gw::irisgl::calls
