#include "gl/record/code_place.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>

namespace gw::gl {

namespace {

/// What the system knows of an address: the file of its code, and a name in it.
struct Found {
    std::filesystem::path file;
    const void* begin = nullptr;  ///< of the file in memory
    std::string name;             ///< empty: none is exported
    const void* name_begin = nullptr;
};

#ifdef _WIN32
Found found_at(const void* address) {
    HMODULE module = nullptr;
    wchar_t file[MAX_PATH] = {};
    constexpr DWORD by_address =
        GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
    if (!GetModuleHandleExW(by_address, static_cast<LPCWSTR>(address), &module) ||
        GetModuleFileNameW(module, file, MAX_PATH) == 0)
        return {};
    return {.file = file, .begin = module};
}
#else
Found found_at(const void* address) {
    Dl_info found{};
    if (::dladdr(address, &found) == 0 || found.dli_fname == nullptr) return {};
    return {found.dli_fname, found.dli_fbase, found.dli_sname != nullptr ? found.dli_sname : "",
            found.dli_saddr};
}
#endif

}  // namespace

std::string code_place(const void* address) {
    const Found found = found_at(address);
    if (found.begin == nullptr) return fmt::format("{}", address);
    const std::string file = found.file.filename().string();
    const auto from = [&](const void* begin) -> std::ptrdiff_t {
        return static_cast<const char*>(address) - static_cast<const char*>(begin);
    };
    if (!found.name.empty())
        return fmt::format("{}+{:#x} in {}", found.name, from(found.name_begin), file);
    return fmt::format("{}+{:#x}", file, from(found.begin));
}

}  // namespace gw::gl
