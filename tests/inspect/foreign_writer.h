// Recordings written field by field, by their places in the schema, as a foreign writer might: also
// ones that `encode` never writes.
#pragma once

#include <flatbuffers/flatbuffers.h>

#include <functional>

namespace gw::inspect {

using flatbuffers::FlatBufferBuilder;
using Table = flatbuffers::Offset<void>;

inline flatbuffers::voffset_t place(int field) {
    return flatbuffers::FieldIndexToOffset(flatbuffers::voffset_t(field));
}

inline Table table(
    FlatBufferBuilder& out, const std::function<void()>& fields = [] {}) {
    const auto start = out.StartTable();
    fields();
    return Table(out.EndTable(start));
}

/// A profile of version 1.
inline Table profile(FlatBufferBuilder& out) {
    return table(out, [&] {
        int field = 1;
        for (const int bits : {8, 24, 8, 16, 3, 8, 8})
            out.AddElement<std::int32_t>(place(field++), bits, 0);
    });
}

}  // namespace gw::inspect
