// All algorithms: the lecture's order [L3, L5, L6, L8, L9], then the classics by year. Each is defined
// in algorithms/NAME.cpp. A file there that is not named here is a user's own, and comes last.
#include "hiddensurface/interface/algorithm.h"

#include <own_algorithms.h>  // written by CMake

namespace gw::hiddensurface {

Algorithm back_face();
Algorithm painter_farthest();  // painter.cpp
Algorithm painter_nearest();   // painter.cpp
Algorithm painter_centroid();  // painter.cpp
Algorithm newell();
Algorithm bsp();
Algorithm scan_line();
Algorithm z_buffer();
Algorithm ray_casting();
Algorithm schumacker();
Algorithm warnock();
Algorithm bouknight();
Algorithm watkins();
Algorithm weiler_atherton();
Algorithm a_buffer();
Algorithm hierarchical_z();
Algorithm quake();

const std::vector<Algorithm>& algorithms() {
    static const std::vector<Algorithm> all = [] {
        std::vector<Algorithm> table{
            back_face(),       painter_farthest(),
            painter_nearest(), painter_centroid(),
            newell(),          bsp(),
            scan_line(),       z_buffer(),
            ray_casting(),     schumacker(),
            warnock(),         bouknight(),
            watkins(),         weiler_atherton(),
            a_buffer(),        hierarchical_z(),
            quake(),
        };
        for (Algorithm (*own)() : own_algorithms) table.push_back(own());
        return table;
    }();
    return all;
}

}  // namespace gw::hiddensurface
