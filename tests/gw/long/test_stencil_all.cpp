// Every stencil operation, stored value, write mask and reference through the machine: 134 million
// fragments.
#include "tests/gw/exhaustive/stencil_row.h"

namespace gw {
namespace {

using namespace test;

TEST(ExhaustiveStencilLong, EveryOperationValueMaskAndReferenceThroughTheMachine) {
    Row row;
    for (const StencilOp op : ops)
        for (int mask = 0; mask < 256; ++mask)
            for (int ref = 0; ref < 256; ++ref) {
                row.bench.state.stencil = {
                    .test = true, .ref = ref, .zpass = op, .write_mask = std::uint32_t(mask)};
                row.fill();
                row.bench.write(row.rect, {});
                for (int stored = 0; stored < 256; ++stored)
                    ASSERT_EQ(row.at(stored), masked(stored, operated(op, stored, ref, 256), mask))
                        << "op " << int(op) << ", mask " << mask << ", ref " << ref;
            }
}

}  // namespace
}  // namespace gw
