#include "gl/record/call_table.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace gw::gl {

namespace {

constexpr std::size_t most_sources = 1 << 14;

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

/// "main+0x1f in gears", if the program exports the name; else "gears+0x1a2f"; the bare address, if
/// no loaded file has it.
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

/// Makes a table in which each name and each list stands once.
class TableMaker {
public:
    using SourceName = std::function<const std::string&(const void*)>;
    explicit TableMaker(SourceName source_name) : source_name_(std::move(source_name)) {}

    void add(const CallRun& run) {
        table.runs.push_back({run.command, run.first, call_of(run.call), run.step, run.ordinal});
    }

    inspect::CallTable table;

private:
    template <class Key, class Value, class Make>
    static std::uint32_t place_in(std::vector<Value>& values, std::map<Key, std::uint32_t>& places,
                                  const Key& key, Make make) {
        if (const auto known = places.find(key); known != places.end()) return known->second;
        values.push_back(make());
        return places[key] = static_cast<std::uint32_t>(values.size() - 1);
    }

    /// Display lists nest no deeper than max_list_nesting.
    inspect::Call call_of(const CallPlace& call) {
        inspect::Call out{.number = call.number};
        out.function = place_in(table.functions, functions_, std::string_view(call.function),
                                [&] { return std::string(call.function); });
        if (call.source != nullptr)
            out.source = place_in(table.sources, sources_, call.source,
                                  [&] { return source_name_(call.source); });
        if (call.list)
            out.list = place_in(table.lists, lists_, call.list.get(), [&] {
                return inspect::PlayedList{call.list->name, call_of(call.list->caller)};
            });
        return out;
    }

    SourceName source_name_;
    std::map<std::string_view, std::uint32_t> functions_;
    std::map<const void*, std::uint32_t> sources_;
    std::map<const PlayedList*, std::uint32_t> lists_;
};

}  // namespace

const std::string& CallNamer::source_name(const void* address) {
    if (sources_.size() > most_sources) sources_.clear();
    const auto [found, is_new] = sources_.try_emplace(address);
    if (is_new) found->second = code_place(address);
    return found->second;
}

inspect::CallTable CallNamer::table_of(std::span<const CallRun> runs) {
    TableMaker maker(
        [this](const void* address) -> const std::string& { return source_name(address); });
    for (const CallRun& run : runs) maker.add(run);
    return std::move(maker.table);
}

}  // namespace gw::gl
