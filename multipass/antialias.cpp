#include "multipass/antialias.h"

#include "gw/arithmetic.h"
#include "gw/error.h"

#include <fmt/format.h>

namespace gw::multipass {
namespace {

/// 0.b0 b1 b2 ... in binary, for i = ... b2 b1 b0: with i / N the most even points there are for N = 2^k.
double mirrored(unsigned i) {
    double value = 0;
    for (double digit = 0.5; i > 0; i >>= 1, digit /= 2) value += (i & 1) * digit;
    return value;
}

/// The machine it refers to, with everything drawn moved.
class MovedMachine final : public Machine {
public:
    MovedMachine(Machine& machine, JitterState jitter) : machine_(machine), jitter_(jitter) {}

    void execute(const CommandList& list) override {
        CommandList moved = list;
        for (Command& command : moved.commands)
            if (auto* set = std::get_if<SetState>(&command)) set->state.jitter = jitter_;
        machine_.execute(moved);
    }
    const Planes& planes() override { return machine_.planes(); }
    const std::vector<PassReport>& passes() override { return machine_.passes(); }
    void reset_passes() override { machine_.reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks(); }
    const Profile& profile() const override { return machine_.profile(); }

private:
    Machine& machine_;
    JitterState jitter_;
};

void accumulate(Machine& machine, const char* name, AccumOp op, float value) {
    CommandList list;
    list.add(BeginPass{.name = name});
    list.add(SetState{});
    list.add(Accumulate{op, value});
    machine.execute(list);
}

}  // namespace

std::vector<JitterState> sample_positions(int count, int subpixel_bits) {
    if (count == 1) return {{0, 0}};
    const int grid = 1 << subpixel_bits;
    std::vector<JitterState> positions;
    for (int i = 0; i < count; ++i) {
        const double x = (i + 0.5) / count, y = mirrored(static_cast<unsigned>(i)) + 0.5 / (2.0 * count);
        positions.push_back({static_cast<int>(x * grid) - grid / 2, static_cast<int>(y * grid) - grid / 2});
    }
    return positions;
}

int most_samples(const Profile& profile) {
    return static_cast<int>(max_of_bits(profile.accum_bits - 1) / max_of_bits(profile.color_bits));
}

void render_samples(Machine& machine, int count, const std::function<void(Machine&)>& draw) {
    const int most = most_samples(machine.profile());
    if (count < 1 || count > most)
        throw Error(
            fmt::format("{} samples do not fit the accumulation buffer of profile '{}'; expected 1 to {}",
                        count, machine.profile().name, most));
    if (count == 1) return draw(machine);
    AccumOp op = AccumOp::Load;
    for (const JitterState& jitter : sample_positions(count, machine.profile().subpixel_bits)) {
        MovedMachine moved(machine, jitter);
        draw(moved);
        accumulate(machine, "accumulate", op, 1);
        op = AccumOp::Accum;
    }
    accumulate(machine, "return", AccumOp::Return, 1.0f / static_cast<float>(count));
}

}  // namespace gw::multipass
