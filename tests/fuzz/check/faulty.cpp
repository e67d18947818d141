#include "tests/fuzz/check/faulty.h"

namespace gw::fuzz {
namespace {

class FaultyMachine final : public Machine {
public:
    FaultyMachine(std::unique_ptr<Machine> machine, Fault fault)
        : machine_(std::move(machine)), fault_(fault), planes_(machine_->planes()) {}

    void execute(const CommandList& list) override {
        const Planes before = machine_->planes();
        machine_->execute(list);
        planes_ = machine_->planes();
        passes_ = machine_->passes();
        for (const Command& command : list.commands)
            draws_ += std::holds_alternative<Draw>(command) ? 1 : 0;
        if (draws_ >= 3) spoil(before, list.commands.size());
    }
    const Planes& planes() override { return planes_; }
    const std::vector<PassReport>& passes() override { return passes_; }
    void reset_passes() override { machine_->reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_->readbacks(); }
    void read_into(std::uint32_t key, std::span<std::uint32_t> values, ReadLayout layout) override {
        machine_->read_into(key, values, layout);
    }
    const Profile& profile() const override { return machine_->profile(); }

private:
    void spoil(const Planes& before, std::size_t commands) {
        if (fault_ == Fault::Counter) passes_.back().counters.fragments += 1;
        if (fault_ == Fault::Split && commands > 1) planes_.color.back()[2] ^= 1;
        if (fault_ != Fault::Pixel) return;
        for (std::size_t i = 0; i < planes_.depth.size(); ++i)
            if (planes_.depth[i] != before.depth[i]) {
                planes_.depth[i] ^= 1;
                return;
            }
    }

    std::unique_ptr<Machine> machine_;
    Fault fault_;
    Planes planes_;
    std::vector<PassReport> passes_;
    int draws_ = 0;
};

}  // namespace

std::unique_ptr<Machine> make_faulty(std::unique_ptr<Machine> machine, Fault fault) {
    return std::make_unique<FaultyMachine>(std::move(machine), fault);
}

}  // namespace gw::fuzz
