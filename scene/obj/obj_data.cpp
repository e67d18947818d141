#include "scene/obj/obj_data.h"

#include "gw/base/cancel.h"
#include "gw/error.h"

#include <algorithm>
#include <bit>

namespace gw::scene {
namespace {

std::uint64_t hash(const Corner& corner) {
    std::uint64_t h = 0;
    for (const std::uint32_t index : {corner.v, corner.vt, corner.vn}) {
        h = (h ^ index) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
    }
    return h;
}

// Numbers the different corners of one part in the order they come.
class Vertices {
public:
    /// Begins a part of at most this many corners.
    void begin(std::size_t most) {
        corners_.clear();
        mask_ = std::bit_ceil(2 * most + 1) - 1;
        slots_.assign(mask_ + 1, absent);
    }
    std::uint32_t index_of(const Corner& corner) {
        std::size_t slot = hash(corner) & mask_;
        while (slots_[slot] != absent && corners_[slots_[slot]] != corner)
            slot = (slot + 1) & mask_;
        if (slots_[slot] == absent) {
            slots_[slot] = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back(corner);
        }
        return slots_[slot];
    }
    const std::vector<Corner>& corners() const { return corners_; }

private:
    std::size_t mask_ = 0;
    std::vector<std::uint32_t> slots_;
    std::vector<Corner> corners_;
};

// The elements of each part, in the order of the file: part p has [begin[p], begin[p + 1]).
struct PartOrder {
    std::vector<std::uint32_t> begin, elements;
};

PartOrder order_by_part(const ObjData& obj) {
    PartOrder order{std::vector<std::uint32_t>(obj.parts.size() + 1),
                    std::vector<std::uint32_t>(obj.elements.size())};
    for (std::size_t p = 0; p < obj.parts.size(); ++p)
        order.begin[p + 1] = order.begin[p] + obj.parts[p].elements;
    std::vector<std::uint32_t> at(order.begin);
    for (std::uint32_t e = 0; e < obj.elements.size(); ++e)
        order.elements[at[obj.elements[e].part]++] = e;
    return order;
}

void check_finite(const ObjData& obj, std::uint32_t index, const std::vector<NotFinite>& bad) {
    const auto found = std::ranges::lower_bound(bad, index, {}, &NotFinite::index);
    if (found != bad.end() && found->index == index)
        throw Error(obj.file, found->line, found->fault);
}

void gather_vertices(const ObjData& obj, const dvec3& origin, const std::vector<Corner>& corners,
                     MeshData& mesh) {
    bool any_texcoord = false, any_normal = false;
    mesh.positions.reserve(corners.size());
    for (const Corner& corner : corners) {
        mesh.positions.emplace_back(obj.positions[corner.v] - origin);
        if (!obj.colors.empty()) mesh.colors.push_back(obj.colors[corner.v]);
        any_texcoord |= corner.vt != absent;
        any_normal |= corner.vn != absent;
    }
    if (any_texcoord)
        for (const Corner& corner : corners)
            mesh.texcoords.push_back(corner.vt == absent ? vec2(0, 0) : obj.texcoords[corner.vt]);
    if (any_normal)
        for (const Corner& corner : corners)
            mesh.normals.push_back(corner.vn == absent ? vec3(0, 0, 1) : obj.normals[corner.vn]);
}

}  // namespace

void ObjBuilder::set_object(std::string_view name) {
    object_ = name;
    group_.clear();
    part_primitive_.reset();
}

void ObjBuilder::set_group(std::string_view name) {
    group_ = name;
    part_primitive_.reset();
}

void ObjBuilder::set_material(std::string_view name, int line) {
    material_ = name;
    material_line_ = line;
    part_primitive_.reset();
}

std::uint32_t ObjBuilder::part_of(Primitive primitive) {
    if (part_primitive_ == primitive) return part_;
    part_primitive_ = primitive;
    const std::string& name = group_.empty() ? object_ : group_;
    const auto next = static_cast<std::uint32_t>(obj.parts.size());
    const auto [found, is_new] = parts_.try_emplace({name, material_, primitive}, next);
    if (is_new) obj.parts.push_back({name, material_, material_line_, primitive});
    return part_ = found->second;
}

void ObjBuilder::add(Primitive primitive, std::size_t first, std::uint32_t count, int line) {
    const std::uint32_t index = part_of(primitive);
    obj.parts[index].elements += 1;
    obj.parts[index].corners += count;
    obj.elements.push_back({static_cast<std::uint32_t>(first), count, index, smoothing, line});
}

void ObjBuilder::add_face(std::uint32_t corners, int line) {
    add(Primitive::Polygons, obj.corners.size() - corners, corners, line);
}

void ObjBuilder::add_segments(std::uint32_t corners, int line) {
    const std::vector<Corner> run(obj.corners.end() - corners, obj.corners.end());
    obj.corners.resize(obj.corners.size() - corners);
    for (std::size_t i = 1; i < run.size(); ++i) {
        obj.corners.insert(obj.corners.end(), {run[i - 1], run[i]});
        add(Primitive::Lines, obj.corners.size() - 2, 2, line);
    }
}

void ObjBuilder::add_points(std::uint32_t corners, int line) {
    for (std::size_t i = obj.corners.size() - corners; i < obj.corners.size(); ++i)
        add(Primitive::Points, i, 1, line);
}

std::string index_fault(std::string_view kind, long long index, std::size_t count) {
    const std::string text =
        std::string(kind) + " index " + std::to_string(index) + " is out of range; ";
    if (count == 0) return text + "the file has no " + std::string(kind);
    const std::string n = std::to_string(count);
    return text + "expected 1 .. " + n + " or -" + n + " .. -1";
}

void check_indices(const ObjData& obj) {
    for (const Element& element : obj.elements) {
        const auto check = [&](std::string_view kind, std::uint32_t index, std::size_t count,
                               const std::vector<NotFinite>& bad) {
            if (index != absent && index >= count)
                throw Error(obj.file, element.line, index_fault(kind, index + 1LL, count));
            if (!bad.empty()) check_finite(obj, index, bad);
        };
        for (std::uint32_t i = 0; i < element.count; ++i) {
            const Corner& corner = obj.corners[element.first + i];
            check("v", corner.v, obj.positions.size(), obj.bad_positions);
            check("vt", corner.vt, obj.texcoords.size(), obj.bad_texcoords);
            check("vn", corner.vn, obj.normals.size(), obj.bad_normals);
        }
    }
}

std::vector<MeshData> make_meshes(const ObjData& obj) {
    std::vector<MeshData> meshes(obj.parts.size());
    const PartOrder order = order_by_part(obj);
    Vertices vertices;
    for (std::size_t p = 0; p < obj.parts.size(); ++p) {
        end_if_canceled();
        MeshData& mesh = meshes[p];
        mesh.primitive = obj.parts[p].primitive;
        vertices.begin(obj.parts[p].corners);
        mesh.indices.reserve(obj.parts[p].corners);
        for (std::uint32_t i = order.begin[p]; i < order.begin[p + 1]; ++i) {
            const Element& element = obj.elements[order.elements[i]];
            if (mesh.primitive == Primitive::Polygons) mesh.polygon_sizes.push_back(element.count);
            for (std::uint32_t k = 0; k < element.count; ++k)
                mesh.indices.push_back(vertices.index_of(obj.corners[element.first + k]));
        }
        gather_vertices(obj, obj.parts[p].origin, vertices.corners(), mesh);
    }
    return meshes;
}

}  // namespace gw::scene
