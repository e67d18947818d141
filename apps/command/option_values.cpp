#include "apps/command/option_values.h"

#include "apps/command/command.h"
#include "image/write.h"

namespace gw::apps {

void check_picture_target(const std::filesystem::path& file) {
    image::check_target(file);
    const std::string fault = image::extension_fault(file);
    if (!fault.empty()) throw UsageError(file.string() + ": " + fault);
}

}  // namespace gw::apps
