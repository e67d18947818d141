#include "irisgl/calls/run.h"

#include <string>

namespace gw::irisgl {

void report_no_window(const char* function) {
    warn(std::string(function) + ": no window is open; expected winopen before it; it is ignored");
}

long left_out(const char* function, const char* reason) {
    warn(std::string(function) + " is not offered: " + reason + "; it does nothing");
    return 0;
}

}  // namespace gw::irisgl
