#include "inspect/text/plural.h"

#include <fmt/format.h>

namespace gw::inspect {

std::string plural(std::uint64_t number, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
}

}  // namespace gw::inspect
