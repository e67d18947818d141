// The makers of the groups' cases. Does not say what each must reach: groups.cpp does.
#pragma once

#include "conformance/generate/case.h"

namespace gw::conformance {

// Random lists of every kind: conformance/random/.
Case accumulation_case(Random& random);
Case alpha_mask_case(Random& random);
Case antialiasing_case(Random& random);
Case blend_case(Random& random);
Case buffers_case(Random& random);
Case clip_case(Random& random);
Case clip_control_case(Random& random);
Case coincident_case(Random& random);
Case crossed_samples_case(Random& random);
Case cubes_case(Random& random);
Case depth_case(Random& random);
Case depth_textures_case(Random& random);
Case diamond_lines_case(Random& random);
Case everything_case(Random& random);
Case exact_rho_case(Random& random);
Case fog_case(Random& random);
Case fog_coordinate_case(Random& random);
Case generated_texture_case(Random& random);
Case identifier_case(Random& random);
Case indices_case(Random& random);
Case jitter_case(Random& random);
Case joined_colors_case(Random& random);
Case drawn_pixels_case(Random& random);
Case lighting_case(Random& random);
Case lines_and_points_case(Random& random);
Case multipass_case(Random& random);
Case occlusion_query_case(Random& random);
Case pixels_case(Random& random);
Case points_case(Random& random);
Case polygon_mode_case(Random& random);
Case profile_case(Random& random);
Case raster_case(Random& random);
Case secondary_color_case(Random& random);
Case separate_blend_case(Random& random);
Case shadow_case(Random& random);
Case stencil_case(Random& random);
Case stipple_case(Random& random);
Case samples_case(Random& random);
Case surfaces_case(Random& random);
Case texture_case(Random& random);
Case texture_formats_case(Random& random);
Case texture_churn_case(Random& random);
Case texture_combine_case(Random& random);
Case texture_sizes_case(Random& random);
Case texture_srgb_case(Random& random);
Case texture_units_case(Random& random);
Case tiny_draws_case(Random& random);
Case vertices_case(Random& random);
Case viewport_case(Random& random);
Case volumes_case(Random& random);
Case write_bits_case(Random& random);

// Lists that random ones seldom are: conformance/directed/. They share no seeds with the random
// tests, so a change here leaves those digests alone.
Case blocks_case(Random& random);
Case cut_slivers_case(Random& random);
Case environments_case(Random& random);
Case extreme_lights_case(Random& random);
Case far_coordinates_case(Random& random);
Case mesh_case(Random& random);
Case offset_case(Random& random);
Case outlines_case(Random& random);
Case polygons_case(Random& random);
Case r_rules_case(Random& random);
Case sample_rules_case(Random& random);
Case smooth_case(Random& random);
Case state_rules_case(Random& random);
Case sum_rules_case(Random& random);
Case surface_rules_case(Random& random);
Case texels_case(Random& random);
Case ties_case(Random& random);
Case vertex_rules_case(Random& random);
Case volume_rules_case(Random& random);

}  // namespace gw::conformance
