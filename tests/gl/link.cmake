set(link gw::gl_entry gw::gl_record)
