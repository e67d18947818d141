// A window full of small quads, each a separate draw, and the differences between the draws. Does
// not draw.
#pragma once

#include "gw/command_list.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw::draws {

inline constexpr int width = 640, height = 480, quad_side = 8;

struct Quad {
    float x = 0, y = 0, z = 0;  ///< lower left corner in pixels; z in -1 .. 1
    vec3 color{1};
};
std::vector<Quad> quads(int count);

/// The part of a draw that is its own, besides its vertices.
enum class Own { Nothing, Matrix, Material, State, Texture, All };
inline constexpr std::array every_own{Own::Nothing, Own::Matrix,  Own::Material,
                                      Own::State,   Own::Texture, Own::All};
const char* name_of(Own own);

/// All states differ in their tests or writes; all textures in their texels.
inline constexpr int state_count = 8, texture_count = 1000, texture_side = 8;
DepthFunc depth_func_of(int state);
bool blends(int state);
bool has_depth_mask(int state);
std::vector<std::uint8_t> texels_of(int texture);

inline bool has_own_matrix(Own own) { return own == Own::Matrix || own == Own::All; }
inline bool has_own_material(Own own) { return own == Own::Material || own == Own::All; }
inline bool has_own_state(Own own) { return own == Own::State || own == Own::All; }
inline bool is_textured(Own own) { return own == Own::Texture; }

/// The light that shines on materials: directional, in eye space.
Light lamp();

/// The field as draws of the machine. `shift` moves everything by less than a picture shows, so
/// that the machine has kept nothing of it.
class Ours {
public:
    explicit Ours(int count);
    CommandList draws(Own own, double shift) const;
    CommandList merged(double shift) const;

private:
    State view() const;
    MeshRef quad_mesh(const Quad& quad, Own own, double shift) const;

    std::vector<Quad> quads_;
    std::vector<TextureRef> textures_;
    LightsRef lights_;
    MeshRef shared_;
};

}  // namespace gw::draws
