set(link gw::fuzzing)
