#include "bench/raytracing/report.h"

#include "image/plot/plot.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::bench {
namespace {

plot::Plot times(const Sweep& sweep, const std::vector<Row>& rows) {
    plot::Plot p{
        .title = "Seconds of a frame, by " + sweep.x_label,
        .caption =
            "Processor seconds of one thread, 640x480, to the second ray; hierarchies built before.",
        .command = "build/release/bin/bench_raytracing --sweep " + sweep.name + " -o DIR",
        .x = {sweep.x_label, sweep.log},
        .y = {"seconds", 10}};
    const auto add = [&](const char* name, auto value) {
        plot::Series series{.name = name};
        for (const Row& row : rows) series.points.emplace_back(row.x, value(row));
        p.series.push_back(std::move(series));
    };
    const double samples = 1;
    add("item buffer, shadow rays", [](const Row& r) { return r.c.item_buffer; });
    add("item buffer, shadow maps", [](const Row& r) { return r.c.item_buffer_maps; });
    add("ordinary ray tracing", [](const Row& r) { return r.c.ray_tracing; });
    add("its rays only",
        [&](const Row& r) { return r.rays.all().ours * (sweep.samples ? r.x : samples); });
    add("Embree, the same rays",
        [&](const Row& r) { return r.rays.all().embree * (sweep.samples ? r.x : samples); });
    return p;
}

constexpr double most_bound = 15;  ///< above it, the plot would show nothing else

bool is_bound_cut(const std::vector<Row>& rows) {
    return std::any_of(rows.begin(), rows.end(), [](const Row& row) {
        return row.c.share > 0 && row.c.bound() > most_bound;
    });
}

plot::Plot gains(const Sweep& sweep, const std::vector<Row>& rows) {
    plot::Plot p{
        .title = "Ordinary ray tracing over item buffer, by " + sweep.x_label,
        .caption =
            "The paper says 3 to 5 [K4f]. The bound assumes exact shadow rays and passes that cost nothing.",
        .command = "build/release/bin/bench_raytracing --sweep " + sweep.name + " -o DIR",
        .x = {sweep.x_label, sweep.log},
        .y = {"times faster", 0}};
    plot::Series rays{.name = "with shadow rays"}, maps{.name = "with shadow maps"},
        bound{
            .name = is_bound_cut(rows) ? fmt::format("1 + 1/g, cut at {}", most_bound) : "1 + 1/g",
            .markers = false,
            .dashed = true},
        low{.name = "the paper's 3", .markers = false, .dashed = true},
        high{.name = "the paper's 5", .markers = false, .dashed = true};
    for (const Row& row : rows) {
        rays.points.emplace_back(row.x, row.c.gain());
        maps.points.emplace_back(row.x, row.c.gain_maps());
        if (row.c.share > 0) bound.points.emplace_back(row.x, std::min(row.c.bound(), most_bound));
        low.points.emplace_back(row.x, 3);
        high.points.emplace_back(row.x, 5);
    }
    p.series = {rays, maps, bound, low, high};
    return p;
}

struct Kind {
    const char* name;
    Race race;
};
std::vector<Kind> kinds(const RayRaces& r) {
    return {{"primary", r.primary},
            {"reflected", r.reflected},
            {"shadow", r.shadow},
            {"build", r.build}};
}

}  // namespace

std::string times_plot(const Sweep& sweep, const std::vector<Row>& rows) {
    return plot::svg(times(sweep, rows));
}
std::string gain_plot(const Sweep& sweep, const std::vector<Row>& rows) {
    return plot::svg(gains(sweep, rows));
}

