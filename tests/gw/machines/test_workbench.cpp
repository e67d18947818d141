// The workbench itself: a machine that is wrong fails every test that runs a list on it, also one
// that never looks at the result.
#include "tests/fuzz/check/faulty.h"
#include "tests/gw/workbench.h"

#include <gtest/gtest-spi.h>

namespace gw {
namespace {

using test::Workbench;

/// A workbench whose fast machine makes a mistake in its third draw, which this test runs.
void only_run_lists(fuzz::Fault fault) {
    Workbench bench(make_reference(vgx(), 16, 16),
                    fuzz::make_faulty(make_fast(vgx(), 16, 16, {.threads = 1}), fault));
    bench.state.depth.test = true;
    bench.clear();
    for (const float z : {300.0f, 200.0f, 100.0f})
        bench.draw(Primitive::Quads, {{2, 2, z}, {9, 2, z}, {9, 9, z}, {2, 9, z}});
}

TEST(Workbench, FailsATestThatOnlyRunsListsWhenAPixelIsWrong) {
    EXPECT_NONFATAL_FAILURE(only_run_lists(fuzz::Fault::Pixel), "the machines' planes differ");
}

TEST(Workbench, FailsATestThatOnlyRunsListsWhenACounterIsWrong) {
    EXPECT_NONFATAL_FAILURE(only_run_lists(fuzz::Fault::Counter), "the machines' counters differ");
}

/// Accepts every list and does nothing.
class Idle final : public Machine {
public:
    void execute(const CommandList&) override {}
    const Planes& planes() override { return planes_; }
    const std::vector<PassReport>& passes() override { return passes_; }
    void reset_passes() override {}
    const std::map<std::uint32_t, Readback>& readbacks() override { return readbacks_; }
    void read_into(std::uint32_t, std::span<std::uint32_t>, ReadLayout) override {}
    const Profile& profile() const override { return profile_; }

private:
    Planes planes_{16, 16};
    std::vector<PassReport> passes_;
    std::map<std::uint32_t, Readback> readbacks_;
    Profile profile_ = vgx();
};

TEST(Workbench, FailsATestThatExpectsARefusalOfOneMachineOnly) {
    EXPECT_NONFATAL_FAILURE(
        {
            Workbench bench(make_reference(vgx(), 16, 16), std::make_unique<Idle>());
            bench.state.alpha.ref = std::numeric_limits<float>::quiet_NaN();
            EXPECT_NE(test::error_of([&] { bench.clear(); }), "");
        },
        "the machines differ");
}

}  // namespace
}  // namespace gw
