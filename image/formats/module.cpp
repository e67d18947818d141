#include "image/formats/module.h"

namespace gw::image::oiio {

extern "C" __attribute__((visibility("default"))) const Formats gw_formats{
    .format_of = format_of,
    .put_picture = put_picture,
    .put_values = put_values,
    .put_animation = put_animation,
    .put_layers = put_layers,
    .read_layers = read_layers,
};

}  // namespace gw::image::oiio