std::string csv(const std::vector<Row>& rows) {
    std::string text =
        "x,triangles,glossy_share,item_buffer_s,of_this_traced_s,item_buffer_maps_s,maps_drawn_s,ray_tracing_"
        "s,"
        "hierarchy_s,rays_ours_s,rays_embree_s,rays_differ,gain,gain_maps,bound,item_buffer_second_rays,"
        "item_buffer_shadow_rays,ray_tracing_primary,ray_tracing_second_rays,ray_tracing_shadow_rays,"
        "maps_pixels_differ,maps_mean_error,megabytes\n";
    for (const Row& r : rows) {
        const auto &a = r.c.item_buffer_rays, &b = r.c.ray_tracing_rays;
        const Race rays = r.rays.all();
        text += fmt::format(
            "{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{:.3f},{:.3f},{:.3f},"
            "{},{},{},{},{},{:.5f},{:.4f},{}\n",
            r.x, r.c.triangles, r.c.share, r.c.item_buffer, r.c.traced, r.c.item_buffer_maps,
            r.c.maps_drawn, r.c.ray_tracing, r.c.hierarchy, rays.ours, rays.embree, rays.differ,
            r.c.gain(), r.c.gain_maps(), r.c.bound(), a.reflected + a.transmitted, a.shadow,
            b.primary, b.reflected + b.transmitted, b.shadow, r.c.maps_differ, r.c.maps_error,
            r.megabytes);
    }
    return text;
}

std::string heading(const Sweep& sweep) {
    return fmt::format(
        "{}\n{:>9} {:>9} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7} {:>7} {:>6} {:>6}\n",
        sweep.name, "x", "triangles", "g %", "item s", "traced s", "maps s", "rays s", "Embree s",
        "gain", "by maps", "1+1/g", "E/ours", "MB");
}

std::string line(const Row& r) {
    const Race rays = r.rays.all();
    return fmt::format(
        "{:>9} {:>9} {:>6.1f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>7.2f} {:>7.2f} {:>7.2f} "
        "{:>6.2f} {:>6}\n",
        r.x, r.c.triangles, 100 * r.c.share, r.c.item_buffer, r.c.traced, r.c.item_buffer_maps,
        r.c.ray_tracing, rays.embree, r.c.gain(), r.c.gain_maps(), r.c.bound(),
        rays.embree / rays.ours, r.megabytes);
}

std::string crossings(const Sweep& sweep, const std::vector<Row>& rows) {
    std::string text;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double a = rows[i - 1].c.gain() - 1, b = rows[i].c.gain() - 1;
        if ((a < 0) != (b < 0))
            text += fmt::format("  the curves cross at about {:.3g} {}\n",
                                rows[i - 1].x + (rows[i].x - rows[i - 1].x) * a / (a - b),
                                sweep.x_label);
    }
    if (text.empty() && rows.size() > 1)
        text = fmt::format("  the curves do not cross: the item buffer is {} everywhere\n",
                           rows.front().c.gain() > 1 ? "faster" : "slower");
    return text;
}

std::string race_heading() {
    return fmt::format("rays\n{:>9} {:>9} {:>10} {:>9} {:>9} {:>9} {:>9} {:>7} {:>9} {:>7}\n",
                       "scene", "triangles", "kind", "rays", "ours s", "float32 s", "Embree s",
                       "E/ours", "E/float32", "differ");
}

std::string race_lines(const std::string& scene, std::size_t triangles, const RayRaces& races) {
    std::string text;
    for (const Kind& k : kinds(races))
        text += fmt::format(
            "{:>9} {:>9} {:>10} {:>9} {:>9.4f} {:>9.4f} {:>9.4f} {:>7.2f} {:>9.2f} {:>7}\n", scene,
            triangles, k.name, k.race.rays, k.race.ours, k.race.float32, k.race.embree,
            k.race.embree / k.race.ours, k.race.embree / k.race.float32, k.race.differ);
    return text;
}

std::string race_csv(const std::string& scene, std::size_t triangles, const RayRaces& races) {
    std::string text;
    for (const Kind& k : kinds(races))
        text += fmt::format("{},{},{},{},{:.5f},{:.5f},{:.5f},{}\n", scene, triangles, k.name,
                            k.race.rays, k.race.ours, k.race.float32, k.race.embree, k.race.differ);
    return text;
}

}  // namespace gw::bench
