// Claims: Roberts', Appel's and the floating-horizon algorithm show a point of a line exactly where
// a count of the triangles before it, made here from nothing but the snapped corners, is 0: Appel's
// to the rounding of a double, the others (which decide before the snap) but for points within two
// sub-pixel units of a change. On ten families of random scenes, solids, a teapot, hills; all sides
// are there; and their pictures are the Z-buffer's hidden-line picture but for a few pixels in a
// hundred.
#include "gw/error.h"
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/lines/horizon.h"
#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/run/read_step.h"
#include "test_paths.h"
#include "tests/hiddensurface/families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {
namespace {

/// Counts what is before a point, triangle by triangle.
class Oracle {
public:
    /// Points nearer than `reach` (grid units) to an outline or to the depth of a triangle are
    /// unclear.
    Oracle(const Input& input, double reach) : reach_(reach) {
        for (const Polygon& polygon : input.polygons)
            for (const WindowTriangle& t : polygon.triangles) {
                std::array<dvec3, 3> p;
                for (std::size_t k = 0; k < 3; ++k) p[k] = to_dvec3(t.corners[k]);
                if (area(p[0], p[1], p[2]) < 0) std::swap(p[1], p[2]);
                triangles_.push_back(p);
            }
    }

    enum class Answer { Visible, Hidden, Unclear };
    /// At t of the line. A triangle does not hide its own sides.
    Answer at(const Line& line, double along) const {
        const dvec3 p = line.a + along * (line.b - line.a);
        bool unclear = false;
        for (const auto& t : triangles_) {
            const int hides = before(t, p);
            if (hides < 0 || (has_corner(t, line.a) && has_corner(t, line.b))) continue;
            if (hides > 0) return Answer::Hidden;
            unclear = unclear || hides == 0;
        }
        return unclear ? Answer::Unclear : Answer::Visible;
    }

private:
    bool has_corner(const std::array<dvec3, 3>& t, const dvec3& p) const {
        return std::any_of(t.begin(), t.end(), [&](const dvec3& q) {
            return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) <= std::max(reach_, 0.01) &&
                   std::abs(p.z - q.z) <= 2;
        });
    }
    static double area(const dvec3& p, const dvec3& q, const dvec3& r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    /// 1: hides the point, -1: does not, 0: too near to tell.
    int before(const std::array<dvec3, 3>& t, const dvec3& p) const {
        if (p.x + reach_ < std::min({t[0].x, t[1].x, t[2].x}) ||
            p.x - reach_ > std::max({t[0].x, t[1].x, t[2].x}) ||
            p.y + reach_ < std::min({t[0].y, t[1].y, t[2].y}) ||
            p.y - reach_ > std::max({t[0].y, t[1].y, t[2].y}))
            return -1;
        double inside = 1e30;
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 &a = t[k], &b = t[(k + 1) % 3];
            inside = std::min(inside, area(a, b, p) / std::hypot(b.x - a.x, b.y - a.y));
        }
        if (inside < -reach_) return -1;
        const dvec3 n = face_normal(t[0], t[1], t[2]);
        const double dx = -n.x / n.z, dy = -n.y / n.z;
        const double z = t[0].z + dx * (p.x - t[0].x) + dy * (p.y - t[0].y);
        const double margin = reach_ * (1 + std::abs(dx) + std::abs(dy)) + 1e-9 * std::abs(p.z);
        if (p.z - z < -margin) return -1;
        return p.z - z > margin && inside > reach_ ? 1 : 0;
    }

    double reach_;
    std::vector<std::array<dvec3, 3>> triangles_;
};

struct Agreement {
    int points = 0, unclear = 0, wrong = 0, visible = 0;
};

bool shows(const Line& line, double t) {
    return std::any_of(line.visible.begin(), line.visible.end(),
                       [t](const Part& part) { return part.first <= t && t <= part.second; });
}

bool in_window(const Input& input, const dvec3& p) {
    const double unit = double(1 << input.subpixel_bits());
    return p.x > 0 && p.y > 0 && p.x < unit * input.view.width && p.y < unit * input.view.height;
}

