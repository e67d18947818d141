#include "apps/command/versions.h"

#include "image/write.h"

#include <fmt/format.h>
#include <CLI/Version.hpp>
#include <glm/detail/setup.hpp>
#include <nlohmann/json_fwd.hpp>

namespace gw::apps {

std::string version() { return GW_VERSION; }

std::vector<std::pair<std::string, std::string>> versions() {
    return {
#ifdef __clang__
        {"compiler", "clang++ " __clang_version__},
#else
        {"compiler", "g++ " __VERSION__},
#endif
        {"OpenImageIO", image::library_version()},
        {"GLM", fmt::format("{}.{}.{}.{}", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH,
                            GLM_VERSION_REVISION)},
        {"CLI11", CLI11_VERSION},
        {"fmt",
         fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
    };
}

}  // namespace gw::apps
