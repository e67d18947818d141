#include "scene/draw/item_buffer.h"

namespace gw::scene {

std::vector<std::uint32_t> draw_item_buffer(Machine& machine, const Scene& scene, const View& view,
                                            const JitterState& jitter, int bits) {
    std::vector<std::uint32_t> ids(std::size_t(view.width) * std::size_t(view.height));
    const Rect seen{0, view.rows().first, view.width, view.rows().count()};
    const std::size_t first = view.index(0, seen.y);
    const std::uint32_t mask = (1u << bits) - 1, last = polygon_ids(scene).end - 1;
    for (int shift = 0; shift < 32 && (last >> shift) != 0; shift += bits) {
        CommandList list =
            id_pass(scene, view, {.shift = shift, .opaque_only = true, .jitter = jitter});
        list.add(Read{.key = 0, .plane = Plane::Color, .rect = seen});
        machine.execute(list);
        const auto& color = machine.readbacks().at(0).color;
        for (std::size_t i = 0; i < color.size(); ++i)
            ids[first + i] |= (id_of(color[i]) & mask) << shift;
    }
    return ids;
}

}  // namespace gw::scene
