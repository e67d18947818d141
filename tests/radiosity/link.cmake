# The light tracer is an oracle here: its intersections are the ray tracer's.
set(link gw::raytrace)
