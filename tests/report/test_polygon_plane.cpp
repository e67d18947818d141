// The plane of polygons tells apart what stands in different places.
#include "gw/reference/make.h"
#include "inspect/report/pass_observer.h"

#include <gtest/gtest.h>

namespace gw::report {
namespace {

dmat4 at(double x) {
    dmat4 m(1);
    m[3].x = x;
    return m;
}

/// Two polygons over a column of a window of 4 x 1 pixels.
MeshRef column() {
    return make_mesh({.positions = {{-1, -1, 0}, {-0.5f, -1, 0}, {-0.5f, 1, 0}, {-1, 1, 0}},
                      .indices = {0, 1, 2, 0, 2, 3},
                      .polygon_ids = {0, 1}});
}

std::vector<std::uint32_t> ids_after(const std::vector<Draw>& draws) {
    inspect::Recording recording{.width = 4, .height = 1};
    CommandList list;
    list.add(BeginPass{.name = "pass"});
    list.add(Clear{.planes = all_planes});
    State state;
    state.viewport = {0, 0, 4, 1};
    list.add(SetState{state});
    for (const Draw& draw : draws) list.add(draw);
    recording.lists.push_back(list);
    PassObserver observer(recording, false);
    const auto machine = reference::make(recording.profile, 4, 1, &observer);
    inspect::Player(recording, *machine).play();
    return observer.polygons().ids();
}

}  // namespace

TEST(PolygonPlane, TellsObjectsApartThatShareAMesh) {
    const MeshRef mesh = column();
    const auto ids = ids_after({{.mesh = mesh, .eye_from_object = at(0)},
                                {.mesh = mesh, .eye_from_object = at(1)},
                                {.mesh = column(), .eye_from_object = at(1.5)}});
    EXPECT_EQ(ids[1], 0u);
    EXPECT_TRUE(ids[0] == 1 || ids[0] == 2) << ids[0];
    EXPECT_EQ(ids[2], ids[0] + 2) << "the same polygon of the second object";
    EXPECT_EQ(ids[3], ids[0] + 4);
}

TEST(PolygonPlane, KnowsAnObjectAgainInALaterDraw) {
    const MeshRef mesh = column();
    const auto once = ids_after({{.mesh = mesh}, {.mesh = mesh, .eye_from_object = at(1)}});
    EXPECT_EQ(ids_after({{.mesh = mesh},
                         {.mesh = mesh, .eye_from_object = at(1)},
                         {.mesh = mesh},
                         {.mesh = mesh, .eye_from_object = at(1)}}),
              once);
}

}  // namespace gw::report
