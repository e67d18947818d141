#include "apps/figures/figure_table.h"

namespace gw::apps {

// NOLINTNEXTLINE(readability-function-size): a table
const std::vector<Figure>& figures() {
    static const std::vector<Figure> all{
        {"fig1",
         "K2 K3",
         "Figure 1: a red map and a white gloss",
         "One pass of the hardware multiplies everything by the map, the gloss too: it turns red, and the "
         "rings look dull. "
         "Multi-pass adds the gloss by a pass of its own.",
         {{"render scenes/rings_plain.toml --renderer hardware -o @a.png", {{"a.png", "(a) no map"}}},
          {"render scenes/rings.toml --renderer hardware -o @b.png", {{"b.png", "(b) one pass: equation 1"}}},
          {"render scenes/rings.toml -o @c.png", {{"c.png", "(c) multi-pass: equation 2"}}}}},
        {"fig4",
         "K3.1 K3.2",
         "Figure 4: components, and their sum",
         "The veins of the marble have a colour of their own, shine less than the ground, and the studio is "
         "reflected at "
         "the same time. Shadows keep diffuse and specular light away, ambient light and reflections not.",
         {{"render scenes/marble.toml -o @marble.png --components @components",
           {{"components/ambient.png", "(a) ambient"},
            {"components/diffuse.png", "(b) diffuse"},
            {"components/specular.png", "(c) specular"},
            {"components/reflection.png", "(d) reflection map"},
            {"marble.png", "(e) the sum, on the background"}}}}},
        {"fig5",
         "K3.5",
         "Figure 5: fog in two steps",
         "Fog in every pass would leave shadows black. So all components are drawn through black fog; then "
         "all objects, "
         "black and without shadows, through fog of its colour, and that is added: what lies in shadow gets "
         "its fog, and "
         "the glass its share.",
         {{"render scenes/fog.toml -o @fog.png --components @components",
           {{"components/ambient.png", "step 1: ambient, in black fog"},
            {"components/diffuse.png", "step 1: diffuse, in black fog"},
            {"components/fog.png", "step 2: black objects in fog of its colour"},
            {"fog.png", "the sum"}}}}},
        {"quality",
         "K3s",
         "Lighting at vertices, and at pixels",
         "The same coarse rings three ways. Multi-pass has the colours of the scan-line renderer but lights "
         "vertices, so "
         "that highlights follow the facets; gw study precision measures how the distance falls with finer "
         "ones.",
         {{"render scenes/coarse_rings.toml --renderer hardware -o @hardware.png",
           {{"hardware.png", "hardware: equation 1"}}},
          {"render scenes/coarse_rings.toml -o @multipass.png",
           {{"multipass.png", "multi-pass: equation 2"}}},
          {"render scenes/coarse_rings.toml --renderer scanline -o @scanline.png",
           {{"scanline.png", "scan-line: equation 3"}}}}},
        {"refraction",
         "K1",
         "Reflection and refraction mapping",
         "Sphere maps of the surroundings, looked up by the reflected ray, and by the refracted one.",
         {{"render scenes/crystal.toml -o @crystal.png --components @components",
           {{"components/reflection.png", "reflection map"},
            {"components/refraction.png", "refraction map"},
            {"crystal.png", "with diffuse and specular light"}}}}},
        {"shadows",
         "K3.2",
         "Shadows both ways",
         "Three lights, each with its shadow: a pixel loses the light that does not reach it. By volumes "
         "counted in the "
         "stencil buffer, and by the Z-buffers of the lights.",
         {{"render scenes/columns.toml --shadow none -o @none.png", {{"none.png", "no shadows"}}},
          {"render scenes/columns.toml --shadow volume -o @volume.png", {{"volume.png", "shadow volumes"}}},
          {"render scenes/columns.toml --shadow map -o @map.png", {{"map.png", "shadow maps"}}}}},
        {"soft",
         "K3.3",
         "Soft shadows",
         "The light moved over a disc, the pictures superposed. The shadow is sharp where the object touches "
         "the floor.",
         {{"render scenes/soft.toml -o @4.png", {{"4.png", "4 positions"}}},
          {"render scenes/soft.toml --samples 16 -o @16.png", {{"16.png", "16 positions"}}},
          {"render scenes/soft.toml --samples 128 -o @128.png", {{"128.png", "128 positions"}}}}},
        {"glare",
         "K3.3",
         "Glare",
         "Self-luminous shapes, superposed moved over a disc, or over the rays of a star.",
         {{"render scenes/glare.toml -o @glare.png", {{"glare.png", "discs and stars around emitters"}}}}},
        {"selective",
         "K3.3",
         "Selective lighting",
         "A warm lamp that lights only the vase, a cold one that lights only the knot; the others stay as "
         "they are, also "
         "where they lie between. First the Z of all shapes, then the lit ones are drawn against it and "
         "added.",
         {{"render scenes/selective.toml -o @selective.png --components @components",
           {{"components/diffuse.png", "diffuse light alone"}, {"selective.png", "the picture"}}}}},
        {"translucency",
         "K3.4",
         "Translucency",
         "Panes that pierce one another, two triangles each. Sorted by centres, the triangles come in one "
         "order, wrong on one side of every crossing; unsorted, without update of Z, in the order of the "
         "file; in layers, every pixel has its own order.",
         {{"render scenes/panes.toml --translucency unsorted -o @unsorted.png",
           {{"unsorted.png", "unsorted: wrong"}}},
          {"render scenes/panes.toml --translucency sorted -o @sorted.png",
           {{"sorted.png", "far to near by their centres"}}},
          {"render scenes/panes.toml --translucency layers -o @layers.png",
           {{"layers.png", "layer by layer: exact"}}}}},
        {"lamps",
         "K3.3",
         "A building with 100 lamps",
         "A hundred point lights with attenuation, twelve of them with shadows, on a machine that knows "
         "eight in one pass: "
         "multi-pass has no limit.",
         {{"render scenes/lamps.toml -o @lamps.png", {{"lamps.png", "100 lamps"}}}},
         Size{800, 600}},
        {"focus",
         "K1",
         "Depth of field",
         "The eye moved over a lens, the pictures superposed.",
         {{"render scenes/focus.toml -o @focus.png --samples 64", {{"focus.png", "sharp in the middle"}}}}},
        {"motion",
         "K1",
         "Motion blur",
         "Objects moved while the shutter is open, with their shadows.",
         {{"render scenes/motion.toml -o @motion.png --samples 64", {{"motion.png", "64 moments"}}}}},
        {"edges",
         "K1 K4a",
         "Anti-aliasing",
         "The picture moved by less than a pixel, and superposed in the accumulation buffer. Pixels "
         "enlarged.",
         {{"render scenes/edges.toml --size 96x72 -o @1.png", {{"1.png", "1 sample"}}},
          {"render scenes/edges.toml --size 96x72 --samples 4 -o @4.png", {{"4.png", "4 samples"}}},
          {"render scenes/edges.toml --size 96x72 --samples 64 -o @64.png", {{"64.png", "64 samples"}}}},
         {}},
        {"convergence",
         "K1 K3.3",
         "The error falls with samples",
         "Against a converged picture: faster than random samples would, as theory says of well spread ones. "
         "docs/precision.md has the plots up to 256 samples, and what rounding does.",
         {{"study convergence --samples 16 -o @plots",
           {{"plots/antialiasing.svg", "edges"}, {"plots/soft_shadow.svg", "a soft shadow"}}}},
         {}},
        {"styles",
         "L1",
         "One object six ways",
         "(a) wireframe, (b) depth cueing, (c) hidden lines removed, (d) shaded, (e) with shadows, (f) with "
         "texture.",
         {{"styles scenes/styles.toml -o @styles.png", {{"styles.png", "(a) to (f), row by row"}}}},
         Size{400, 300}},
        {"cycle",
         "L5",
         "Where sorting fails",
         "Three triangles in a cycle: no order paints them. Splitting one mends it (Newell's algorithm, BSP "
         "trees), and so "
         "does deciding pixel by pixel. All algorithms with their counts are in cycle/all/index.html.",
         {{"hidden scenes/hidden/cycle.toml --compare @all",
           {{"all/painter-centroid.png", "painter's algorithm by centroids"},
            {"all/painter-centroid_difference.png", "its wrong pixels, in red"},
            {"all/newell.png", "Newell: one triangle split"},
            {"all/z-buffer.png", "Z-buffer"}}}},
         Size{320, 240}},
        {"cornell",
         "K3.3",
         "The Cornell box, by passes",
         "From its published measurements; a soft shadow from the lamp, and ambient light where radiosity "
         "will compute it.",
         {{"render scenes/cornell.toml -o @cornell.png", {{"cornell.png", "direct light and a constant"}}}},
         Size{480, 480}},
        {"radiosity",
         "F2.2",
         "The Cornell box, by radiosity",
         "Hemicubes drawn by the machine, light kept in pixmaps. After 120 shots, and from another view "
         "without solving again.",
         {{"radiosity scenes/radiosity/cornell.toml -o @box --shots 120 --gamma 2.2 --size 480x480 "
           "--view 278,273,-800/278,273,0 --view 100,450,-300/330,150,300",
           {{"box/picture_1.png", "the published camera"},
            {"box/picture_2.png", "from the upper right"},
            {"box/convergence.svg", "what is still unshot"}}}},
         {}},
        {"oversampling",
         "F2.2o",
         "Texels that a coarse ID buffer misses",
         "Figure 3 of the paper: hemicubes of 32 pixels. Where a pixel covers several texels, most of them "
         "get "
         "no energy; divided virtually, all of them do.",
         {{"radiosity scenes/radiosity/cornell.toml -o @missed --shots 4 --hemicube 32 --parts 1 --gamma 2.2 "
           "--size 480x480",
           {{"missed/picture.png", "(a) a pixel is one texel"}}},
          {"radiosity scenes/radiosity/cornell.toml -o @oversampled --shots 4 --hemicube 32 --gamma 2.2 "
           "--size 480x480",
           {{"oversampled/picture.png", "(b) with oversampling"}}}},
         {}},
        {"strips",
         "F2.3",
         "Textures and triangle strips",
         "Figure 4 of the paper: the same pixmaps as textures, and as Gouraud-shaded strips at their "
         "resolution.",
         {{"radiosity scenes/radiosity/room.toml -o @room --shots 12 --texels 4 --hemicube 32 --exposure -1 "
           "--gamma 2.2 --display both --size 480x480",
           {{"room/picture_texture.png", "as textures"},
            {"room/picture_strips.png", "as strips"},
            {"room/picture_difference.png", "sixteen times their difference"}}}},
         {}},
        {"fig9_maps",
         "K4f",
         "The scene of Figure 9, with maps",
         "444 matte and 77,184 glossy polygons; the studio is a map.",
         {{"render scenes/fig9.toml --reflections maps -o @fig9.png", {{"fig9.png", "reflection maps"}}}}},
        {"fig9",
         "K4 K4i K4f",
         "Figure 9: reflections traced from an item buffer",
         "The same scene by equation 5: what the glossy polygons reflect is traced, to the second ray, from "
         "the polygons that the item buffer names; everything else is passes. Beside it the ordinary ray "
         "tracer, which traces all.",
         {{"render scenes/fig9.toml -o @fig9.png", {{"fig9.png", "item buffer: equation 5"}}},
          {"render scenes/fig9.toml --renderer raytrace -o @rays.png",
           {{"rays.png", "ordinary ray tracing"}}}}},
        {"fig7_fig8",
         "K4a",
         "Figures 7 and 8: polygons smaller than a pixel",
         "Needles of a sixth of a pixel reflect a bright wall. One item buffer finds them where a pixel's "
         "centre happens to lie in one; adaptive sampling casts 64 rays where it sees a border, but only at "
         "polygons that it has seen; 64 item buffers, moved by less than a pixel, find them everywhere, in "
         "proportion to their area, in a simple mean or one by weights.",
         {{"render scenes/needles.toml -o @one.png", {{"one.png", "one item buffer"}}},
          {"render scenes/needles.toml --renderer adaptive --samples 64 -o @adaptive.png",
           {{"adaptive.png", "one, sampled adaptively"}}},
          {"render scenes/needles.toml --samples 64 -o @many.png", {{"many.png", "64, averaged"}}},
          {"render scenes/needles.toml --samples 64 --averaging weighted -o @weighted.png",
           {{"weighted.png", "64, by integer weights"}}}},
         Size{320, 240}},
        {"water",
         "K4 L9",
         "A glass of water",
         "Drawn as opaque, its transmission traced: bent at every surface, totally reflected below the "
         "water's. Up to ten rays in a path.",
         {{"render scenes/water.toml --depth 10 -o @water.png", {{"water.png", "ten rays"}}},
          {"render scenes/water.toml --depth 3 -o @three.png",
           {{"three.png", "three: paths end in the glass"}}}}},
        {"facing_mirrors",
         "K4 L9",
         "Mirror in mirror",
         "Two mirrors face to face; every further ray shows one more of the other.",
         {{"render scenes/facing_mirrors.toml --depth 16 -o @mirrors.png", {{"mirrors.png", "sixteen rays"}}},
          {"render scenes/facing_mirrors.toml -o @second.png", {{"second.png", "to the second ray"}}}}},
    };
    return all;
}

}  // namespace gw::apps
