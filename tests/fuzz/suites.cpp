#include "tests/fuzz/suites.h"

#include <algorithm>
#include <iterator>

namespace gw::fuzz {

const std::vector<Suite>& suites() {
    static const std::vector<Suite> random = [] {
        std::vector<Suite> out;
        std::ranges::copy_if(all_groups(), std::back_inserter(out),
                             [](const Suite& suite) { return suite.planes != 0; });
        return out;
    }();
    return random;
}

Case make_case(const Suite& suite, std::uint64_t index) {
    Random random(seed_of(suite.name, index));
    return suite.make(random);
}

}  // namespace gw::fuzz