Agreement agreement(const Input& input, const std::vector<Line>& lines, double reach) {
    const Oracle oracle(input, reach);
    Agreement sum;
    const int samples = lines.size() > 2000 ? 1 : 7;
    for (const Line& line : lines)
        for (int k = 0; k < samples; ++k) {
            const double t = (k + 0.37) / samples;
            const dvec3 p = line.a + t * (line.b - line.a);
            if (!in_window(input, p)) continue;
            const Oracle::Answer answer = oracle.at(line, t);
            sum.points += 1;
            sum.unclear += answer == Oracle::Answer::Unclear ? 1 : 0;
            sum.visible += answer == Oracle::Answer::Visible ? 1 : 0;
            sum.wrong += answer != Oracle::Answer::Unclear &&
                         shows(line, t) != (answer == Oracle::Answer::Visible);
        }
    return sum;
}

LineOutput lines_of(const Input& input, const std::string& name) {
    StepLog none;
    return line_algorithm_named(name)->run(input, none);
}

double length(const Line& line) { return std::hypot(line.b.x - line.a.x, line.b.y - line.a.y); }

/// Of what is visible, in grid units.
double length(const std::vector<Line>& lines) {
    double sum = 0;
    for (const Line& line : lines)
        for (const auto& [from, to] : line.visible) sum += (to - from) * length(line);
    return sum;
}

double whole_length(const std::vector<Line>& lines) {
    double sum = 0;
    for (const Line& line : lines) sum += length(line);
    return sum;
}

/// The claim: `reach` as the oracle's, `unclear` at most so many in a hundred points.
void expect_agreement(const Input& input, const std::string& name, double reach, int unclear,
                      const std::string& where) {
    const LineOutput output = lines_of(input, name);
    const Agreement a = agreement(input, output.lines, reach);
    EXPECT_EQ(a.wrong, 0) << name << ", " << where << ", of " << a.points;
    EXPECT_LE(a.unclear * 100, unclear * a.points) << name << ", " << where << ", of " << a.points;
    if (a.points > 0) {  // of layers over the whole window no side is in it
        EXPECT_GT(a.visible, 0) << name << ", " << where;
    }
}

scene::Scene convex_solids(std::uint32_t seed) {
    Random random(seed);
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i < 6; ++i) {
        const vec3 c = random_point(random, 1.4), u = random_point(random, 0.8),
                   v = random_point(random, 0.8), w = random_point(random, 0.8);
        const auto at = [&](int x, int y, int z) {
            return c + float(x) * u + float(y) * v + float(z) * w;
        };
        const auto first = std::uint32_t(data.positions.size());
        for (int k = 0; k < 8; ++k) data.positions.push_back(at(k & 1, k >> 1 & 1, k >> 2));
        for (const std::uint32_t k :
             {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5})
            data.indices.push_back(first + k);
    }
    return polygon_scene(std::move(data));
}

scene::Scene hills(std::uint32_t seed, double height_of_eye) {
    Random random(seed);
    constexpr int n = 14;
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k)
            data.positions.push_back(
                vec3(float(i) / 4 - 1.75f, random(-0.4, 0.4), float(k) / 4 - 1.75f));
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t k = 0; k < n; ++k)
            for (const std::uint32_t corner : {0u, 1u, n + 2u, n + 1u})
                data.indices.push_back(i * (n + 1) + k + corner);
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera->eye = {random(-5, 5), height_of_eye, seed % 2 == 0 ? 5 : -4};
    scene.camera->at = {0, 0, 0};
    scene.camera->up = {0.3, 1, 0};  // the camera may be turned
    if (seed % 3 == 0) scene.camera->ortho_height = 4;
    return scene;
}

class LineFamilies : public testing::TestWithParam<std::size_t> {};

}  // namespace

TEST_P(LineFamilies, AreHiddenExactlyByQuantitativeInvisibility) {
    const Family& family = families()[GetParam()];
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Trial trial(family.scene(seed));
        expect_agreement(trial.input, "appel", 1e-6, 20,
                         family.name + (", seed " + std::to_string(seed)));
    }
}

