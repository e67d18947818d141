// Command lists as Python holds them. An execution that is under way keeps the list it began with,
// whatever another thread adds.
#pragma once

#include "gw/command_list.h"

#include <memory>

namespace gw::python {

class ListHolder {
public:
    ListHolder() = default;
    explicit ListHolder(CommandList list) : list_(std::make_shared<CommandList>(std::move(list))) {}

    const CommandList& list() const { return *list_; }
    /// For an execution without the interpreter's lock.
    std::shared_ptr<const CommandList> shared() const { return list_; }
    /// For a change: a copy if the list is being executed.
    CommandList& changed() {
        if (list_.use_count() > 1) list_ = std::make_shared<CommandList>(*list_);
        return *list_;
    }
    void add(Command command) { changed().add(std::move(command)); }

private:
    std::shared_ptr<CommandList> list_ = std::make_shared<CommandList>();
};

}  // namespace gw::python
