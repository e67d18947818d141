set(link gw::gl_entry)
