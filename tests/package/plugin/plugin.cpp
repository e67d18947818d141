// Functions of gw for a program that loads them at run time and does not know C++.
#include <inspect/compare/compare_machines.h>

#include <cstdio>
#include <exception>

/// 0: both machines leave the same planes; 1: they differ; 2: the file is not a recording.
extern "C" int machines_differ(const char* file) {
    try {
        const gw::inspect::Recording recording =
            gw::inspect::decode(gw::inspect::read_recording_bytes(file));
        return gw::inspect::compare_machines(recording, gw::inspect::maker_of("reference"),
                                             gw::inspect::maker_of("fast"))
            .has_value();
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 2;
    }
}
