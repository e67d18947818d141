#include "multipass/frame/superpose.h"

#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "gw/stages/accumulation.h"
#include "multipass/steps/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
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
        list.add(
            WritePixels{.rect = {0, 0, width, height}, .plane = Plane::Color, .colors = picture});
        list.add(Accumulate{AccumOp::Accum, 1});
        machine.execute(list);
    }
    accumulate(machine, "return", AccumOp::Return, 1.0f / float(pictures.size()));
}

}  // namespace

int most_pictures(const Profile& profile) {
    const std::uint64_t level = std::uint64_t{1} << accum_fraction_bits(profile);
    return static_cast<int>(max_of_bits(profile.accum_bits - 1) /
                            (level * max_of_bits(profile.color_bits)));
}

Superposition superposition(const Profile& profile, int count, int images) {
    const int most = most_pictures(profile), group = std::max(1, most / std::max(1, images));
    if (count < 1) throw Error(fmt::format("{} pictures to superpose; expected 1 or more", count));
    const int groups = (count + group - 1) / group;
    if (groups > most)
        throw Error(fmt::format(
            "{} pictures are more than profile {} superposes, in groups too; expected at most {}",
            count, profile.name, most * group));
    return {(count + groups - 1) / groups * groups, groups};
}

std::vector<int> tent_weights(int count, int subpixel_bits, int most) {
    if (count > most)
        throw Error(fmt::format("{} weighted pictures; the profile holds {} at most", count, most));
    const int grid = 1 << subpixel_bits;
    const auto height = [&](int offset) { return grid - std::abs(2 * offset + 1) + 1; };
    std::vector<std::int64_t> tent;
    for (int k = 0; k < count; ++k) {
        const JitterState j = jitter_of({std::size_t(k), std::size_t(count)}, subpixel_bits);
        tent.push_back(std::int64_t(height(j.x)) * height(j.y));
    }
    // As large as fits: the tent scaled down by its sum over `budget`.
    const std::int64_t sum = std::accumulate(tent.begin(), tent.end(), std::int64_t{0});
    std::vector<int> weights(tent.size());
    for (std::int64_t budget = std::min<std::int64_t>(most, sum);; --budget) {
        for (std::size_t k = 0; k < tent.size(); ++k)
            weights[k] = int(std::max<std::int64_t>(1, tent[k] * budget / sum));
        if (std::accumulate(weights.begin(), weights.end(), 0) <= most) return weights;
    }
}

std::vector<int> weights_of(int samples, bool weighted, const Profile& profile) {
    if (!weighted || samples < 2) return {};
    return tent_weights(samples, profile.subpixel_bits, most_pictures(profile));
}

Superposition superpose(Machine& machine, int count, int images,
                        const std::function<void(const Sample&)>& draw,
                        const std::vector<int>& weights) {
    const Superposition s = superposition(machine.profile(), count, images);
    if (!weights.empty() && (s.groups > 1 || images > 0))
        throw Error(
            "pictures with weights fit in one sum only; expected fewer samples, and no glare");
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
            const float weight = weights.empty() ? 1 : float(weights[std::size_t(k)]);
            if (images == 0) accumulate(machine, "accumulate", AccumOp::Accum, weight);
        }
        const int sum =
            weights.empty() ? group : std::accumulate(weights.begin(), weights.end(), 0);
        accumulate(machine, "return", AccumOp::Return, 1.0f / float(sum));
        if (s.groups > 1) means.push_back(read_picture(machine));
    }
    if (s.groups > 1) average(machine, means);
    return s;
}

}  // namespace gw::multipass
