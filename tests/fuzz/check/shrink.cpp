#include "tests/fuzz/check/shrink.h"

#include "gw/error.h"

namespace gw::fuzz {
namespace {

/// Whether the case still fails. A list that became invalid does not.
bool fails(const Case& c, const MachineMaker& a, const MachineMaker& b) {
    try {
        return run_case(c, a, b).has_value();
    } catch (const Error&) {
        return false;
    }
}

Case without_command(Case c, std::size_t i) {
    c.list.commands.erase(c.list.commands.begin() + static_cast<std::ptrdiff_t>(i));
    return c;
}

/// A triangle mesh with one triangle less.
Case without_triangle(Case c, std::size_t command, std::size_t triangle) {
    auto& draw = std::get<Draw>(c.list.commands[command]);
    MeshData data = draw.mesh->data();
    data.primitive = Primitive::Triangles;
    data.polygon_sizes.clear();
    data.polygon_ids.clear();
    data.indices.clear();
    for (std::size_t i = 0; i < draw.mesh->triangles().size(); ++i)
        if (i != triangle)
            for (const std::uint32_t v : draw.mesh->triangles()[i].vertex)
                data.indices.push_back(v);
    draw.mesh = make_mesh(std::move(data));
    return c;
}

std::size_t triangle_count(const Command& command) {
    const auto* draw = std::get_if<Draw>(&command);
    return draw ? draw->mesh->triangles().size() : 0;
}

}  // namespace

Case shrink(Case c, const MachineMaker& a, const MachineMaker& b) {
    for (std::size_t i = c.list.commands.size(); i-- > 0;)
        if (Case less = without_command(c, i); fails(less, a, b)) c = std::move(less);
    for (std::size_t i = 0; i < c.list.commands.size(); ++i)
        for (std::size_t t = triangle_count(c.list.commands[i]); t-- > 0;)
            if (triangle_count(c.list.commands[i]) > 1)
                if (Case less = without_triangle(c, i, t); fails(less, a, b)) c = std::move(less);
    return c;
}

}  // namespace gw::fuzz