TEST_P(LineFamilies, AreHiddenByRobertsToTheSnap) {
    const Family& family = families()[GetParam()];
    // else lines lie on faces: nothing is clear
    const bool apart = family.snapped_one_in >= 10000;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Trial trial(family.scene(seed), ideal());
        expect_agreement(trial.input, "roberts", 2, apart ? 60 : 100,
                         family.name + (", seed " + std::to_string(seed)));
    }
}

INSTANTIATE_TEST_SUITE_P(All, LineFamilies, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& tested) {
                             std::string name = families()[tested.param].name;
                             std::erase(name, ' ');
                             return name;
                         });

TEST(Lines, OfConvexSolidsAreRightByBothAndRobertsComparesSolids) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Trial trial(convex_solids(seed), ideal());
        expect_agreement(trial.input, "roberts", 2, 30, "solids");
        expect_agreement(trial.input, "appel", 1e-6, 5, "solids");
        const LineOutput roberts = lines_of(trial.input, "roberts"),
                         appel = lines_of(trial.input, "appel");
        EXPECT_EQ(roberts.counts.faces, 6u) << seed;
        EXPECT_EQ(roberts.counts.lines, 6u * 12) << seed;
        EXPECT_NEAR(whole_length(roberts.lines), whole_length(appel.lines),
                    1e-3 * whole_length(appel.lines))
            << seed;
        EXPECT_NEAR(length(roberts.lines), length(appel.lines), 0.005 * length(appel.lines))
            << seed;
    }
}

// One line of each connected figure is counted against all faces, the others by their crossings.
TEST(Lines, CarryTheNumberFromCornerToCorner) {
    Trial trial(convex_solids(3));
    const LineOutput appel = lines_of(trial.input, "appel");
    EXPECT_EQ(appel.counts.starts, 6u);
    EXPECT_EQ(appel.counts.lines, 6u * 12);
}

// The solids go through each other, and stand before each other.
TEST(Lines, LogEveryChangeOfTheNumber) {
    std::size_t pierced = 0, changes = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        Trial trial(convex_solids(seed));
        StepLog log(Level::Span);
        const LineOutput output = line_algorithm_named("appel")->run(trial.input, log);
        std::size_t drawn = 0;
        for (const Step& step : log.steps()) {
            drawn += step.action == Action::Draw ? 1 : 0;
            changes += step.level == Level::Span ? 1 : 0;
            pierced += step.test == "pierced" ? 1 : 0;
            const std::string line = to_json(step, 1, grid_of(trial.input));
            EXPECT_EQ(to_json(step_of_line(line, grid_of(trial.input)), 1, grid_of(trial.input)),
                      line);
        }
        EXPECT_EQ(drawn, output.lines.size());
    }
    EXPECT_GT(pierced, 0u);
    EXPECT_GT(changes, pierced);
}

TEST(Lines, OfCurvedSurfacesAreRight) {
    for (const char* name : {"solids", "cycle", "pierce", "two_undecidable"}) {
        Trial trial(case_scene(name), ideal());
        expect_agreement(trial.input, "appel", 1e-6, 20, name);
        expect_agreement(trial.input, "roberts", 2, 40, name);
    }
    scene::Scene scene = scene::read_scene(GW_SOURCE_DIR "/scenes/styles.toml").scene;
    scene::add_defaults(scene, 320, 240);
    Trial trial(std::move(scene), ideal(), 320, 240);
    expect_agreement(trial.input, "appel", 1e-6, 20, "teapot");
    expect_agreement(trial.input, "roberts", 2, 60, "teapot");
}

