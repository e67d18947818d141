// make-lamps FILE: writes scenes/lamps.toml. It is committed; run this after changing lamps.cpp.
#include "gw/error.h"
#include "image/output/output_file.h"
#include "scenes/make_lamps/lamps.h"

#include <iostream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "make-lamps: expected one file, e.g. make-lamps scenes/lamps.toml\n";
        return 2;
    }
    try {
        gw::image::write_file(argv[1], gw::lamps::building());
    } catch (const gw::Error& error) {
        std::cerr << "make-lamps: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
