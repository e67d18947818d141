// The pipeline's state to and from the recording's schema. A group at its initial value is not
// stored.
// Does not check numbers: gw's `validate` does.
#pragma once

#include "gw/state.h"
#include "recording_generated.h"

namespace gw::inspect {

flatbuffers::Offset<gwt::State> to_file(flatbuffers::FlatBufferBuilder& out, const State& state);
/// Throws Error for an enumeration's value that there is not.
State from_file(const gwt::State& state);

}  // namespace gw::inspect
