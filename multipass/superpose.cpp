// Groups, sums, means.
#include "multipass/superpose.h"

#include "gw/arithmetic.h"
#include "gw/error.h"
#include "multipass/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace gw::multipass {
namespace {

void accumulate(Machine& machine, const char* name, AccumOp op, float value) {
    CommandList list;
    begin_pass(list, name);
    list.add(Accumulate{op, value});
    machine.execute(list);
}

void clear_sum(Machine& machine) {
    CommandList list;
    begin_pass(list, "clear sum");
    list.add(Clear{.planes = mask_of(Plane::Accum)});
    machine.execute(list);
}

std::vector<Rgba> read_picture(Machine& machine) {
    const Planes& planes = machine.planes();
    CommandList list;
    begin_pass(list, "read mean");
    list.add(Read{.key = 0, .plane = Plane::Color, .rect = {0, 0, planes.width, planes.height}});
    machine.execute(list);
    return machine.readbacks().at(0).color;
}

/// The mean of pictures that were read back.
void average(Machine& machine, const std::vector<std::vector<Rgba>>& pictures) {
    const int width = machine.planes().width, height = machine.planes().height;
    clear_sum(machine);
    for (const auto& picture : pictures) {
        CommandList list;
        begin_pass(list, "add mean");
        list.add(WritePixels{.rect = {0, 0, width, height}, .plane = Plane::Color, .colors = picture});
        list.add(Accumulate{AccumOp::Accum, 1});
        machine.execute(list);
    }
    accumulate(machine, "return", AccumOp::Return, 1.0f / float(pictures.size()));
}

}  // namespace

int most_pictures(const Profile& profile) {
    return static_cast<int>(max_of_bits(profile.accum_bits - 1) / max_of_bits(profile.color_bits));
}

Superposition superposition(const Profile& profile, int count, int images) {
    const int most = most_pictures(profile), group = std::max(1, most / std::max(1, images));
    if (count < 1) throw Error(fmt::format("{} pictures to superpose; expected 1 or more", count));
    const int groups = (count + group - 1) / group;
    if (groups > most)
        throw Error(
            fmt::format("{} pictures are more than profile {} superposes, in groups too; expected at most {}",
                        count, profile.name, most * group));
    return {(count + groups - 1) / groups * groups, groups};
}

Superposition superpose(Machine& machine, int count, int images,
                        const std::function<void(const Sample&)>& draw) {
    const Superposition s = superposition(machine.profile(), count, images);
    const int group = s.samples / s.groups;
    if (s.samples == 1 && images == 0) {
        draw({});
        return s;
    }
    std::vector<std::vector<Rgba>> means;
    for (int g = 0; g < s.groups; ++g) {
        clear_sum(machine);
        for (int k = g * group; k < (g + 1) * group; ++k) {
            draw({std::size_t(k), std::size_t(s.samples)});
            if (images == 0) accumulate(machine, "accumulate", AccumOp::Accum, 1);
        }
        accumulate(machine, "return", AccumOp::Return, 1.0f / float(group));
        if (s.groups > 1) means.push_back(read_picture(machine));
    }
    if (s.groups > 1) average(machine, means);
    return s;
}

}  // namespace gw::multipass
