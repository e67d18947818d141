// make-maps DIR: writes the maps of scenes/maps/. They are committed; run this after changing one.
#include "gw/error.h"
#include "image/write.h"
#include "scenes/make_maps/maps.h"

#include <filesystem>
#include <iostream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "make-maps: expected one directory, e.g. make-maps scenes/maps\n";
        return 2;
    }
    try {
        for (const gw::maps::NamedMap& map : gw::maps::maps())
            gw::image::write_picture(std::filesystem::path(argv[1]) / map.file, map.picture());
    } catch (const gw::Error& error) {
        std::cerr << "make-maps: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
