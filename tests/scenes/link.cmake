# The share of glossy pixels of fig9 is drawn.
set(link gw::multipass)
