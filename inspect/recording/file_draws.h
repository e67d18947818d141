// What draws and spans are made of, as the schema's structs and tables.
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

gwt::Light to_file(const Light& l);
gwt::Material to_file(const Material& m);
gwt::FaceMaterials to_file(const FaceMaterials& m);
gwt::CurrentValues to_file(const CurrentValues& v);
gwt::Span to_file(const Span& s);
gwt::RasterPosition to_file(const RasterPosition& r);

/// Null: a draw without any. Absent members have their initial values.
std::shared_ptr<const CurrentValues> current_values(const gwt::Draw& c);
RasterPosition raster_position(const gwt::DrawPixels& c);

}  // namespace gw::inspect
