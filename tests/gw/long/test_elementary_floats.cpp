// The elementary functions over every float32 of their ranges, about two minutes each. The quick
// test takes the same walk in strides.
#include "tests/gw/base/elementary_oracle.h"

namespace gw::oracle {

TEST(ElementaryOverAllFloats, Exp) { expect_below(exp_over_floats(1), exp_bound); }
TEST(ElementaryOverAllFloats, Sin) { expect_below(sin_over_floats(1), sin_bound); }
TEST(ElementaryOverAllFloats, Cos) { expect_below(cos_over_floats(1), cos_bound); }
TEST(ElementaryOverAllFloats, Tan) { expect_below(tan_over_floats(1), tan_bound); }

// 1 is exact: x^1 = x.
TEST(ElementaryOverAllFloats, PowOfOne) { EXPECT_EQ(pow_over_floats(1, 0, 1, 1).error, 0); }
TEST(ElementaryOverAllFloats, PowOfHalf) { expect_pow_accurate(0.5, 1); }
TEST(ElementaryOverAllFloats, PowOf10) { expect_pow_accurate(10, 1); }
TEST(ElementaryOverAllFloats, PowOf27_3) { expect_pow_accurate(27.3, 1); }
TEST(ElementaryOverAllFloats, PowOf128) { expect_pow_accurate(128, 1); }
TEST(ElementaryOverAllFloats, PowOf1000) { expect_pow_accurate(1000, 1); }

}  // namespace gw::oracle
