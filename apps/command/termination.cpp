#include "apps/command/termination.h"

#include "image/output/temporaries.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

namespace gw::apps {
namespace {

/// An exception that leaves a library's noexcept function, inlined into ours, is not the current
/// one. Only its existence is known. Missing memory is the one cause that tests find.
bool is_out_of_memory() {
    const std::exception_ptr exception = std::current_exception();
    if (!exception) return std::uncaught_exceptions() > 0;
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

[[noreturn]] void end() {
    image::remove_temporaries();
    if (!is_out_of_memory()) std::abort();
    constexpr std::string_view text = "gw: out of memory\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    std::_Exit(1);
}

}  // namespace

void end_clearly_on_terminate() { std::set_terminate(end); }

}  // namespace gw::apps
