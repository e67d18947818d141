// A command of a file as the table that its type names. Does not verify it: is_whole does.
#pragma once

#include "recording_generated.h"

#include <span>

namespace gw::inspect {

/// Calls `use` with the table that `stored` is; false if the type is unknown.
bool with_command(gwt::CommandType type, const gwt::AnyCommand* stored, const auto& use) {
    const auto as = [&]<typename Table>(const Table*) {
        use(*reinterpret_cast<const Table*>(stored));
        return true;
    };
    switch (type) {
        case gwt::CommandType::BeginPass: return as(static_cast<gwt::BeginPass*>(nullptr));
        case gwt::CommandType::Clear: return as(static_cast<gwt::Clear*>(nullptr));
        case gwt::CommandType::SetState: return as(static_cast<gwt::SetState*>(nullptr));
        case gwt::CommandType::Draw: return as(static_cast<gwt::Draw*>(nullptr));
        case gwt::CommandType::WriteSpans: return as(static_cast<gwt::WriteSpans*>(nullptr));
        case gwt::CommandType::WritePixels: return as(static_cast<gwt::WritePixels*>(nullptr));
        case gwt::CommandType::Accumulate: return as(static_cast<gwt::Accumulate*>(nullptr));
        case gwt::CommandType::Copy: return as(static_cast<gwt::Copy*>(nullptr));
        case gwt::CommandType::CopyTexture: return as(static_cast<gwt::CopyTexture*>(nullptr));
        case gwt::CommandType::Read: return as(static_cast<gwt::Read*>(nullptr));
        case gwt::CommandType::DrawPixels: return as(static_cast<gwt::DrawPixels*>(nullptr));
        case gwt::CommandType::SwapBuffers: return as(static_cast<gwt::SwapBuffers*>(nullptr));
        case gwt::CommandType::Query: return as(static_cast<gwt::Query*>(nullptr));
        case gwt::CommandType::MakeSurface: return as(static_cast<gwt::MakeSurface*>(nullptr));
        case gwt::CommandType::UseSurface: return as(static_cast<gwt::UseSurface*>(nullptr));
        case gwt::CommandType::Blit: return as(static_cast<gwt::Blit*>(nullptr));
        case gwt::CommandType::NONE: break;
    }
    return false;
}

/// Whether all offsets, lengths and strings lie inside the bytes, those of commands too.
bool is_whole(std::span<const std::uint8_t> bytes);

}  // namespace gw::inspect
