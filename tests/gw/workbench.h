// A small machine for tests: window coordinates in, planes out. Each list runs on both machines.
// They are compared wherever a test looks and when the workbench is destroyed.
// Does not know expected values: each test has its own.
#pragma once

#include "gw/error.h"
#include "gw/machine.h"

#include <gtest/gtest.h>

#include <utility>

namespace gw::test {

/// Object coordinates are window pixels and units of the depth plane: exact for dyadic coordinates
/// of few bits in a window whose sides are powers of two.
inline dmat4 window_projection(const Profile& profile, int width, int height) {
    dmat4 m{1};
    m[0][0] = 2.0 / width;
    m[1][1] = 2.0 / height;
    m[2][2] = 2.0 / double((std::uint64_t{1} << profile.depth_bits) - 1);
    m[3] = {-1, -1, -1, 1};
    return m;
}

inline MeshData mesh_data(Primitive primitive, std::vector<vec3> positions,
                          std::vector<vec4> colors = {}) {
    MeshData data{.primitive = primitive, .positions = std::move(positions)};
    data.colors = std::move(colors);
    return data;
}

/// The message of the Error that `action` throws; empty if it throws none.
template <typename Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// A pair of machines and the state of the next draw.
class Workbench {
public:
    explicit Workbench(const Profile& profile = vgx(), int width = 64, int height = 64)
        : Workbench(make_reference(profile, width, height),
                    make_fast(profile, width, height, {.threads = 1})) {}
    /// Two new machines of one profile and window.
    Workbench(std::unique_ptr<Machine> reference, std::unique_ptr<Machine> fast)
        : machine_(std::move(reference)), fast_(std::move(fast)) {
        const Planes& planes = machine_->planes();
        state.projection = window_projection(profile(), planes.width, planes.height);
    }
    ~Workbench() { compare(); }
    Workbench(const Workbench&) = delete;
    Workbench& operator=(const Workbench&) = delete;

    State state;

    void run(Command command) {
        CommandList list;
        list.add(SetState{state});
        list.add(std::move(command));
        run(list);
    }
    /// Throws Error if the machines refuse the list, which they must do with one message.
    void run(const CommandList& list) {
        compared_ = false;
        const std::string refusal = error_of([&] { machine_->execute(list); });
        EXPECT_EQ(error_of([&] { fast_->execute(list); }), refusal) << "the machines differ";
        if (!refusal.empty()) throw Error(refusal);
    }
    void draw(Draw command) { run(std::move(command)); }
    void draw(MeshData data) { draw(Draw{.mesh = make_mesh(std::move(data))}); }
    void draw(Primitive primitive, std::vector<vec3> positions, std::vector<vec4> colors = {}) {
        draw(mesh_data(primitive, std::move(positions), std::move(colors)));
    }
    void clear(PlaneMask planes = all_planes, vec4 color = vec4(0), double depth = 1,
               int stencil = 0) {
        run(Clear{planes, color, depth, stencil});
    }
    /// Pixels of one colour, as a fragment each.
    void write(const Rect& rect, const Rgba& color, std::uint32_t depth = 0) {
        const auto size = std::size_t(rect.width) * std::size_t(rect.height);
        run(WritePixels{rect, Plane::Color, std::vector<Rgba>(size, color), {}, depth});
    }

    /// Compares the machines, unless nothing ran since the last time.
    void compare() {
        if (compared_) return;
        compared_ = true;
        EXPECT_TRUE(fast_->planes() == machine_->planes()) << "the machines' planes differ";
        EXPECT_TRUE(fast_->passes() == machine_->passes()) << "the machines' counters differ";
        EXPECT_TRUE(fast_->readbacks() == machine_->readbacks())
            << "the machines' readbacks differ";
    }
    const Planes& planes() {
        compare();
        return machine_->planes();
    }
    Rgba color(int x, int y) { return planes().color[planes().index(x, y)]; }
    Rgba back(int x, int y) { return planes().back[planes().index(x, y)]; }
    std::uint32_t depth(int x, int y) { return planes().depth[planes().index(x, y)]; }
    int stencil(int x, int y) { return planes().stencil[planes().index(x, y)]; }
    std::array<std::int32_t, 4> accum(int x, int y) { return planes().accum[planes().index(x, y)]; }
    /// Of everything since construction or the last call.
    Counters take_counters() {
        compare();
        Counters sum;
        for (const PassReport& pass : machine_->passes()) sum += pass.counters;
        machine_->reset_passes();
        fast_->reset_passes();
        return sum;
    }
    const std::map<std::uint32_t, Readback>& readbacks() {
        compare();
        return machine_->readbacks();
    }
    Machine& machine() { return *machine_; }
    const Profile& profile() const { return machine_->profile(); }

private:
    std::unique_ptr<Machine> machine_, fast_;
    bool compared_ = true;
};

}  // namespace gw::test
