// Values at the vertices of a geometry set: colours, fog, texture coordinates. Groups of its parts
// share them, and so do draws with equal inputs. Does not interpolate.
#pragma once

#include "gw/fast/vertices/geometry.h"
#include "gw/fast/vertices/unset_vector.h"

#include <cstddef>
#include <vector>

namespace gw {
struct Draw;
}

namespace gw::fast {

/// The draws of a group's parts, and their state.
struct GroupDraws {
    const PartGroup& group;
    const State* state = nullptr;
    const Draw* const* draws = nullptr;  ///< one for each part of the group
    std::size_t unit = 0;                ///< of texture coordinates
};

/// Whether two states and two draws of one part have the same values of a kind.
struct SameValues {
    bool (*of_states)(const State& a, const State& b, std::size_t unit);
    bool (*of_draws)(const Draw& a, const Draw& b, const State& state, std::size_t unit);
};
extern const SameValues same_colors, same_fog, same_texcoords;

/// The draws of a set's parts, and their states.
struct VertexInputs {
    const GeometrySet* set = nullptr;
    const State* first = nullptr;      ///< a state with the same lists of values as all of them
    const State* newest = nullptr;     ///< of the group that was added last
    std::vector<const Draw*> draws;    ///< one for each part; null: it needs no values
    std::vector<const State*> states;  ///< of the draws, or one that has the same values
    std::size_t unit = 0;              ///< of texture coordinates

    void begin(const GroupDraws& group);
    void add(const GroupDraws& group, const SameValues& same);
    /// Whether the group can be added: no part of it has a draw yet.
    bool has_room_for(const GroupDraws& group) const;
    /// Whether the parts of the group have its values. Lights are compared by value.
    bool has_values_of(const GroupDraws& group, const SameValues& same) const;
};

/// By vertex of the set; a list that no draw needs is empty.
struct VertexColors {
    VertexInputs inputs;
    std::vector<Rgba> front, back;
    std::vector<Rgba> secondary, back_secondary;
    /// by part: each primitive has one colour
    std::vector<std::uint8_t> uniform;

    void clear() {
        front.clear();
        back.clear();
        secondary.clear();
        back_secondary.clear();
        uniform.clear();
    }
    std::size_t bytes() const {
        return (front.capacity() + back.capacity() + secondary.capacity() +
                back_secondary.capacity()) *
               sizeof(Rgba);
    }
    /// The colours of a primitive's visible side.
    const std::vector<Rgba>& of(const SetupPrimitive& p) const {
        return p.front || back.empty() ? front : back;
    }
    const std::vector<Rgba>& secondary_of(const SetupPrimitive& p) const {
        return p.front || back_secondary.empty() ? secondary : back_secondary;
    }
    bool is_uniform(const PartGroup& group) const;
};
struct VertexFog {
    VertexInputs inputs;
    /// the factor; with fog per fragment, the coordinate in the fog table
    std::vector<double> value;

    void clear() { value.clear(); }
    std::size_t bytes() const { return value.capacity() * sizeof(double); }
};
struct VertexTexcoords {
    VertexInputs inputs;
    UnsetVector<dvec4>
        strq;               ///< at least as many; those of vertices that nothing uses are arbitrary
    bool are_wide = false;  ///< s or t of a primitive (R9.19)

    void clear() {}
    std::size_t bytes() const { return strq.capacity() * sizeof(dvec4); }
};

/// Each fills an object that has its inputs.
void shade_vertices(VertexColors& colors, const Profile& profile);
void fog_vertices(VertexFog& fog, const Profile& profile);
void texture_vertices(VertexTexcoords& texcoords, const Profile& profile);

}  // namespace gw::fast
