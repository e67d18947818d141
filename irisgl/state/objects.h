// Objects: lists of calls with tags, which may be edited. Does not know the calls.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace gw::irisgl {

struct Call {
    const char* function;  ///< never dies
    std::function<void()> carry_out;
};

struct ObjectList {
    std::vector<Call> calls;
    std::map<long, std::size_t> tags;  ///< the number of calls before the tag
};

/// The object that is being made or edited, and where calls go.
struct OpenObject {
    long name = 0;
    ObjectList* list = nullptr;  ///< null: none is open
    std::size_t at = 0;          ///< calls are put before this one
    std::size_t replaced = 0;    ///< objreplace: calls that the next ones replace

    bool is_open() const { return list != nullptr; }
    void add(Call call);
};

struct Objects {
    std::map<long, ObjectList> all;
    OpenObject open;
    int depth = 0;           ///< of callobj
    std::set<long> called;   ///< the objects that are being called
    bool is_pruned = false;  ///< bbox2: the called object ends here
    long last_generated = 0;
};

}  // namespace gw::irisgl
