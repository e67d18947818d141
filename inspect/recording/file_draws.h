// What draws and spans are made of, from the schema's structs and tables. encode.cpp has the other
// direction.
#pragma once

#include "gw/command_list.h"
#include "inspect/recording/file_values.h"

#include <memory>

namespace gw::inspect {

Light from_file(const gwt::Light& l);
Material from_file(const gwt::Material& m);
FaceMaterials from_file(const gwt::FaceMaterials& m);
Span from_file(const gwt::Span& s);
PixelSource from_file(const gwt::PixelSource& s);

/// Null: a draw without any. Absent members have their initial values.
std::shared_ptr<const CurrentValues> current_values(const gwt::Draw& c);
RasterPosition raster_position(const gwt::DrawPixels& c);

}  // namespace gw::inspect