TEST(Lines, OfHillsAreRightByTheFloatingHorizon) {
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        Trial trial(hills(seed, seed % 4 == 0 ? -1.5 : 2.0), ideal());
        const std::string where = "hills, seed " + std::to_string(seed);
        expect_agreement(trial.input, "floating-horizon", 2, 30, where);
        const LineOutput horizon = lines_of(trial.input, "floating-horizon"),
                         appel = lines_of(trial.input, "appel");
        EXPECT_EQ(horizon.lines.size(), 2u * 14 * 15) << seed;
        EXPECT_NEAR(length(horizon.lines), length(appel.lines), 0.01 * length(appel.lines)) << seed;
    }
}

TEST(Lines, FloatingHorizonHidesNothingAtCommonCorners) {
    const Trial trial(case_scene("hills"), vgx(), 320, 240);
    std::size_t whole = 0;
    for (const Line& line : lines_of(trial.input, "floating-horizon").lines) {
        whole += line.visible == std::vector<Part>{{0, 1}};
        double end = 0;
        for (const auto& [from, to] : line.visible) {
            EXPECT_TRUE(from == end || from - end > 1e-5) << line.id;
            end = to;
        }
        EXPECT_TRUE(end == 1 || end < 1 - 1e-5) << line.id;
    }
    EXPECT_GT(whole, 1700u);  // 864, when 702 lines hid a billionth of themselves
}

TEST(Lines, FloatingHorizonRefusesWhatIsNoHeightField) {
    const auto message = [](scene::Scene scene) -> std::string {
        Trial trial(std::move(scene));
        try {
            lines_of(trial.input, "floating-horizon");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message(case_scene("solids")).find("expected a height field"), std::string::npos);
    scene::Scene above = hills(1, 2);
    above.camera->eye = {0.1, 6, 0.1};
    EXPECT_NE(message(above).find("above the field"), std::string::npos);
}

TEST(Lines, AreNearlyTheZBuffersPicture) {
    StepLog none;
    scene::Scene teapot = scene::read_scene(GW_SOURCE_DIR "/scenes/styles.toml").scene;
    scene::add_defaults(teapot, 320, 240);
    for (auto [scene, names] :
         {std::pair(convex_solids(5), std::vector<std::string>{"roberts", "appel"}),
          std::pair(std::move(teapot), std::vector<std::string>{"roberts", "appel"}),
          std::pair(case_scene("hills"),
                    std::vector<std::string>{"roberts", "appel", "floating-horizon"})}) {
        Trial trial(std::move(scene), reality(), 320, 240);
        for (const std::string& name : names) {
            const LineResult result =
                run_on(*trial.machine, *line_algorithm_named(name), trial.input, none);
            EXPECT_GT(result.counts.pixels, 500u) << name;
            EXPECT_LE(result.counts.missing * 100, 3 * result.counts.pixels) << name;
            EXPECT_LE(result.counts.extra * 100, 3 * result.counts.pixels) << name;
        }
    }
}

TEST(Horizon, KeepsTheHighestOfEachPlace) {
    LineCounts counts;
    Horizon horizon(true);
    EXPECT_EQ(horizon.beyond({0, 0}, {4, 0}, counts), (std::vector<Part>{{0, 1}}));
    horizon.raise({0, 0}, {4, 0});
    // outside on the left, then above from 1
    const auto parts = horizon.beyond({-1, -1}, {3, 1}, counts);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(parts[0].second, 0.25, 1e-9);
    EXPECT_NEAR(parts[1].first, 0.5, 1e-9);
    horizon.raise({-1, -1}, {3, 1});
    EXPECT_NEAR(*horizon.at(2), 0.5, 1e-9);
    EXPECT_NEAR(*horizon.at(0.5), 0, 1e-9);
    EXPECT_FALSE(horizon.at(5).has_value());
}

TEST(RestOf, IsWhatNoPartCovers) {
    EXPECT_EQ(rest_of({{0.5, 0.75}, {0, 0.25}, {0.6, 0.7}}),
              (std::vector<Part>{{0.25, 0.5}, {0.75, 1}}));
    EXPECT_EQ(rest_of({}), (std::vector<Part>{{0, 1}}));
    EXPECT_TRUE(rest_of({{0, 1}}).empty());
}

}  // namespace gw::hiddensurface
