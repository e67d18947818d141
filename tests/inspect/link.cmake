# Random lists of every kind.
set(link gw::fuzzing)
