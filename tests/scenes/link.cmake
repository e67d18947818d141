# The share of glossy pixels of fig9 is drawn, and scenes that say the same are drawn by every
# renderer.
set(link gw::multipass gw::itembuffer gw::hiddensurface)
