// The table of calls in both directions.
#include "inspect/recording/calls.h"
#include "inspect/recording/file_values.h"

#include <fmt/format.h>

#include <utility>

namespace gw::inspect {
namespace {

using Names = flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>;

gwt::Call call_to_file(const Call& c) { return {c.number, c.function, c.source, c.list}; }
Call call_from_file(const gwt::Call& c) { return {c.number(), c.function(), c.source(), c.list()}; }

std::uint64_t bytes_of_names(const Names* names) {
    std::uint64_t bytes = 0;
    if (names)
        for (const flatbuffers::String* name : *names) bytes += sizeof(std::string) + name->size();
    return bytes;
}

std::vector<std::string> names_from_file(const Names* names) {
    std::vector<std::string> all;
    if (names)
        for (const flatbuffers::String* name : *names) all.push_back(name->str());
    return all;
}

/// Throws Error unless the places that the call names are there.
void check_call(const Call& call, const CallTable& table, std::size_t lists) {
    const auto check = [](const char* what, std::uint32_t place, std::size_t count) {
        if (place >= count)
            throw Error(fmt::format("a call of {} {}; there are {}", what, place, count));
    };
    check("function", call.function, table.functions.size());
    if (call.source != no_call) check("source", call.source, table.sources.size());
    if (call.list != no_call) check("list", call.list, lists);
}

void check_table(const CallTable& table, std::size_t commands) {
    for (std::size_t i = 0; i < table.lists.size(); ++i)
        check_call(table.lists[i].caller, table, i);
    std::pair<std::uint64_t, std::uint64_t> next{0, 0};
    for (const CallRun& run : table.runs) {
        check_call(run.call, table, table.lists.size());
        if (run.command >= commands)
            throw Error(fmt::format("a call of command {}; there are {}", run.command, commands));
        if (std::pair<std::uint64_t, std::uint64_t>(run.command, run.first) < next)
            throw Error("calls that are not in the order of their commands");
        next = {run.command, run.first + std::uint64_t{1}};
    }
}

}  // namespace

flatbuffers::Offset<gwt::CallTable> to_file(flatbuffers::FlatBufferBuilder& out,
                                            const CallTable& table) {
    if (table.runs.empty()) return {};
    std::vector<gwt::PlayedList> lists;
    for (const PlayedList& list : table.lists)
        lists.emplace_back(list.name, call_to_file(list.caller));
    std::vector<gwt::CallRun> runs;
    for (const CallRun& run : table.runs)
        runs.emplace_back(run.command, run.first, call_to_file(run.call), run.step, run.ordinal);
    const auto functions = out.CreateVectorOfStrings(table.functions);
    const auto sources = out.CreateVectorOfStrings(table.sources);
    const auto stored_lists = out.CreateVectorOfStructs(lists);
    const auto stored_runs = out.CreateVectorOfStructs(runs);
    return gwt::CreateCallTable(out, functions, sources, stored_lists, stored_runs);
}

std::uint64_t decoded_bytes(const gwt::CallTable& table) {
    return bytes_of_names(table.functions()) + bytes_of_names(table.sources()) +
           (table.lists() ? table.lists()->size() * sizeof(PlayedList) : 0) +
           (table.runs() ? table.runs()->size() * sizeof(CallRun) : 0);
}

CallTable from_file(const gwt::CallTable& stored, std::size_t commands) {
    CallTable table{.functions = names_from_file(stored.functions()),
                    .sources = names_from_file(stored.sources())};
    if (stored.lists())
        for (const gwt::PlayedList* list : *stored.lists())
            table.lists.push_back({list->name(), call_from_file(list->caller())});
    if (stored.runs())
        for (const gwt::CallRun* run : *stored.runs())
            table.runs.push_back({run->command(), run->first(), call_from_file(run->call()),
                                  run->step(), run->ordinal()});
    check_table(table, commands);
    return table;
}

}  // namespace gw::inspect
