// Random lists with one wrong value: both machines refuse a list with the same message and draw
// nothing, or they accept it and agree. Does not know which values are wrong.
#include "conformance/generate/corrupt.h"
#include "tests/fuzz/run.h"
#include "tests/gw/workbench.h"

namespace gw::fuzz {
namespace {

std::string refusal(Machine& machine, const CommandList& list) {
    return test::error_of([&] { machine.execute(list); });
}

/// Empty where the machines agree about the list; `refused` says whether they refuse it.
std::string disagreement_about(const Case& c, bool& refused) {
    const auto reference = make_reference(c.profile, c.width, c.height),
               fast = make_fast(c.profile, c.width, c.height, {.threads = 1});
    const std::string message = refusal(*reference, c.list);
    refused = !message.empty();
    if (const std::string other = refusal(*fast, c.list); other != message)
        return "'" + message + "' and '" + other + "'";
    if (!refused)
        return run_case(c, machine_named("reference"), machine_named("fast")) ? "other bits" : "";
    const Planes untouched(c.width, c.height);
    const bool drawn = reference->planes() != untouched || fast->planes() != untouched ||
                       !reference->passes().empty() || !fast->passes().empty();
    return drawn ? "something was drawn before: " + message : "";
}

TEST(CorruptedLists, AreRefusedOrDrawnAlikeByBothMachines) {
    int refused = 0, accepted = 0;
    for (const Suite& suite : suites())
        for (std::uint64_t index = 0; index < 60; ++index) {
            Case c = make_case(suite, index);
            Random random(seed_of("corrupted", index));
            corrupt(random, c.list);
            bool is_refused = false;
            EXPECT_EQ(disagreement_about(c, is_refused), "") << suite.name << ' ' << index;
            (is_refused ? refused : accepted) += 1;
        }
    EXPECT_GT(refused, 400);
    EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace gw::fuzz
