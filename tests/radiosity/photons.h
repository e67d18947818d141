// A light tracer [F]: photons from the emitters, by the ray tracer's intersections. Finds the mean
// irradiance of every facet, with its standard error. Knows no form factors.
#pragma once

#include "gw/base/elementary.h"
#include "gw/base/parallel.h"
#include "radiosity/model/pixmap_model.h"
#include "raytrace/tracer/world.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gw::radiosity {

/// The mean over a facet; all channels together.
struct Irradiance {
    double mean = 0, standard_error = 0;
};

class Photons {
public:
    /// Every facet is whole and of one material, as those of given or automatic plane figures are.
    Photons(const scene::Scene& scene, const PixmapModel& model) : model_(model), world_(scene) {
        for (std::uint32_t t = 0; t < world_.triangles().size(); ++t)
            facets_.push_back(facet_of(t));
        for (const Facet& facet : model.facets) areas_.push_back(area_of(facet));
        double sum = 0;
        for (std::uint32_t t = 0; t < facets_.size(); ++t) {
            const dvec3 E = figure_of(facets_[t]).E;
            sum += (E.x + E.y + E.z) * area_of(t);
            powers_.push_back(sum);
        }
    }

    /// In batches of `count` photons each, a stream of random numbers for each batch.
    std::vector<Irradiance> trace(std::size_t batches, std::size_t count) const {
        std::vector<std::vector<double>> found(batches);
        parallel_for(batches, 0, [&](std::size_t b, int) {
            found[b].assign(model_.facets.size(), 0.0);
            std::mt19937_64 random(b + 1);
            for (std::size_t i = 0; i < count; ++i) follow(random, found[b]);
        });
        std::vector<Irradiance> all;
        for (std::size_t f = 0; f < model_.facets.size(); ++f) {
            double sum = 0, squares = 0;
            for (const auto& batch : found) {
                const double value = batch[f] * powers_.back() / (double(count) * areas_[f]);
                sum += value;
                squares += value * value;
            }
            const auto n = double(batches);
            const double mean = sum / n;
            all.push_back({mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1))});
        }
        return all;
    }

private:
    static double uniform(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }

    const Figure& figure_of(std::uint32_t facet) const {
        return model_.figures[model_.facets[facet].figure];
    }

    double area_of(std::uint32_t triangle) const {
        const auto c = world_.triangles().corners(triangle);
        return length(cross3(c[1] - c[0], c[2] - c[0])) / 2;
    }
    static double area_of(const Facet& facet) {
        double sum = 0;
        for (const Triangle2& t : facet.triangles) {
            const dvec2 a = t[1] - t[0], b = t[2] - t[0];
            sum += std::abs(a.x * b.y - a.y * b.x) / 2 * facet.texel_area;
        }
        return sum;
    }

    std::uint32_t facet_of(std::uint32_t triangle) const {
        const auto c = world_.triangles().corners(triangle);
        const dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
        std::uint32_t best = 0;
        double least = 1e300;
        for (std::uint32_t f = 0; f < model_.facets.size(); ++f) {
            const Facet& facet = model_.facets[f];
            if (model_.figures[facet.figure].object != world_.triangles().object_of(triangle))
                continue;
            const dvec3 n = cross3(c[1] - c[0], c[2] - c[0]);
            if (dot3(n, facet.normal) < 0.99 * length(n)) continue;
            const double off = std::abs(dot3(facet.normal, middle) - facet.offset);
            if (off < least) least = off, best = f;
        }
        return best;
    }

    /// Lambert's: as much light in equal parts of the disc below.
    static dvec3 direction(std::mt19937_64& random, const dvec3& normal) {
        const double r2 = uniform(random), turn = 360 * uniform(random), r = std::sqrt(r2);
        const dvec3 any = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
        dvec3 a = cross3(any, normal);
        a /= length(a);
        return r * cos_degrees(turn) * a + r * sin_degrees(turn) * cross3(normal, a) +
               std::sqrt(1 - r2) * normal;
    }

    /// `received`: by facet, in parts of the emitted power.
    void follow(std::mt19937_64& random, std::vector<double>& received) const {
        const auto chosen =
            std::upper_bound(powers_.begin(), powers_.end(), uniform(random) * powers_.back());
        auto triangle =
            std::uint32_t(std::min(std::size_t(chosen - powers_.begin()), powers_.size() - 1));
        const auto c = world_.triangles().corners(triangle);
        const double root = std::sqrt(uniform(random)), part = uniform(random);
        dvec3 p = (1 - root) * c[0] + root * (1 - part) * c[1] + root * part * c[2];
        dvec3 light = figure_of(facets_[triangle]).E;
        light /= light.x + light.y + light.z;
        for (;;) {
            const dvec3 way = direction(random, model_.facets[facets_[triangle]].normal);
            const auto hit = world_.nearest({p, way}, 1e30, triangle);
            if (!hit) return;
            const std::uint32_t facet = facets_[hit->triangle];
            if (dot3(way, model_.facets[facet].normal) >= 0) return;  // its back
            const double before = light.x + light.y + light.z;
            received[facet] += before;
            light *= figure_of(facet).rho;
            const double left = (light.x + light.y + light.z) / before;
            if (uniform(random) >= left) return;
            light /= left;
            p = hit->p;
            triangle = hit->triangle;
        }
    }

    const PixmapModel& model_;
    raytrace::World world_;
    std::vector<std::uint32_t> facets_;  ///< by triangle
    std::vector<double> areas_;          ///< by facet
    std::vector<double> powers_;         ///< of the triangles up to each
};

}  // namespace gw::radiosity
