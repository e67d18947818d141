// Claim: whatever a text says, it is read as text.
#include "image/plot/markup.h"

#include <gtest/gtest.h>

namespace gw::plot {

TEST(Escaped, IsHarmlessInTextAndInAttributes) {
    EXPECT_EQ(escaped("<a href=\"x\">'&'"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;");
    EXPECT_EQ(escaped("輪 plain"), "輪 plain");
}

}  // namespace gw::plot
