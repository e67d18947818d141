// The whole golden suite, the reference machine beside the fast one.
#include "test_paths.h"
#include "tests/apps/support/examples.h"

namespace gw::apps {

class GoldenOnBothMachines : public ExampleTest {};

TEST_F(GoldenOnBothMachines, EveryPassOfEveryFigureOnEveryProfile) {
    const Outcome outcome = gw({"golden", GW_SOURCE_DIR "/tests/golden", "--machine", "both"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

}  // namespace gw::apps
