// Listens to what drawables execute: for recordings.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

#include <memory>
#include <string>

namespace gw::gl {

/// Called by drawables of any thread.
class FrameLog {
public:
    virtual ~FrameLog() = default;
    /// A drawable begins; its planes are 0.
    virtual void open(const std::string& window, int width, int height) = 0;
    /// The drawable's machine has executed a list.
    virtual void add(const std::string& window, const CommandList& list) = 0;
    virtual void close(const std::string& window) = 0;
};

/// Null: nobody listens.
FrameLog* frame_log();
/// Before the first drawable.
void set_frame_log(std::unique_ptr<FrameLog> log);

}  // namespace gw::gl
