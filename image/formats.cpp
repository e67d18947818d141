#include "image/formats.h"

#include "gw/error.h"
#include "image/write.h"

#include <dlfcn.h>

namespace gw::image {
namespace {

const Formats& load() {
    void* module = dlopen("libgw_formats.so", RTLD_LAZY | RTLD_LOCAL);
    const void* table = module ? dlsym(module, "gw_formats") : nullptr;
    if (!table)
        throw Error(std::string("picture formats other than PNG need the module ") + dlerror());
    return *static_cast<const Formats*>(table);
}

}  // namespace

Destination destination(OutputFile& file) {
    return {file.target(), file.temporary(),
            [&](std::span<const std::uint8_t> bytes) { file.write(bytes); }};
}

const Formats& formats() {
    static const Formats& table = load();
    return table;
}

void put_values(OutputFile& file, const Values& values) {
    formats().put_values(destination(file), values);
}

void put_layers(OutputFile& file, const Layers& layers) {
    formats().put_layers(destination(file), layers);
}
Layers read_layer_facts(const std::filesystem::path& file) {
    return formats().read_layers(file, false);
}
Layers read_layers(const std::filesystem::path& file) { return formats().read_layers(file, true); }

}  // namespace gw::image
