#include "gl/record/screenshot.h"

#include "gl/drawable/drawable.h"
#include "gl/record/whole_file.h"

#include <cstdio>
#include <utility>

namespace gw::gl {

std::string ppm_of(const Planes& planes, int color_bits) {
    const int largest = (1 << color_bits) - 1;
    std::string out = "P6\n" + std::to_string(planes.width) + " " + std::to_string(planes.height) +
                      "\n" + std::to_string(largest) + "\n";
    out.reserve(out.size() + planes.color.size() * 6);
    for (int y = planes.height - 1; y >= 0; --y)
        for (int x = 0; x < planes.width; ++x) {
            const Rgba& pixel = planes.color[planes.index(x, y)];
            for (std::size_t i = 0; i < 3; ++i) {
                if (largest > 255) out += char(pixel[i] >> 8);
                out += char(pixel[i] & 0xFF);
            }
        }
    return out;
}

Screenshot::Screenshot(std::string file, const FrameRange& frames)
    : file_(std::move(file)), range_(frames) {}

void Screenshot::end_frame(Drawable& drawable) {
    if (!range_.holds(drawable.frame())) return;
    const std::string picture = ppm_of(drawable.shown(), drawable.profile().color_bits);
    if (failed_) return;
    const std::string fault = write_whole_file(file_, picture);
    failed_ = !fault.empty();
    if (failed_)
        std::fprintf(stderr, "gw: %s: cannot be written: %s\n", file_.c_str(), fault.c_str());
}

}  // namespace gw::gl
