#include "inspect/recording/file_draws.h"

namespace gw::inspect {

Light from_file(const gwt::Light& l) {
    return {.position = from_file(l.position()),
            .Ia = from_file(l.Ia()),
            .Id = from_file(l.Id()),
            .Is = from_file(l.Is()),
            .spot_direction = from_file(l.spot_direction()),
            .spot_exponent = l.spot_exponent(),
            .spot_cos_cutoff = l.spot_cos_cutoff(),
            .constant_attenuation = l.constant_attenuation(),
            .linear_attenuation = l.linear_attenuation(),
            .quadratic_attenuation = l.quadratic_attenuation()};
}
Material from_file(const gwt::Material& m) {
    return {.Ka = from_file(m.Ka()),
            .Kd = from_file(m.Kd()),
            .Ks = from_file(m.Ks()),
            .Ke = from_file(m.Ke()),
            .Ns = m.Ns(),
            .alpha = m.alpha()};
}
FaceMaterials from_file(const gwt::FaceMaterials& m) {
    return {from_file(m.front()), from_file(m.back())};
}
namespace {

MoreTexcoords more_texcoords(const auto& command) {
    MoreTexcoords out = initial_texcoords;
    if (has_more(command.more_texcoords(), "texture coordinates of units"))
        for (unsigned i = 0; i < out.size(); ++i)
            out[i] = from_file(*command.more_texcoords()->Get(i));
    return out;
}

}  // namespace

/// Absent members have their initial values.
std::shared_ptr<const CurrentValues> current_values(const gwt::Draw& c) {
    CurrentValues out;
    if (const auto* v = c.current()) {
        out.color = from_file(v->color());
        out.normal = from_file(v->normal());
        out.texcoord = from_file(v->texcoord());
    }
    if (c.current_secondary_color()) out.secondary_color = from_file(*c.current_secondary_color());
    out.fog_coordinate = c.current_fog_coordinate();
    out.more_texcoords = more_texcoords(c);
    const bool given = c.current() || c.current_secondary_color() || out.fog_coordinate != 0 ||
                       out.more_texcoords != initial_texcoords;
    return given ? std::make_shared<const CurrentValues>(out) : nullptr;
}
RasterPosition raster_position(const gwt::DrawPixels& c) {
    RasterPosition out;
    if (const auto* r = c.raster()) {
        out.x = r->x();
        out.y = r->y();
        out.depth = r->depth();
        out.color = from_file(r->color());
        out.texcoord = from_file(r->texcoord());
        out.distance = r->distance();
    }
    if (c.raster_secondary_color()) out.secondary_color = from_file(*c.raster_secondary_color());
    out.fog_coordinate = c.raster_fog_coordinate();
    out.more_texcoords = more_texcoords(c);
    return out;
}
PixelSource from_file(const gwt::PixelSource& s) {
    return {our_enum<Plane>(s.plane()), s.x(), s.y()};
}
Span from_file(const gwt::Span& s) { return {s.x(), s.y(), s.length(), s.first(), s.flat()}; }

gwt::Light to_file(const Light& l) {
    return {to_file(l.position),
            to_file(l.Ia),
            to_file(l.Id),
            to_file(l.Is),
            to_file(l.spot_direction),
            l.spot_exponent,
            l.spot_cos_cutoff,
            l.constant_attenuation,
            l.linear_attenuation,
            l.quadratic_attenuation};
}
gwt::Material to_file(const Material& m) {
    return {to_file(m.Ka), to_file(m.Kd), to_file(m.Ks), to_file(m.Ke), m.Ns, m.alpha};
}
gwt::FaceMaterials to_file(const FaceMaterials& m) { return {to_file(m.front), to_file(m.back)}; }
gwt::CurrentValues to_file(const CurrentValues& v) {
    return {to_file(v.color), to_file(v.normal), to_file(v.texcoord)};
}
gwt::Span to_file(const Span& s) { return {s.x, s.y, s.length, s.first, s.flat}; }
gwt::RasterPosition to_file(const RasterPosition& r) {
    return {r.x, r.y, r.depth, to_file(r.color), to_file(r.texcoord), r.distance};
}

}  // namespace gw::inspect
